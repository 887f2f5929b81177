// What the soil tests read out of curves that are known exactly, and the table that joins them to [target].
#include "soil_tests/sand_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/case_keys.hpp"
#include "soil_tests/world.hpp"

namespace ifedem {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// σ1/σ3 rises linearly to the peak at 5 % and is less from there on; the volume grows from there at `dilation`.
BiaxialCurve make_biaxial(double peak, double end, double dilation) {
    BiaxialCurve c;
    c.lateral_Pa = 1e4;
    for (int k = 1; k <= 300; ++k) {
        const double strain = 5e-4 * k;
        c.strain.push_back(strain);
        c.ratio.push_back(strain <= 0.05 ? 1 + (peak - 1) * strain / 0.05 : strain <= 0.06 ? peak : end);
        c.volumetric.push_back(-dilation * strain);
    }
    return c;
}

TEST(Biaxial, AnglesModulusAndDilatancyOfAKnownCurve) {
    const double peak = std::pow(std::tan(65 * degree), 2), end = std::pow(std::tan(60 * degree), 2);  // 40°, 30°
    const Strength s = read_strength(make_biaxial(peak, end, 0.5));
    EXPECT_NEAR(s.peak_deg, 40, 1e-9);
    EXPECT_NEAR(s.end_deg, 30, 1e-9);
    EXPECT_NEAR(s.dilatancy_deg, std::asin(0.5 / 2.5) / degree, 1e-9);
    EXPECT_NEAR(s.secant_Pa, 1e4 * (peak - 1) / 0.05, 1e-6 * s.secant_Pa);
}

TEST(ShearBox, CohesionAngleAndDisplacementComeBack) {
    SandTests tests;
    const double normal[] = {5e3, 1e4, 2e4};
    for (std::size_t k = 0; k < 3; ++k) {
        tests.box[k].normal_Pa = normal[k];
        for (int n = 0; n <= 2000; ++n) {
            const double j = 1e-5 * n;
            tests.box[k].displacement_m.push_back(j);
            tests.box[k].shear_Pa.push_back((500 + std::tan(35 * degree) * normal[k]) * (1 - std::exp(-j / 1e-3)));
        }
    }
    const ShearStrength s = read_shear_strength(tests);
    EXPECT_NEAR(s.cohesion_Pa, 500, 5);
    EXPECT_NEAR(std::atan(s.friction) / degree, 35, 0.1);
    EXPECT_NEAR(s.displacement_m, 1e-3, 1e-5);
}

TEST(Plate, PowerLawComesBackAndWhereItMetNothingIsLeftOut) {
    PlatePress plate;
    for (int k = 1; k <= 100; ++k) {
        const double z = 1e-4 * k;
        plate.sinkage_m.push_back(z);
        plate.pressure_Pa.push_back(k < 10 ? 1e5 : k % 7 == 0 ? 0.0 : 3e6 * std::pow(z, 1.2));
    }
    const PressureSinkage p = read_pressure_sinkage(plate);
    EXPECT_NEAR(p.exponent, 1.2, 1e-9);
    EXPECT_NEAR(p.modulus_Pa_mn, 3e6, 1);
    std::ranges::fill(plate.pressure_Pa, 0.0);
    EXPECT_TRUE(std::isnan(read_pressure_sinkage(plate).exponent));
}

/// "friction_angle_deg": the name and a unit.
bool is_target_key_of(const SandQuantity& q, std::string_view leaf) {
    if (!leaf.starts_with(q.name)) return false;
    const std::string_view unit = leaf.substr(q.name.size());
    return unit == "" || unit == "_deg" || unit == "_Pa" || unit == "_m";
}

TEST(Quantities, EachHasItsKeyInTarget) {
    std::size_t keys = 0;
    for (const Key& key : case_keys()) {
        if (table_of(key.name) != "target") continue;
        ++keys;
        const auto q = std::ranges::find_if(
            sand_quantities(), [&](const SandQuantity& s) { return is_target_key_of(s, leaf_of(key.name)); });
        ASSERT_NE(q, sand_quantities().end()) << key.name;
        Case c;
        *std::get<double*>(key.slot(c)) = 0.25;
        EXPECT_EQ(c.target.*q->target, 0.25) << key.name;
    }
    EXPECT_EQ(keys, sand_quantities().size());
}

TEST(Quantities, AreShownInTheirUnits) {
    for (const SandQuantity& q : sand_quantities()) {
        const double expected = q.units == "MPa" ? 1e-6 : q.units == "kPa" ? 1e-3 : q.units == "mm" ? 1e3 : 1;
        EXPECT_EQ(q.per_si, expected) << q.name;
    }
}

TEST(SandOfACase, IsItsDiscsContactsStepAndGravityAlone) {
    Case c;
    c.gravity_m_s2 = 3.71, c.time_step_s = 2e-5;
    c.soil.radii_m = {0.001, 0.004}, c.soil.radii_shares = {1, 1};
    c.contact.friction_soil = 0.3;
    c.bed.seed = 5, c.bed.disc_count = 7;
    c.integrator = Integrator::modified_euler_one;
    const Case sand = soil_of(c);
    EXPECT_EQ(list_changes(Case{}, sand).size(), 6U);  // the lines above but the last two
    EXPECT_EQ(sand.bed.seed, 5);
    EXPECT_DOUBLE_EQ(middle_radius_m(sand), 0.0025);
}

TEST(SandOfACase, FallsLastLongerForLargerGrainsAndLessGravity) {
    Case c;
    EXPECT_DOUBLE_EQ(duration_of_fall_s(c, 0.5), 0.5);
    c.gravity_m_s2 = 9.81 / 4;
    EXPECT_DOUBLE_EQ(duration_of_fall_s(c, 0.5), 1.0);
    c.soil.radii_m = {0.012}, c.soil.radii_shares = {1};
    EXPECT_DOUBLE_EQ(duration_of_fall_s(c, 0.5), 2.0);
    EXPECT_DOUBLE_EQ(scale_repose(c, 800).column_m, 0.48);
}

}  // namespace
}  // namespace ifedem

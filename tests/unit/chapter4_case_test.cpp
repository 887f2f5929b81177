// The tyre's case against the inputs that chapter 4 prints (Tables 4-1 to 4-4, section 4.2.4). The time step alone is
// another one: choices.csv says why.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "check/csv.hpp"
#include "check/ledger.hpp"
#include "model/case.hpp"

namespace ifedem {
namespace {

/// The numbers of a row of the ledger: "200;0.3;1.5", or "1.6;2.0;2.4 (3:2:1)" with what follows a blank left out.
std::vector<double> printed(const std::string& id) {
    static const Ledger ledger = read_ledger(IFEDEM_SOURCE_DIR);
    std::vector<double> numbers;
    for (const std::string& part : split(ledger.at(id).value, ';')) {
        const auto number = parse_number(part.substr(0, part.find(' ')));
        EXPECT_TRUE(number) << id << ": " << part;
        numbers.push_back(number.value_or(0));
    }
    return numbers;
}

void expect_printed(const std::string& id, const std::vector<double>& ours) {
    const std::vector<double> theirs = printed(id);
    ASSERT_EQ(theirs.size(), ours.size()) << id;
    for (std::size_t k = 0; k < ours.size(); ++k) EXPECT_DOUBLE_EQ(ours[k], theirs[k]) << id;
}

TEST(Chapter4Case, uses_the_printed_inputs) {
    const Case c = read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter4/cases/tyre.toml");
    const WheelCase& w = c.wheel;
    expect_printed("D132", {static_cast<double>(c.record.stress_segments)});
    expect_printed("D142", {2e3 * w.tread_radius_m});
    expect_printed("D143", {1e3 * w.width_m});
    expect_printed("D145", {1e3 * c.travel.speed_m_s});
    EXPECT_EQ(c.travel.speed_of, SpeedOf::tread);
    expect_printed("D147", {w.load_N});
    EXPECT_EQ(w.lug_pairs, 0);  // D148: smooth
    expect_printed("D151", {c.bed.length_m});
    expect_printed("D152", {c.travel.distance_m});
    EXPECT_DOUBLE_EQ(c.travel.start_x_m, 0.5);  // D152: "from 0.5 m"
    expect_printed("D154", {1e-6 * w.rim.young_Pa, 1e-6 * w.intermediate.young_Pa, 1e-6 * w.surface.young_Pa});
    expect_printed("D155", {w.rim.poisson, w.intermediate.poisson, w.surface.poisson});
    expect_printed("D156", {w.rim.density_kg_m3, w.intermediate.density_kg_m3, w.surface.density_kg_m3});
    expect_printed("D157", {w.rim_width_m, w.width_m, w.width_m});
    expect_printed("D158", {w.rim.damping_1_s, w.intermediate.damping_1_s, w.surface.damping_1_s});
    expect_printed("D159", {static_cast<double>(c.bed.disc_count)});
    expect_printed("D160", {static_cast<double>(c.bed.levelled_count)});
    expect_printed("D161", {1e3 * c.soil.radii_m[0], 1e3 * c.soil.radii_m[1], 1e3 * c.soil.radii_m[2]});
    EXPECT_EQ(c.soil.radii_shares, (std::vector<double>{3, 2, 1}));
    expect_printed("D163", {c.soil.density_kg_m3});
    expect_printed("D164", {c.soil.thickness_m});
    expect_printed("D165", {c.contact.rolling_factor});
    EXPECT_EQ(c.contact.rolling_chord, RollingChord::half);
    expect_printed("D166", {c.stages.consolidation_s});
    expect_printed("D167", {c.stages.sinkage_s});
    expect_printed("D168", {c.travel.acceleration_time_s});
    const double kn = c.contact.normal_stiffness_N_m, ks = c.contact.tangential_stiffness_N_m;
    expect_printed("D172", {kn, kn, kn});
    expect_printed("D173", {ks, ks, ks});
    expect_printed("D174", {c.contact.friction_soil, c.contact.friction_wall, c.contact.friction_wheel});
    EXPECT_EQ(c.contact.consolidation_friction_soil, 0.0);  // D175: 0.0;0.5;NA
    EXPECT_EQ(c.contact.consolidation_friction_wall, 0.5);
    const GainsCase &p = c.control.drawbar, &t = c.control.torque;
    expect_printed("D176", {p.proportional, p.integral, p.derivative});
    expect_printed("D177", {t.proportional, t.integral, t.derivative});
    EXPECT_DOUBLE_EQ(c.record.stress_from_x_m, 0.9);  // D179: 0.9-1.2
    EXPECT_DOUBLE_EQ(c.record.stress_to_x_m, 1.2);
}

TEST(Chapter4Case, travels_at_the_printed_slips) {
    Case c = read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter4/cases/tyre.toml");
    // D146 has −5;1;7.5;22;37.5;55, and from it the speeds in mm/s.
    const std::vector<double> speed_mm_s{102.48, 96.62, 90.28, 76.13, 61.00, 43.92}, slips = printed("D146");
    ASSERT_EQ(slips.size(), speed_mm_s.size());
    for (std::size_t k = 0; k < slips.size(); ++k) {
        c.travel.slip_percent = slips[k];
        EXPECT_NEAR(1e3 * travel_speed_m_s(c.travel), speed_mm_s[k], 0.005);
    }
}

}  // namespace
}  // namespace ifedem

// The cases of chapter 5 against the inputs that it prints (Tables 5-1 to 5-5, sections 5.1.3 to 5.2.2). The number of
// discs in a block alone is another one: choices.csv says why.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "check/csv.hpp"
#include "check/ledger.hpp"
#include "model/case.hpp"

namespace ifedem {
namespace {

/// The numbers of a row of the ledger: "200;0.3;1.5", with what follows a blank left out.
void expect_printed(const std::string& id, const std::vector<double>& ours) {
    static const Ledger ledger = read_ledger(IFEDEM_SOURCE_DIR);
    const auto parts = split(ledger.at(id).value, ';');
    ASSERT_EQ(parts.size(), ours.size()) << id;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto number = parse_number(parts[k].substr(0, parts[k].find(' ')));
        ASSERT_TRUE(number) << id << ": " << parts[k];
        EXPECT_NEAR(ours[k], *number, 1e-9 * std::fabs(*number)) << id;
    }
}

Case read_region(const std::string& name) {
    return read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter5/cases/" + name + ".toml");
}

TEST(Chapter5Case, uses_the_printed_inputs) {
    const Case c = read_region("small");
    const WheelCase& w = c.wheel;
    const ElementsCase& e = c.elements;
    expect_printed("D205", {e.pattern_s});
    EXPECT_DOUBLE_EQ(e.pattern_mass_factor, 0.01);  // D206: 1/100
    expect_printed("D218", {1e3 * c.travel.speed_m_s});
    EXPECT_EQ(c.travel.speed_of, SpeedOf::tread);
    expect_printed("D219", {w.load_N});
    expect_printed("D223", {1e-6 * w.rim.young_Pa, 1e-6 * w.intermediate.young_Pa, 1e-6 * w.surface.young_Pa});
    expect_printed("D224", {w.rim.poisson, w.intermediate.poisson, w.surface.poisson});
    expect_printed("D225", {w.rim.density_kg_m3, w.intermediate.density_kg_m3, w.surface.density_kg_m3});
    expect_printed("D226", {w.rim_width_m, w.width_m, w.width_m});
    expect_printed("D227", {w.rim.damping_1_s, w.intermediate.damping_1_s, w.surface.damping_1_s});
    expect_printed("D228", {static_cast<double>(e.columns * e.rows)});
    expect_printed("D229", {static_cast<double>((e.columns + 1) * (e.rows + 1))});
    expect_printed("D230", {1e-6 * e.material.young_Pa});
    expect_printed("D231", {e.material.poisson});
    expect_printed("D232", {e.block_length_m});
    expect_printed("D233", {e.block_height_m});
    expect_printed("D234", {e.material.density_kg_m3});
    expect_printed("D235", {c.contact.friction_elements});
    expect_printed("D236", {c.bed.length_m});
    expect_printed("D237", {c.travel.distance_m});
    const double kn = c.contact.normal_stiffness_N_m, ks = c.contact.tangential_stiffness_N_m;
    expect_printed("D239", {kn, kn, kn});
    expect_printed("D240", {ks, ks, ks});
    expect_printed("D241", {c.contact.friction_soil, c.contact.friction_wall, c.contact.friction_wheel});
    EXPECT_EQ(c.contact.consolidation_friction_soil, 0.0);  // D242: 0.0;0.0;NA
    EXPECT_EQ(c.contact.consolidation_friction_wall, 0.0);
    const GainsCase &p = c.control.drawbar, &t = c.control.torque;
    expect_printed("D243", {p.proportional, p.integral, p.derivative});
    expect_printed("D244", {t.proportional, t.integral, t.derivative});
    expect_printed("D246", {1e3 * c.soil.radii_m[0], 1e3 * c.soil.radii_m[1], 1e3 * c.soil.radii_m[2]});
    EXPECT_EQ(c.soil.radii_shares, (std::vector<double>{3, 2, 1}));
    expect_printed("D252", {static_cast<double>(e.conversion_interval_steps)});
}

TEST(Chapter5Case, regions_are_the_texts_multiples_of_a_block) {
    const struct {
        const char* name;
        const char* id;
        std::int64_t margin;
    } regions[] = {{"small", "D248", 0}, {"middle", "D249", 1}, {"large", "D250", 2}};
    for (const auto& r : regions) {
        const Case c = read_region(r.name);
        expect_printed(r.id, {1451.0 * static_cast<double>(c.elements.disc_columns)});
        EXPECT_EQ(c.elements.margin_columns, r.margin) << r.name;
        EXPECT_EQ(c.elements.disc_columns, 5 + 2 * r.margin) << r.name;
        // The tyre stands over the middle block.
        const double middle =
            static_cast<double>(c.elements.first_disc_column) + 0.5 * static_cast<double>(c.elements.disc_columns);
        EXPECT_NEAR(middle * c.elements.block_length_m, c.travel.start_x_m, 1e-12) << r.name;
    }
    expect_printed("D251", {static_cast<double>(read_region("discs").bed.disc_count)});
    EXPECT_EQ(read_region("discs").elements.columns, 0);
    EXPECT_EQ(read_region("row").elements.disc_columns, 16);
}

}  // namespace
}  // namespace ifedem

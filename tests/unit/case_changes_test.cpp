// Cases made larger, smaller, finer: one thing at a time, and always a case.
#include "model/case_changes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "step/limits.hpp"
#include "step/stages.hpp"

using namespace ifedem;

namespace {

Case tyre() { return read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter4/cases/tyre.toml"); }

/// Reads back: no rule is broken, and the settings say all.
void expect_a_case(const Case& from, const Case& changed) {
    Case again;
    ASSERT_NO_THROW(again = parse_case(to_toml(from), "from", list_changes(from, changed)));
    EXPECT_EQ(to_toml(again), to_toml(changed));
}

double discs_per_m(const Case& c) { return static_cast<double>(c.bed.disc_count) / c.bed.length_m; }

}  // namespace

TEST(CaseChanges, ListsKeysAndValues) {
    Case changed;
    changed.bed.seed = 7;
    changed.soil.radii_m = {0.001, 0.002};
    changed.wheel.body = WheelBody::rigid;
    const std::vector<Override> changes = list_changes(Case{}, changed);
    ASSERT_EQ(changes.size(), 3U);
    EXPECT_EQ(changes[0].key + "=" + changes[0].value, "soil.radii_m=[0.001, 0.002]");
    EXPECT_EQ(changes[1].key + "=" + changes[1].value, "bed.seed=7");
    EXPECT_EQ(changes[2].key + "=" + changes[2].value, "wheel.body=\"rigid\"");
    EXPECT_TRUE(list_changes(changed, changed).empty());
}

TEST(CaseChanges, RealisationsAreThoseOfTheChapters) {
    // reproductions/chapter3/realisations.mk, chapter4/realisations.mk
    const double lugs[] = {0, 18.541, 7.082, 25.623, 14.164, 2.705, 21.246, 9.787, 28.328, 16.869, 5.410, 23.951};
    for (int k = 1; k <= 12; ++k) {
        EXPECT_EQ(make_realisation(Case{}, k).bed.seed, k);
        EXPECT_DOUBLE_EQ(make_realisation(Case{}, k).wheel.lug_phase_deg, lugs[k - 1]) << k;
    }
    const double columns[] = {0, 3.973, 1.518, 5.491, 3.035, 0.580, 4.553, 2.097};
    for (int k = 1; k <= 8; ++k) EXPECT_DOUBLE_EQ(make_realisation(tyre(), k).wheel.lug_phase_deg, columns[k - 1]) << k;
}

TEST(CaseChanges, DepthIsMoreDiscsAtTheSameLength) {
    const Case c = tyre(), deep = with_depth(c, 2);
    EXPECT_EQ(deep.bed.disc_count, 2 * c.bed.disc_count);
    EXPECT_EQ(deep.bed.levelled_count, 2 * c.bed.levelled_count);
    EXPECT_EQ(deep.bed.length_m, c.bed.length_m);
    EXPECT_EQ(deep.stages.consolidation_s, 2 * c.stages.consolidation_s);
    expect_a_case(c, deep);
    EXPECT_EQ(with_depth(c, 0.5).stages.consolidation_s, c.stages.consolidation_s);
}

TEST(CaseChanges, LengthDoublesTheSoilBehindAndAhead) {
    const Case c = tyre(), longer = with_length(c, 2);
    EXPECT_EQ(longer.bed.length_m, 2 * c.bed.length_m);
    EXPECT_EQ(longer.travel.start_x_m, 2 * c.travel.start_x_m);
    EXPECT_EQ(longer.travel.distance_m, c.travel.distance_m);
    const auto ahead = [](const Case& x) { return x.bed.length_m - x.travel.start_x_m - x.travel.distance_m; };
    EXPECT_GE(ahead(longer), 2 * ahead(c));
    // The window of the contact stress goes with the wheel.
    EXPECT_DOUBLE_EQ(longer.record.stress_from_x_m - longer.travel.start_x_m,
                     c.record.stress_from_x_m - c.travel.start_x_m);
    expect_a_case(c, longer);
}

TEST(CaseChanges, LessSoilBehindAndAheadKeepsTheDepthAndTheTravel) {
    for (const Case& c : {Case{}, tyre()}) {
        for (const double share : {0.75, 0.5, 0.125, 0.0}) {
            const Case both = with_soil_ahead(with_soil_behind(c, share), share);
            EXPECT_NEAR(discs_per_m(both), discs_per_m(c), 1 / c.bed.length_m * 2);
            EXPECT_EQ(both.travel.distance_m, c.travel.distance_m);
            const double radius =
                c.wheel.tread_radius_m + (c.wheel.lug_pairs > 0 ? c.wheel.lug_height_m : 0);  // to the lugs' tips
            EXPECT_NEAR(both.travel.start_x_m - radius, share * (c.travel.start_x_m - radius), 1e-4);
            const double ahead = c.bed.length_m - c.travel.start_x_m - c.travel.distance_m - radius;
            EXPECT_NEAR(both.bed.length_m - both.travel.start_x_m - both.travel.distance_m - radius, share * ahead,
                        2e-4);
            if (share > 0) expect_a_case(c, both);
        }
        EXPECT_TRUE(list_changes(c, with_soil_ahead(with_soil_behind(c, 1), 1)).empty());
    }
}

TEST(CaseChanges, ARegionGrowsAndShrinksAroundTheWheel) {
    const Case small = read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter5/cases/small.toml");
    const auto region_of = [](const Case& c) {
        return std::vector<std::int64_t>{c.elements.first_disc_column, c.elements.disc_columns,
                                         c.elements.margin_columns};
    };
    EXPECT_EQ(region_of(with_region(small, 7.0 / 5)),
              region_of(read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter5/cases/middle.toml")));
    EXPECT_EQ(region_of(with_region(small, 9.0 / 5)),
              region_of(read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter5/cases/large.toml")));
    EXPECT_EQ(region_of(with_region(small, 0.5)), (std::vector<std::int64_t>{4, 3, 0}));
    EXPECT_EQ(region_of(with_region(small, 100)), (std::vector<std::int64_t>{0, 16, 247}));
    EXPECT_TRUE(list_changes(small, with_region(small, 1)).empty());
    expect_a_case(small, with_region(small, 2));
    EXPECT_TRUE(has_region(small));
    EXPECT_FALSE(has_region(tyre()));
}

TEST(CaseChanges, FinerDiscsFillTheSameBed) {
    const Case c = tyre(), fine = with_disc_radii(c, 0.5);
    EXPECT_EQ(fine.bed.disc_count, 4 * c.bed.disc_count);
    EXPECT_EQ(fine.soil.radii_m, (std::vector<double>{0.0008, 0.001, 0.0012}));
    expect_a_case(c, fine);
}

TEST(CaseChanges, MeshesAreFinerInBothDirections) {
    const Case c, fine = with_mesh(c, 2);
    EXPECT_EQ(fine.wheel.intermediate_rings, 2 * c.wheel.intermediate_rings);
    EXPECT_EQ(fine.wheel.surface_rings, 2 * c.wheel.surface_rings);
    EXPECT_EQ(fine.wheel.gap_columns, 2 * c.wheel.gap_columns);
    EXPECT_EQ(fine.wheel.pitch_columns, 2 * c.wheel.pitch_columns);
    EXPECT_EQ(with_mesh(tyre(), 2).wheel.smooth_columns, 112);
    EXPECT_GE(with_mesh(tyre(), 0.01).wheel.smooth_columns, 12);
    EXPECT_EQ(with_mesh(c, 0.01).wheel.intermediate_rings, 1);
    EXPECT_TRUE(list_changes(tyre(), with_mesh(tyre(), 1)).empty());
    Case gmsh;
    gmsh.wheel.mesh_file = "wheel.msh";
    EXPECT_FALSE(can_refine_mesh(gmsh));
}

TEST(CaseChanges, TheStepKeepsThreeDigitsAndIsNeverLonger) {
    const Case c;
    EXPECT_EQ(with_time_step(c, 0.5).time_step_s, 2e-5);
    EXPECT_EQ(with_time_step(c, 2).time_step_s, 8e-5);
    EXPECT_EQ(with_time_step(c, 1 / 0.75).time_step_s, 5.33e-5);
    EXPECT_EQ(with_time_step(c, 1).time_step_s, c.time_step_s);
}

TEST(CaseChanges, CostIsDiscsTimesSteps) {
    const Case c;
    EXPECT_DOUBLE_EQ(count_disc_steps(with_time_step(c, 0.5)) / count_disc_steps(c), 2);
    EXPECT_DOUBLE_EQ(count_disc_steps(with_length(c, 2)) / count_disc_steps(c), 2);
    // Levelling leaves fewer for sinkage and travel.
    Case levelled = c;
    levelled.bed.levelled_count = c.bed.disc_count / 2;
    levelled.stages.consolidation_s = 0;
    Case whole = levelled;
    whole.bed.levelled_count = 0;
    EXPECT_DOUBLE_EQ(count_disc_steps(levelled) / count_disc_steps(whole), 0.5);
}

TEST(CaseChanges, AStepBeyondACertainLimitIsFound) {
    const Case c;
    EXPECT_FALSE(find_certain_excess(c));
    EXPECT_TRUE(find_certain_excess(with_time_step(c, 64)));
}

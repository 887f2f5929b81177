// The adaptive region: which block is due, and that a drive by it has the same bits after a resume.
#include "coupling/region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "step/convert.hpp"
#include "support/soil_drive.hpp"
#include "support/soil_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

/// Five columns of small blocks, the second and third of the top row discs.
Case make_region_case() {
    Case c = make_column_case(5, 2, 0.06, 0.05);
    c.elements.first_disc_column = 1, c.elements.disc_columns = 2;
    c.elements.pattern_discs = 138;
    c.elements.pattern_s = 0.1;
    c.elements.region = RegionRule::adaptive;
    c.contact.normal_stiffness_N_m = 5e5, c.contact.tangential_stiffness_N_m = 1.25e5;
    c.contact.consolidation_friction_soil = c.contact.consolidation_friction_wall = 0.6;
    c.soil.thickness_m = 0.17;
    return c;
}
constexpr std::uint32_t behind = 6, ahead = 8;  // blocks (1, 1) and (3, 1) of 5 × 2
constexpr double surface_m = 0.1;
const std::vector<Vec2> far_away{{0.15, 1}};

std::optional<DueConversion> find_due(const World& w, const std::vector<Vec2>& tread) {
    return find_due_adaptive(w.scene.soil, w.scene.dem, w.state, tread);
}

void halt(World& w) {
    for (Disc& d : w.state.discs.disc) d.vx_m_s = d.vy_m_s = 0;
}

/// Strains the top of a block: every element of the grid is free of stress before.
void strain_block(World& w, std::uint32_t block, Vec2 top_m) {
    const auto node = w.scene.soil.nodes_of(block);
    for (const std::size_t a : {2U, 3U}) w.state.soil.position_m[node[a]] += top_m;
}

}  // namespace

TEST(MobilisedFriction, IsThatOfMohrsCircle) {
    // Principal stresses 3:1 need sin φ = (3 − 1)/(3 + 1), however they lie.
    for (const double turn : {0.0, 0.4, 1.1}) {
        const double c = std::cos(turn), s = std::sin(turn), major = -3e3, minor = -1e3;
        const std::array<double, 3> stress{major * c * c + minor * s * s, major * s * s + minor * c * c,
                                           (major - minor) * c * s};
        EXPECT_NEAR(mobilised_sine(stress), 0.5, 1e-14);
    }
    EXPECT_EQ(mobilised_sine({-2e3, -2e3, 0}), 0);
    EXPECT_TRUE(std::isinf(mobilised_sine({1, -1, 0})));  // no mean compression
}

TEST(MobilisedFriction, OfAConfinedElementIsOneLessTwicePoisson) {
    // σ_x = ν/(1−ν) σ_y: sin φ = (1 − k)/(1 + k) = 1 − 2ν = 0.4, 23.578°.
    Case c = make_region_case();
    for (const auto& [angle, leaves] : {std::pair{23.5, true}, std::pair{23.7, false}}) {
        c.elements.friction_angle_deg = angle;
        World w = begin(c);
        strain_block(w, ahead, {0, -1e-5});
        EXPECT_EQ(leaves_elastic_range(w.scene.soil, w.state.soil, ahead), leaves) << angle;
    }
}

TEST(AdaptiveRegion, TakesTheBlockAheadWhenItWouldYield) {
    World w = begin(make_region_case());
    strain_block(w, ahead, {0, -1e-5});
    w.state.discs.disc.front().vy_m_s = -1;  // so that nothing is due behind
    EXPECT_FALSE(find_due(w, far_away).has_value());
    strain_block(w, ahead, {4e-5, 0});  // shear: τ/G = 8e-4 over ε_y = 2e-4
    const auto due = find_due(w, far_away);
    ASSERT_TRUE(due.has_value());
    EXPECT_EQ(due->kind, ConversionKind::to_discs);
    EXPECT_EQ(due->block, ahead);
}

TEST(AdaptiveRegion, TakesTheBlockAheadBeforeTheTreadComesNear) {
    World w = begin(make_region_case());
    strain_block(w, ahead, {0, -1e-5});
    w.state.discs.disc.front().vy_m_s = -1;
    const double room = 4 * w.scene.dem.largest_radius_m, left = 0.18;
    const auto is_due = [&](Vec2 p) { return find_due(w, {p}).has_value(); };
    EXPECT_TRUE(is_due({left + 0.03, surface_m + 0.9 * room}));
    EXPECT_FALSE(is_due({left + 0.03, surface_m + 1.1 * room}));
    EXPECT_TRUE(is_due({left - 0.9 * room, surface_m}));
    EXPECT_FALSE(is_due({left - 1.1 * room, surface_m}));
}

TEST(AdaptiveRegion, GivesBackTheLastBlockWhenTheTreadHasLeftAndItRests) {
    World w = begin(make_region_case());
    strain_block(w, ahead, {0, -1e-5});
    halt(w);
    const auto due = find_due(w, far_away);
    ASSERT_TRUE(due.has_value());
    EXPECT_EQ(due->kind, ConversionKind::to_element);
    EXPECT_EQ(due->block, behind);
    EXPECT_FALSE(find_due(w, {{0.09, surface_m}}).has_value());  // the tread stands on it
    // Energy that lifts all by a thousandth of the largest radius: v² = 2 g R/1000.
    const double limit = std::sqrt(2 * 9.81 * 1e-3 * w.scene.dem.largest_radius_m);
    for (const auto& [share, rests] : {std::pair{0.99, true}, std::pair{1.01, false}}) {
        for (Disc& d : w.state.discs.disc) d.vx_m_s = share * limit;
        EXPECT_EQ(is_at_rest(w.scene.soil, w.scene.dem, w.state, behind), rests);
    }
}

TEST(AdaptiveRegion, KeepsOneBlock) {
    Case c = make_region_case();
    c.elements.disc_columns = 1;
    World w = begin(c);
    strain_block(w, ahead - 1, {0, -1e-5});  // the block ahead of a single one
    halt(w);
    EXPECT_FALSE(find_due(w, far_away).has_value());
}

TEST(AdaptiveRegion, DrivesWithTheSameBitsAfterAResume) {
    Case c = make_drive();
    c.elements.region = RegionRule::adaptive;
    World w = begin_travel(c);
    const State start = w.state;
    drive_through(w, c);
    if (HasFatalFailure()) return;
    const auto& made = w.state.soil.conversions;
    for (const ConversionRecord& r : made)
        std::printf("step %5.0f: block %2.0f %s%s\n", r.step, r.block, r.kind == 0 ? "to discs" : "to element",
                    r.refused != 0 ? " refused" : "");
    ASSERT_FALSE(made.empty());
    expect_same_end_after_a_stop(c, start, static_cast<std::int64_t>(made.back().step), w.state);
}

}  // namespace ifedem

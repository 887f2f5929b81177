// Walls that move: what the sand does to them, and that it sees their velocity.
#include "soil_tests/wall_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dem/threads.hpp"
#include "soil_tests/plate_press.hpp"
#include "soil_tests/shear_box.hpp"
#include "support/dem_scenes.hpp"

namespace ifedem {
namespace {

using scene::make_contact;
using scene::make_dem;
using scene::make_disc;

/// On one thread: the scenes are too small to share.
class WallBodiesTest : public testing::Test {
protected:
    void SetUp() override { set_threads(1); }
};
using ShearBoxTest = WallBodiesTest;
using PlateTest = WallBodiesTest;

/// A row of wall discs from x = 0, its tops at y = 0.
std::vector<WallDisc> make_floor(int count) {
    std::vector<WallDisc> walls;
    for (int k = 0; k < count; ++k) walls.push_back({{0.006 * k, -0.003}, 0.003});
    return walls;
}

TEST_F(WallBodiesTest, CarryTheWeightOfWhatRestsOnThem) {
    DemConstants dem = make_dem(make_contact(1e5, 2.5e4, 0.5), 0.3, 2e-5, 9.81);
    dem.wall_discs = make_floor(4);
    WallBodies bodies(dem, {make_disc({0.009, 0.00163}, 0.0025, 0.005)}, {0, 1, 2, 3});
    bodies.advance(20000);
    const double weight = 0.005 * 9.81;
    EXPECT_NEAR(bodies.force_N(1).y + bodies.force_N(2).y, -weight, 1e-6 * weight);
    EXPECT_NEAR(bodies.force_N(1).x, -bodies.force_N(2).x, 1e-6 * weight);
    EXPECT_EQ(bodies.force_N(0).y, 0);
}

WallBodies make_heap(const std::vector<Disc>& discs) {
    DemConstants dem = make_dem(make_contact(1e5, 2.5e4, 0.5), 0.3, 2e-5, 9.81);
    dem.wall_discs = make_floor(12);
    return {dem, discs, std::vector<std::uint32_t>(12, 0)};
}

/// Six discs that have come to rest on a floor, then pushed to one side so that they slide and roll on it; both with a
/// common velocity.
std::vector<Vec2> forces_at(double speed_m_s) {
    std::vector<Disc> discs;
    for (int k = 0; k < 6; ++k)
        discs.push_back(make_disc({0.02 + 0.0051 * (k % 3), 0.0025 + 0.0051 * (k / 3)}, 0.0025, 0.005));
    WallBodies settled = make_heap(discs);
    settled.advance(10000);
    discs = settled.world().state.discs.disc;
    for (Disc& d : discs) d.vx_m_s += speed_m_s + 0.05;
    WallBodies bodies = make_heap(discs);
    bodies.set_velocity(0, {speed_m_s, 0});
    std::vector<Vec2> forces;
    for (int n = 0; n < 20; ++n) {
        bodies.advance(50);
        forces.push_back(bodies.force_N(0));
    }
    return forces;
}

TEST_F(WallBodiesTest, AndSandOnThemFeelNoCommonVelocity) {
    // 20 ms at 0.5 m/s are 1 cm: thirty margins, so the lists are made anew on the way.
    const std::vector<Vec2> rest = forces_at(0), moving = forces_at(0.5);
    double largest = 0;
    for (const Vec2 f : rest) largest = std::fmax(largest, norm(f));
    ASSERT_GT(largest, 0.01);
    for (std::size_t n = 0; n < rest.size(); ++n) EXPECT_LT(norm(moving[n] - rest[n]), 1e-6 * largest) << n;
}

TEST_F(WallBodiesTest, DragAlongWhatRestsOnThem) {
    DemConstants dem = make_dem(make_contact(1e5, 2.5e4, 0.5), 0.3, 2e-5, 9.81);
    dem.wall_discs = make_floor(20);
    WallBodies bodies(dem, {make_disc({0.009, 0.00163}, 0.0025, 0.005)}, std::vector<std::uint32_t>(20, 0));
    bodies.advance(5000);
    const double before = bodies.world().state.discs.disc[0].x_m;
    bodies.set_velocity(0, {0.02, 0});
    bodies.advance(25000);  // 0.5 s
    EXPECT_NEAR(bodies.world().state.discs.disc[0].x_m - before, 0.01, 2e-4);
}

TEST_F(ShearBoxTest, CarriesTheLidsStressAndKeepsTheSandIn) {
    Case sand;
    const ShearTest t = shear_directly(sand, {200, 0.05}, 1e4, 0.02);
    ASSERT_EQ(t.shear_Pa.size(), 21U);
    EXPECT_EQ(t.displacement_m.front(), 0) << "K is an integral from there";
    // The walls' friction holds some of the lid's load, or adds to it: −2 to +7 % over three packings.
    EXPECT_NEAR(t.normal_Pa, 1e4, 1.5e3);
    // Dense sand on its way to the peak: 1.0 of the normal stress over the same packings.
    EXPECT_NEAR(t.shear_Pa.back() / t.normal_Pa, 1, 0.25);
}

TEST_F(PlateTest, MeetsMoreTheDeeperItGoes) {
    Case sand;
    const PlatePress t = press_plate(sand, 300);
    ASSERT_EQ(t.sinkage_m.size(), 100U);
    EXPECT_LT(t.sinkage_m.front(), 0.01 * t.width_m);
    EXPECT_NEAR(t.sinkage_m.back(), 0.25 * t.width_m, 0.01 * t.width_m);
    double early = 0, late = 0;
    for (std::size_t k = 0; k < 50; ++k) early += t.pressure_Pa[k], late += t.pressure_Pa[k + 50];
    EXPECT_GT(late, 1.5 * early);
}

}  // namespace
}  // namespace ifedem

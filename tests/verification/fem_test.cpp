// The finite elements against closed forms: statics, large rotation, waves, step limit.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/elements.hpp"
#include "fem/equilibrium.hpp"
#include "fem/radial_stiffness.hpp"
#include "support/beams.hpp"

namespace ifedem {
namespace {

using namespace scene;

// ---- Statics ------------------------------------------------------------------------------------------------------

TEST(Patch, constant_strain_is_exact) {
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
        const PatchErrors errors = strain_patch(plane);
        EXPECT_LT(errors.stress, 1e-9);
        EXPECT_LT(errors.inner_force, 1e-12);
        EXPECT_LT(errors.energy, 1e-12);
    }
}

TEST(Patch, solver_recovers_the_constant_strain) {
    const Mesh mesh = make_distorted_patch();
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    Supports supports = make_supports(mesh.node_m.size());
    StaticState state{mesh.node_m, {}};
    for (std::size_t k = 0; k < mesh.node_m.size(); ++k) {
        if (is_inner(mesh, k)) continue;
        hold(supports, k);
        state.position_m[k] = {1.3 * mesh.node_m[k].x + 0.1 * mesh.node_m[k].y,  // large, symmetric
                               0.1 * mesh.node_m[k].x + 0.8 * mesh.node_m[k].y};
    }
    ASSERT_EQ(find_equilibrium(set, supports, state), Convergence::reached);
    for (std::size_t k = 0; k < mesh.node_m.size(); ++k) {
        EXPECT_NEAR(state.position_m[k].x, 1.3 * mesh.node_m[k].x + 0.1 * mesh.node_m[k].y, 1e-12);
        EXPECT_NEAR(state.position_m[k].y, 0.1 * mesh.node_m[k].x + 0.8 * mesh.node_m[k].y, 1e-12);
    }
}

TEST(Force, rigid_motion_is_free_of_it) {
    const Mesh mesh = make_distorted_patch();
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    const double scale = rubber.young_Pa * thickness_m * 0.1;  // the force of a strain of one
    for (const double angle : {0.0, 0.1, 1.0, 1.5707963, 3.0, pi, 4.0, 6.0, 100.0}) {
        std::vector<Vec2> position = scene::turned(mesh.node_m, angle);
        for (Vec2& p : position) p += Vec2{0.7, -0.3};
        EXPECT_LT(largest(find_force(set, position)), 1e-12 * scale) << angle;
    }
}

TEST(Force, balances_and_turns_with_the_body) {
    const Mesh mesh = make_distorted_patch();
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    const std::vector<Vec2> position = scene::shaken(scene::turned(mesh.node_m, 0.8), 0.02);
    const std::vector<Vec2> force = find_force(set, position);
    Vec2 sum;
    double moment = 0;
    for (std::size_t k = 0; k < force.size(); ++k) {
        sum += force[k];
        moment += cross(position[k], force[k]);
    }
    EXPECT_LT(norm(sum), 1e-13 * largest(force));
    EXPECT_LT(std::abs(moment), 1e-13 * largest(force));  // arms are below 1 m
    const std::vector<Vec2> force_after = find_force(set, scene::turned(position, 2.0));
    const std::vector<Vec2> expected = scene::turned(force, 2.0);
    for (std::size_t k = 0; k < force.size(); ++k)
        EXPECT_LT(norm(force_after[k] - expected[k]), 1e-12 * largest(force));
}

TEST(Force, is_minus_the_slope_of_the_energy) {
    const Mesh mesh = make_distorted_patch();
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
        const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, plane);
        std::vector<Vec2> position = scene::shaken(scene::turned(mesh.node_m, 2.5), 0.02);  // strains of 0.2
        const std::vector<Vec2> force = find_force(set, position);
        const double h = 1e-6;
        for (std::size_t k = 0; k < 2 * position.size(); ++k) {
            double& coordinate = k % 2 == 0 ? position[k / 2].x : position[k / 2].y;
            const double kept = coordinate;
            coordinate = kept + h;
            const double ahead = strain_energy_J(set, position);
            coordinate = kept - h;
            const double behind = strain_energy_J(set, position);
            coordinate = kept;
            const double component = k % 2 == 0 ? force[k / 2].x : force[k / 2].y;
            EXPECT_NEAR(-(ahead - behind) / (2 * h), component, 1e-7 * largest(force)) << "coordinate " << k;
        }
    }
}

TEST(Cantilever, tip_deflection_is_timoshenkos) {
    std::vector<double> error;
    for (const std::uint32_t rows : {1U, 2U, 4U, 8U}) error.push_back(bend_cantilever(rows));
    EXPECT_LT(std::abs(error[3]), 0.01) << "bilinear quads lock in bending: 1 row gives " << error[0];
    EXPECT_LT(error[0], -0.2);  // and that is known: see the size of the error with one row
    const double order = std::log2((error[1] - error[2]) / (error[2] - error[3]));
    EXPECT_NEAR(order, 2, 0.2) << error[0] << " " << error[1] << " " << error[2] << " " << error[3];
}

struct ElasticaCase {
    double alpha, tip_y, shortening;
};

// α = P L²/EI, tip movement over L: an integration of Euler's elastica (θ'' = −α cos θ) by Runge–Kutta and shooting.
class Elastica : public testing::TestWithParam<ElasticaCase> {};

TEST_P(Elastica, tip_position) {
    const ElasticaCase c = GetParam();
    const Vec2 tip = bend_elastica(c.alpha);
    EXPECT_NEAR(tip.y / c.tip_y, 1, 0.01);
    EXPECT_NEAR(tip.x / c.shortening, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Loads, Elastica,
                         testing::Values(ElasticaCase{1, 0.30172, 0.05643}, ElasticaCase{2, 0.49346, 0.16064},
                                         ElasticaCase{4, 0.66996, 0.32894}, ElasticaCase{10, 0.81061, 0.55500}));

TEST(Ring, gives_way_under_a_diametral_load) {
    const RingGive give = squeeze_ring();
    EXPECT_NEAR(give.along / (pi / 4 - 2 / pi), 1, 0.01);
    EXPECT_NEAR(give.across / (2 / pi - 0.5), 1, 0.01);
}

TEST(Plane, block_is_squeezed_as_hooke_says) {
    // A block held at its upper edge in y only, on a frictionless plane: uniaxial stress, E t L/h per unit of approach.
    const Mesh mesh = make_bar(4, 3, 0.2, 0.1);
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    Supports supports = make_supports(mesh.node_m.size());
    for (std::uint32_t i = 0; i <= 4; ++i) supports.held[2 * (3 * 5 + i) + 1] = 1;
    supports.held[2 * (3 * 5 + 2)] = 1;  // x of the middle
    StaticState state{mesh.node_m, {}};
    ASSERT_EQ(find_equilibrium(set, supports, {0.004, PlaneFriction::none}, state), Convergence::reached);
    EXPECT_NEAR(plane_load_N(set, supports, state) / (4e6 * thickness_m * 0.2 * 0.04), 1, 1e-9);
    ASSERT_EQ(find_equilibrium(set, supports, {-0.001, PlaneFriction::none}, state), Convergence::reached);
    EXPECT_EQ(plane_load_N(set, supports, state), 0);  // and it lets go
}

TEST(RadialStiffness, wheel_of_chapter_3_is_near_the_text) {
    // 15.9 N/mm (B3, Eq 3.9). The surface layer's thickness is not published; 20 mm is our input, so a tenth is asked.
    WheelCase wheel;
    wheel.surface_thickness_m = 0.02;
    const RadialStiffness stiffness = find_radial_stiffness(wheel, 170, 8);
    EXPECT_NEAR(stiffness.mean_N_m, 15.9e3, 1.6e3);
    EXPECT_LT(stiffness.smallest_N_m, stiffness.mean_N_m);
    EXPECT_GT(stiffness.largest_N_m, stiffness.mean_N_m);
    const std::array<double, 1> deflection{170 / stiffness.phase_N_m[0]};
    EXPECT_NEAR(press_on_plane(wheel, deflection, 0)[0].load_N, 170, 1e-3);
}

// ---- Dynamics -----------------------------------------------------------------------------------------------------

TEST(Rotation, ten_turns_add_no_strain) {
    Mesh mesh = make_bar(4, 2, 0.4, 0.2);
    for (Vec2& p : mesh.node_m) p -= Vec2{0.2, 0.1};
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    const double omega = 3;  // tip speed 1 % of the wave speed: centrifugal strains near 1e-4
    Motion motion{set, mesh.node_m, {}, {}};
    for (const Vec2 p : mesh.node_m) motion.velocity_m_s.push_back(cross(omega, p));
    const double dt = 0.5 * stable_step(set).step_s;
    const auto steps_a_turn = static_cast<int>(2 * pi / omega / dt);
    const double spin = motion.spin();
    const double kinetic = motion.kinetic_J();
    std::array<double, 2> most{};  // strain energy in the first and the last five turns
    for (int k = 0; k < 10 * steps_a_turn; ++k) {
        motion.step(dt);
        double& here = most[k < 5 * steps_a_turn ? 0 : 1];
        here = std::max(here, strain_energy_J(set, motion.position_m));
    }
    EXPECT_LT(most[1], 1.02 * most[0]);
    EXPECT_LT(most[0], 1e-3 * kinetic);
    EXPECT_NEAR(motion.spin() / spin, 1, 1e-10);
    EXPECT_NEAR((motion.kinetic_J() + strain_energy_J(set, motion.position_m)) / kinetic, 1, 1e-4);
}

TEST(Wave, thin_bar_carries_sqrt_E_over_rho) {
    const Wave wave = strike_bar(PlaneState::stress, 0.005, false, 0.9);
    const double c = std::sqrt(rubber.young_Pa / rubber.density_kg_m3);
    EXPECT_NEAR(wave.speed_m_s / c, 1, 0.01);
    EXPECT_NEAR(-wave.stress_Pa / (rubber.density_kg_m3 * c * 1e-3), 1, 0.01);
}

TEST(Wave, confined_bar_carries_the_P_wave) {
    const double nu = rubber.poisson;
    const double modulus = rubber.young_Pa * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const double c = std::sqrt(modulus / rubber.density_kg_m3);
    for (const double share : {0.3, 0.9}) {
        const Wave wave = strike_bar(PlaneState::strain, 0.02, true, share);
        EXPECT_NEAR(wave.speed_m_s / c, 1, 0.01);
        EXPECT_NEAR(-wave.stress_Pa / (rubber.density_kg_m3 * c * 1e-3), 1, 0.01);
    }
}

TEST(StableStep, one_element_blows_up_just_above_it) {
    const ElementSet set = make_elements(make_bar(1, 1, 0.1, 0.1), everywhere(rubber), thickness_m, PlaneState::stress);
    EXPECT_NEAR(stable_step(set).step_s / swing_element(0.99).limit_s, 1, 1e-12);
    EXPECT_LT(swing_element(0.99).largest, 100);  // the central difference's own energy: 1/(1 − share²) = 50 at most
    EXPECT_GT(swing_element(1.01).largest, 1e6);
}

TEST(StableStep, is_a_bound_for_a_mesh) {
    const Mesh mesh = make_distorted_patch();
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::strain);
    Motion motion{set, scene::shaken(mesh.node_m, 1e-8), std::vector<Vec2>(mesh.node_m.size()), {}};
    const double begin = strain_energy_J(set, motion.position_m);
    double most = 0;
    for (int k = 0; k < 5000; ++k) {
        motion.step(0.99 * stable_step(set).step_s);
        most = std::max(most, strain_energy_J(set, motion.position_m));
    }
    EXPECT_LT(most, 100 * begin);
}

}  // namespace
}  // namespace ifedem

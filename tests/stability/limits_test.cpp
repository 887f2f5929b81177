// The predicted limits of the step against exact systems: closed forms, dense eigenvalues, and the step at which the
// motion of a small system does grow.
#include "step/limits.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>

#include "step/frozen_mode.hpp"
#include "step/health.hpp"
#include "step/stable_phase.hpp"
#include "support/growth.hpp"
#include "support/soil_scenes.hpp"
#include "traction/control.hpp"

namespace ifedem {
namespace {

constexpr Integrator integrators[] = {Integrator::symplectic_euler, Integrator::modified_euler_one,
                                      Integrator::modified_euler_two};

TEST(StablePhase, OfSymplecticEulerIsTheClosedForm) {
    for (const double zeta : {0.0, 0.05, 0.2, 0.7, 2.0}) {
        const double limit = largest_stable_phase(Integrator::symplectic_euler, zeta);
        EXPECT_LE(amplification(Integrator::symplectic_euler, 0.999 * limit, zeta), 1 + 1e-9) << zeta;
        EXPECT_GT(amplification(Integrator::symplectic_euler, 1.001 * limit, zeta), 1 + 1e-6) << zeta;
    }
}

/// ω and ζ of the mode against those of a column: springs K between n discs and two walls, ω² = 4 K/m sin²(…).
TEST(FrozenMode, OfAColumnIsThatOfAChain) {
    for (const int count : {1, 2, 3, 8}) {
        scene::World w = scene::make_squeezed_column(count, 0, 1e-6, Integrator::symplectic_euler);
        scene::advance(w, 1);
        const FrozenMode mode = find_failing_mode(w.scene, w.state, Movable::everything);
        const double half = std::sin(0.5 * pi * count / (count + 1));
        EXPECT_NEAR(mode.omega_rad_s, 2 * std::sqrt(scene::stiffness_N_m / 0.0032) * half, 1e-3 * mode.omega_rad_s)
            << count;
    }
}

TEST(FrozenMode, PredictsWhereAColumnBeginsToGrow) {
    for (const Integrator integrator : integrators) {
        for (const double zeta : {0.05, 0.3, 0.7}) {
            for (const int count : {1, 2, 5}) {
                scene::World w = scene::make_squeezed_column(count, zeta, 1e-6, integrator);
                scene::advance(w, 1);
                const FrozenMode mode = find_failing_mode(w.scene, w.state, Movable::everything);
                const double predicted = largest_stable_phase(integrator, mode.damping_ratio) / mode.omega_rad_s;
                const double measured = scene::measure_largest_step(0.5 * predicted, 2 * predicted, [&](double dt) {
                    return scene::column_grows(count, zeta, dt, integrator);
                });
                EXPECT_NEAR(measured / predicted, 1, 0.02)
                    << static_cast<int>(integrator) << " " << zeta << " " << count;
            }
        }
    }
}

/// The lattice of the case limits is the densest there is: a patch of it vibrates slower, and the more like it the
/// larger the patch.
TEST(FrozenMode, OfALatticePatchRisesToTheClosedForm) {
    constexpr double radius = 0.002, mass = 0.0032, kn = 1e5, ks = 2.5e4, pitch = 2 * radius - 1e-9;
    const double lattice = std::max((6 * kn + 2 * ks) / mass, 24 * ks / mass);
    double before = 0;
    for (const int side : {4, 8, 16}) {
        std::vector<Disc> discs;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                discs.push_back(
                    scene::make_disc({pitch * (i + 0.5 * (j % 2)), pitch * std::sqrt(0.75) * j}, radius, mass));
        scene::World w = scene::make_world(scene::make_dem(scene::make_contact(kn, ks, 0.5), 0, 1e-7), discs);
        scene::advance(w, 1);
        const FrozenMode mode = find_failing_mode(w.scene, w.state, Movable::everything);
        const double share = mode.omega_rad_s * mode.omega_rad_s / lattice;
        EXPECT_GT(share, before);
        EXPECT_LE(share, 1.0001);
        before = share;
    }
    EXPECT_GT(before, 0.95);
}

/// Two discs of different size, deep in each other: the contact point divides their distance as the radii do. With a
/// tangential spring far above the normal one the mode slides and turns, and arms count twice over.
TEST(FrozenMode, OfAnUnequalPairHasTheLawsArms) {
    constexpr double small = 0.001, large = 0.003, m = 0.0008, n = 0.0072, kn = 1e3, ks = 1e5;
    scene::World w =
        scene::make_world(scene::make_dem(scene::make_contact(kn, ks, 0.5), 0, 1e-9),
                          {scene::make_disc({0, 0}, small, m), scene::make_disc({0.9 * (small + large), 0}, large, n)});
    scene::advance(w, 1);
    // ω² = K_s Σ (1/m + a²/I), I = ½ m r², a = 0.9 r.
    const double exact = ks * (1 / m + 1 / n) * (1 + 2 * 0.9 * 0.9);
    const FrozenMode mode = find_failing_mode(w.scene, w.state, Movable::everything);
    EXPECT_NEAR(mode.omega_rad_s * mode.omega_rad_s / exact, 1, 1e-4);
}

/// A disc on a soil element, and one on a disc that is attached to it: a spring to what is held, ω² = K/m.
TEST(FrozenMode, CountsContactsWithSoilElements) {
    Case c = scene::make_column_case(1, 1, 0.1, 0.1);
    c.gravity_m_s2 = 0;
    constexpr double radius = 0.002, mass = 0.01, overlap = 1e-5;
    for (const bool on_attached : {false, true}) {
        scene::World w;
        w.scene = make_scene(c, Stage::consolidation);
        w.state = scene::make_state(
            {scene::make_disc({0.05, 0.1 + (on_attached ? 2 : 1) * (radius - overlap)}, radius, mass)});
        w.state.soil = place_soil(w.scene.soil);
        if (on_attached) {
            w.state.soil.attached = {{0.5, 0, -overlap, radius}};
            w.state.soil.attached_from = {3}, w.state.soil.attached_to = {2}, w.state.soil.attached_block = {0};
        }
        w.work = make_workspace(w.scene, w.state);
        scene::advance(w, 1);
        const FrozenMode mode = find_failing_mode(w.scene, w.state, Movable::discs);
        EXPECT_EQ(mode.loudest_contacts, 1U) << on_attached;
        EXPECT_NEAR(mode.omega_rad_s, std::sqrt(c.contact.normal_stiffness_N_m / mass), 1e-4 * mode.omega_rad_s)
            << on_attached;
    }
}

/// Dense eigenvalues of the assembled wheel, nodes of the rim held by its large mass.
TEST(Limits, OfTheWholeWheelIsItsHighestEigenvalue) {
    Case c;
    c.wheel.body = WheelBody::elastic;
    const Scene scene = make_scene(c, Stage::sinkage);
    const ElementSet& set = scene.wheel.elements;
    const auto size = static_cast<Eigen::Index>(2 * set.mass_kg.size());
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
    for (const Element& e : set.element)
        for (std::size_t a = 0; a < 8; ++a)
            for (std::size_t b = 0; b < 8; ++b) {
                const auto row = static_cast<Eigen::Index>(2 * e.node[a / 2] + a % 2);
                const auto column = static_cast<Eigen::Index>(2 * e.node[b / 2] + b % 2);
                k(row, column) +=
                    e.stiffness_N_m[8 * a + b] / std::sqrt(set.mass_kg[e.node[a / 2]] * set.mass_kg[e.node[b / 2]]);
            }
    const double highest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues()(size - 1);
    int found = 0;
    for (const StepLimit& l : find_case_limits(scene)) {
        if (l.name != "the whole wheel") continue;
        ++found;
        EXPECT_NEAR(l.undamped_step_s * std::sqrt(highest) / 2, 1, 1e-3);
    }
    EXPECT_EQ(found, 1);
}

/// K_p Δt² + 2 K_d Δt < 4 m against the loop itself.
TEST(Limits, OfTheExplicitLoopIsWhereItsMassRunsAway) {
    constexpr double mass = 2;
    for (const GainsCase gains : {GainsCase{1e4, 0, 1e4}, GainsCase{1e8, 0, 1e3}, GainsCase{1e9, 0, 0.0}}) {
        const auto runs_away = [&](double dt) {
            PidState pid;
            double x = 1e-6, v = 0;
            pid.error_old = -x;
            for (int n = 0; n < 20000 && std::fabs(x) < 1; ++n) {
                v = advance_controlled(ControlScheme::explicit_, gains, {mass, 0, x, v, 0}, 0, dt, pid);
                x += dt * v;
            }
            return !(std::fabs(x) < 1);
        };
        const double p = gains.proportional, d = gains.derivative;
        const double predicted = (std::sqrt(d * d + 4 * p * mass) - d) / p;
        const double measured = scene::measure_largest_step(0.5 * predicted, 2 * predicted, runs_away);
        EXPECT_NEAR(measured / predicted, 1, 0.01) << p << " " << d;
    }
}

/// Chapter 4's derivative gain on the hub node (issue: 18.9, 4.74 and 1.19 µs for 3, 6 and 12 rim rings there): the
/// limit falls with the mass of that node.
TEST(Limits, OfTheExplicitDrawbarLoopIsTwiceTheHubsMassOverTheGain) {
    Case c;
    c.wheel.body = WheelBody::elastic, c.control.scheme = ControlScheme::explicit_;
    c.control.drawbar.proportional = 0;
    double before = 1;
    int found = 0;
    for (const std::int64_t rings : {2, 4, 8}) {
        c.wheel.rim_rings = rings;
        const Scene scene = make_scene(c, Stage::sinkage);
        for (const StepLimit& l : find_case_limits(scene)) {
            if (l.group != LimitGroup::drawbar_loop) continue;
            ++found;
            EXPECT_DOUBLE_EQ(l.step_s, 2 * scene.wheel.elements.mass_kg[scene.wheel.mesh.hub] / 1e4);
            EXPECT_LT(l.step_s, before);
            before = l.step_s;
        }
    }
    EXPECT_EQ(found, 3);
}

TEST(Violation, OfWhatIsNotANumberHasNoLimit) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(to_text({120, Cause::not_a_number, "disc 5 is not a number", nan, 0, "Look."}),
              "stopped at step 120: disc 5 is not a number (value nan; cause: not-a-number). Look.");
    EXPECT_EQ(to_text({120, Cause::lost_disc, "disc 5 has left the bin", -2, -1, "Look."}),
              "stopped at step 120: disc 5 has left the bin (value -2, limit -1; cause: lost-disc). Look.");
}

TEST(Limits, NameThePartAtFaultBeforeTheWhole) {
    const std::vector<StepLimit> limits = {{"whole", LimitGroup::everything, LimitKind::certain, 1, 1},
                                           {"loop", LimitGroup::torque_loop, LimitKind::certain, 3, 3},
                                           {"element", LimitGroup::elements, LimitKind::safe, 2, 2}};
    EXPECT_EQ(find_worst(limits, 0.5, Among::all), nullptr);
    EXPECT_EQ(find_worst(limits, 1.5, Among::all)->name, "whole");
    EXPECT_EQ(find_worst(limits, 4, Among::certain)->name, "loop");
    EXPECT_EQ(find_worst(limits, 4, Among::all)->name, "element");
}

}  // namespace
}  // namespace ifedem

// A wheel in vacuum and on a small bed: what damping costs, and that momentum and energy add up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "coupling/wheel_model.hpp"
#include "dem/bed.hpp"
#include "step/energy.hpp"
#include "step/health.hpp"
#include "support/wheel_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

// ---- Wheel in vacuum ----------------------------------------------------------------------------------------------

/// A wheel that already turns and moves as commanded, weightless, one disc far away (the lists want one).
World make_vacuum(WheelBody body, DampingFrame frame, double dt) {
    Case c;
    c.gravity_m_s2 = 0;
    c.time_step_s = dt;
    c.wheel.load_N = 0;
    c.wheel.body = body;
    c.wheel.damping_frame = frame;
    c.wheel.intermediate.young_Pa =
        2e6;  // stiff layers settle soon behind the hub; the drag does not know the stiffness
    c.travel.speed_m_s = 0.2, c.travel.acceleration_time_s = 0;
    World w;
    w.scene = make_scene(c, Stage::travel);
    w.state = make_state({make_disc({0.01, 0.01}, 0.003, 0.0075)});
    w.state.wheel = place_wheel(w.scene.wheel, {0.5, 0.5});
    w.state.wheel.rim.velocity_m_s = {0.2, 0};
    // Angular velocity from the slip of 60 %: counter-clockwise is negative.
    w.state.wheel.rim.omega_rad_s = -0.2 / (0.15 * 0.4);
    for (std::size_t n = 0; n < w.state.wheel.position_m.size(); ++n)
        w.state.wheel.velocity_m_s[n] =
            w.state.wheel.rim.velocity_m_s +
            cross(w.state.wheel.rim.omega_rad_s, w.state.wheel.position_m[n] - Vec2{0.5, 0.5});
    begin_stage(w.scene, w.state);
    w.work = make_workspace(w.scene, w.state);
    return w;
}

/// Σ c m V and Σ c m r² ω of all nodes and of a rigid rim, undeformed.
struct FalseDrag {
    double drawbar_N = 0, torque_Nm = 0;
};
FalseDrag closed_drag(const World& w) {
    const WheelModel& m = w.scene.wheel;
    double weight = m.body_damping_1_s * m.body_mass_kg, inertia = m.body_damping_1_s * m.body_inertia_kg_m2;
    for (const std::uint32_t n : m.free_node) {
        weight += m.elements.damping_kg_s[n];
        inertia += m.elements.damping_kg_s[n] * dot(m.mesh.mesh.node_m[n], m.mesh.mesh.node_m[n]);
    }
    return {weight * 0.2, inertia * 0.2 / (0.15 * 0.4)};
}

Vec2 momentum_of_wheel(const World& w) { return momentum_Ns(w.scene.wheel, w.state.wheel); }

/// About the hub, clockwise.
double spin_of_wheel(const World& w) {
    const WheelModel& m = w.scene.wheel;
    double sum = m.body_inertia_kg_m2 * w.state.wheel.rim.omega_rad_s;
    for (const std::uint32_t n : m.free_node)
        sum += m.elements.mass_kg[n] *
               cross(w.state.wheel.position_m[n] - hub_position(w.state.wheel), w.state.wheel.velocity_m_s[n]);
    return -sum;
}

/// Means of the controller's P and T less what goes into the wheel's own momentum. The layers swing at first: sin²
/// weights.
FalseDrag measured_drag(World& w, double time_s) {
    const auto steps = static_cast<std::int64_t>(time_s / w.scene.dem.step_s);
    double momentum = momentum_of_wheel(w).x, spin = spin_of_wheel(w);
    FalseDrag mean;
    for (std::int64_t n = 0; n < steps; ++n) {
        advance(w, 1);
        const double s = std::sin(pi * (static_cast<double>(n) + 0.5) / static_cast<double>(steps));
        const double weight = 2 * s * s / static_cast<double>(steps), now = momentum_of_wheel(w).x,
                     spin_now = spin_of_wheel(w);
        mean.drawbar_N += weight * (w.state.control.drawbar.output - (now - momentum) / w.scene.dem.step_s);
        mean.torque_Nm += weight * (w.state.control.torque.output - (spin_now - spin) / w.scene.dem.step_s);
        momentum = now, spin = spin_now;
    }
    return mean;
}

class Vacuum : public testing::TestWithParam<WheelBody> {};

TEST_P(Vacuum, damping_of_absolute_velocity_is_a_false_drag) {
    const bool elastic = GetParam() == WheelBody::elastic;
    const double dt = elastic ? 1.4e-5 : 4e-5, time_s = elastic ? 0.08 : 0.2;
    World absolute = make_vacuum(GetParam(), DampingFrame::absolute, dt);
    World relative = make_vacuum(GetParam(), DampingFrame::rigid_motion, dt);
    const FalseDrag closed = closed_drag(absolute), got = measured_drag(absolute, time_s),
                    none = measured_drag(relative, 0.3 * time_s);
    std::printf(
        "%s: absolute damping T0 %.5f N m (sum c J omega %.5f), P0 %.5f N (sum c m V %.5f); rigid motion %.1e N m, "
        "%.1e N\n",
        elastic ? "elastic rim" : "rigid rim", got.torque_Nm, closed.torque_Nm, got.drawbar_N, closed.drawbar_N,
        none.torque_Nm, none.drawbar_N);
    EXPECT_NEAR(got.torque_Nm, closed.torque_Nm, 0.01 * closed.torque_Nm);
    EXPECT_NEAR(got.drawbar_N, closed.drawbar_N, 0.01 * closed.drawbar_N);
    EXPECT_NEAR(none.torque_Nm, 0, 1e-9 * closed.torque_Nm);  // round-off
    EXPECT_NEAR(none.drawbar_N, 0, 1e-9 * closed.drawbar_N);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Vacuum, testing::Values(WheelBody::rigid_rim, WheelBody::elastic));

// stages.load_ramp_s: the load grows in proportion to time, so a wheel in free fall gains W t²/(2 m T).
TEST(LoadRamp, is_linear_and_ends_at_the_load) {
    Case c;
    c.gravity_m_s2 = 0;
    c.wheel.body = WheelBody::rigid;
    c.wheel.load_N = 50;
    c.stages.load_ramp_s = 0.004;
    World w;
    w.scene = make_scene(c, Stage::sinkage);
    w.state = make_state({make_disc({0.01, 0.01}, 0.003, 0.0075)});
    w.state.wheel = place_wheel(w.scene.wheel, {0.5, 0.5});
    w.state.progress.stage = Stage::sinkage;
    w.work = make_workspace(w.scene, w.state);
    const double m = w.scene.wheel.body_mass_kg, dt = c.time_step_s;
    const auto speed = [&] { return -w.state.wheel.rim.velocity_m_s.y; };
    advance(w, 100);  // the whole ramp: steps 0 … 99 of 0.004 s
    EXPECT_NEAR(speed(), 50 * (0.5 * 99 * dt) / m, 1e-12);
    advance(w, 50);
    EXPECT_NEAR(speed(), 50 * (0.5 * 99 * dt + 50 * dt) / m, 1e-12);
}

// Whatever the nodes do, damping relative to the rigid motion adds no force and no moment, and takes energy.
TEST(Damping, relative_to_the_rigid_motion_balances) {
    Random random{3};
    for (const WheelBody body : {WheelBody::rigid_rim, WheelBody::elastic}) {
        World w = make_vacuum(body, DampingFrame::rigid_motion, 1e-5);
        for (Vec2& v : w.state.wheel.velocity_m_s) v += Vec2{random.uniform() - 0.5, random.uniform() - 0.5};
        for (Vec2& x : w.state.wheel.position_m) x += 1e-3 * Vec2{random.uniform() - 0.5, random.uniform() - 0.5};
        std::vector<Vec2> force(w.state.wheel.position_m.size());
        RigidBody& rim = w.state.wheel.rim;
        rim.velocity_m_s += Vec2{0.3, -0.2};
        rim.omega_rad_s += 0.5;
        const BodyForce on_body = add_damping_forces(w.scene.wheel, w.state.wheel, force);
        Vec2 sum = on_body.force_N;
        double moment = cross(rim.position_m, on_body.force_N) + on_body.moment_Nm, size = norm(on_body.force_N);
        double power = dot(on_body.force_N, rim.velocity_m_s) + on_body.moment_Nm * rim.omega_rad_s;
        if (body == WheelBody::rigid_rim) {
            EXPECT_GT(size, 0);  // the rim is damped too
        }
        for (std::size_t n = 0; n < force.size(); ++n) {
            sum += force[n], moment += cross(w.state.wheel.position_m[n], force[n]), size += norm(force[n]);
            power += dot(force[n], w.state.wheel.velocity_m_s[n]);
        }
        std::printf("rigid-motion damping: net force %.1e, net moment %.1e m of sum |F|\n", norm(sum) / size,
                    std::fabs(moment) / size);
        EXPECT_GT(size, 0);
        EXPECT_LT(norm(sum) / size, 1e-12);
        EXPECT_LT(std::fabs(moment) / size, 1e-12);
        EXPECT_LT(power, 0);
    }
}

// ---- Energy of a bed without a wheel ------------------------------------------------------------------------------

struct Budget {
    EnergyStore before, after;
    EnergyLedger flow;
    [[nodiscard]] double work_J() const { return flow.work_torque_J + flow.work_drawbar_J; }
    [[nodiscard]] double lost_J() const {
        return flow.lost_normal_J + flow.lost_tangential_J + flow.lost_rolling_J + flow.lost_wheel_J;
    }
    [[nodiscard]] double stored_J() const { return after.sum_J() - before.sum_J(); }
    [[nodiscard]] double residual_J() const { return work_J() - lost_J() - stored_J(); }
};

template <class Watch>
Budget measure_budget(World& w, std::int64_t steps, Watch&& before_and_after) {
    Budget b;
    b.before = measure_energy(w.scene, w.state, w.work);
    for (std::int64_t n = 0; n < steps; ++n) {
        const std::vector<Vec2> position_m = w.state.wheel.position_m;
        add_to_ledger(b.flow, step_and_measure(w.scene, w.state, w.work), w.scene.dem.step_s);
        before_and_after(position_m, w.state);
    }
    b.after = measure_energy(w.scene, w.state, w.work);
    return b;
}

void print(const char* name, const Budget& b) {
    std::printf("%s [mJ]: work of T %+.3f, of P %+.3f; lost normal %.3f, tangential %.3f, rolling %.3f, wheel %.3f\n",
                name, 1e3 * b.flow.work_torque_J, 1e3 * b.flow.work_drawbar_J, 1e3 * b.flow.lost_normal_J,
                1e3 * b.flow.lost_tangential_J, 1e3 * b.flow.lost_rolling_J, 1e3 * b.flow.lost_wheel_J);
    std::printf(
        "    stored: discs' motion %+.3f, wheel's %+.3f, springs %+.3f, strain %+.3f, discs' height %+.3f, load's "
        "height %+.3f; residual %+.3f\n",
        1e3 * (b.after.kinetic_discs_J - b.before.kinetic_discs_J),
        1e3 * (b.after.kinetic_wheel_J - b.before.kinetic_wheel_J), 1e3 * (b.after.springs_J - b.before.springs_J),
        1e3 * (b.after.strain_J - b.before.strain_J), 1e3 * (b.after.height_discs_J - b.before.height_discs_J),
        1e3 * (b.after.height_load_J - b.before.height_load_J), 1e3 * b.residual_J());
}

TEST(Energy, of_a_falling_and_settling_bed_closes) {
    for (const ContactEnd end : {ContactEnd::no_attraction, ContactEnd::attraction}) {
        double residual[2] = {};
        for (const int halvings : {0, 1}) {
            Case c = make_small_case(500, 0.3);
            c.contact.contact_end = end;
            c.time_step_s = 4e-5 / (1 << halvings);
            World w = begin(c);
            const Budget b = measure_budget(w, 5000 << halvings, [](const auto&, const State&) {});
            print(end == ContactEnd::attraction ? "bed, attraction" : "bed, no attraction", b);
            const double released = b.before.height_discs_J - b.after.height_discs_J;
            residual[halvings] = b.residual_J() / released;
            std::printf("    dt %.0e s: residual %.2f %% of the height released\n", c.time_step_s,
                        100 * residual[halvings]);
            EXPECT_GT(released, 0.01);
            EXPECT_LT(std::fabs(residual[halvings]), 0.01);
            EXPECT_GT(b.flow.lost_normal_J, 0);
            EXPECT_GT(b.flow.lost_tangential_J, 0);
            EXPECT_GT(b.flow.lost_rolling_J, 0);
        }
        // What is left is the scheme's energy error, of first order in dt: half of it with half the step, within
        // chance.
        EXPECT_LT(std::fabs(residual[1]), 0.75 * std::fabs(residual[0]));
    }
}

// ---- Wheel on a small bed -----------------------------------------------------------------------------------------

/// T acts as equal tangential shares on the rim's nodes (the text's points of application). They are a pure moment only
/// while the rim is round; on a deformed elastic rim a small force is left.
Vec2 force_of_torque(const World& w, const std::vector<Vec2>& position_m, double torque_Nm) {
    const WheelMesh& mesh = w.scene.wheel.mesh;
    Vec2 sum;
    if (w.scene.wheel.body != WheelBody::elastic) return sum;
    for (const std::uint32_t n : mesh.rim_surface) {
        const Vec2 r = position_m[n] - position_m[mesh.hub];
        sum += torque_Nm / static_cast<double>(mesh.rim_surface.size()) / dot(r, r) * Vec2{r.y, -r.x};
    }
    return sum;
}

const char* name_of(WheelBody body) {
    if (body == WheelBody::rigid) return "rigid wheel";
    return body == WheelBody::rigid_rim ? "rigid rim" : "elastic rim";
}

class Wheel : public testing::TestWithParam<WheelBody> {};

// Impulse on wheel = soil + load + drawbar force: exact step by step. Energy: work of T and P = losses + change of what
// is stored.
TEST_P(Wheel, momentum_and_energy_add_up_in_travel) {
    World w = run_until_travel(make_wheel_case(GetParam()));
    ASSERT_FALSE(check_health(w.scene, w.state, w.work).has_value())
        << to_text(*check_health(w.scene, w.state, w.work));
    const Vec2 momentum = momentum_of_wheel(w), at = w.state.wheel.rim.position_m;
    const double angle = w.state.wheel.rim.angle_rad, load = w.scene.wheel.load_N;
    w.state.series = {};
    constexpr std::int64_t steps = 4000;
    Vec2 leak;
    const Budget b = measure_budget(w, steps, [&](const std::vector<Vec2>& position_m, const State& after) {
        leak += (1.0 / steps) * force_of_torque(w, position_m, after.control.torque.output);
    });
    ASSERT_FALSE(check_health(w.scene, w.state, w.work).has_value())
        << to_text(*check_health(w.scene, w.state, w.work));
    const SeriesSums& s = w.state.series;
    const Vec2 rate = (1 / (steps * w.scene.dem.step_s)) * (momentum_of_wheel(w) - momentum);
    const double fy = s.fy_N / steps, fx = (s.fx_positive_N + s.fx_negative_N) / steps, p = s.drawbar_N / steps;
    const char* name = name_of(GetParam());
    std::printf("%s: sinkage %.2f mm, travel %.1f mm, force left by T's points of application (%.1e, %.1e) N\n", name,
                1e3 * (w.state.wheel.rim.position_m.y - w.state.touch_position_m.y),
                1e3 * (w.state.wheel.rim.position_m.x - at.x), leak.x, leak.y);
    std::printf("    mean Fy %.4f N of W = %.0f N, inertia %+.4f N, unaccounted %.1e N\n", fy, load, rate.y,
                fy + leak.y - load - rate.y);
    std::printf("    mean Fx %.4f N, P %+.4f N, inertia %+.4f N, unaccounted %.1e N\n", fx, p, rate.x,
                fx + leak.x + p - rate.x);
    EXPECT_NEAR(fy + leak.y - load, rate.y, 1e-8);  // 4000 steps of round-off
    EXPECT_NEAR(fx + leak.x + p, rate.x, 1e-8);
    EXPECT_LT(norm(leak), 1e-4 * load);
    print(name, b);
    const double work = b.flow.work_torque_J, turned = angle - w.state.wheel.rim.angle_rad;
    std::printf("    residual %.3f %% of the work of T; mean T %.4f N m over %.4f rad\n", 100 * b.residual_J() / work,
                work / turned, turned);
    EXPECT_GT(work, 0.01);
    EXPECT_NEAR(work, s.torque_Nm / steps * turned, 0.02 * work);  // the loop keeps ω within 1 or 2 %
    EXPECT_LT(std::fabs(b.residual_J()), 0.01 * work);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Wheel, testing::Values(WheelBody::rigid, WheelBody::rigid_rim, WheelBody::elastic));

}  // namespace
}  // namespace ifedem

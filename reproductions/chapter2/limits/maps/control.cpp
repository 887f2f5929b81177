#include "traction/control.hpp"

#include "maps.hpp"
#include "support/growth.hpp"

namespace ifedem::maps {
namespace {

constexpr double mass = 1, dt = 1e-3;  // the plane is in a = K_d Δt/m and b = K_p Δt²/m, so these do not matter

/// A mass on its loop, off its target: does it run away?
bool runs_away(ControlScheme scheme, const GainsCase& gains, double step_s, int steps, double far = 1) {
    PidState pid;
    double x = 1e-6, v = 0;
    pid.error_old = -x;
    for (int n = 0; n < steps; ++n) {
        v = advance_controlled(scheme, gains, {mass, 0, x, v, 0}, 0, step_s, pid);
        x += step_s * v;
        if (!(std::fabs(x) < far)) return true;
    }
    return false;
}

/// Explicit: the boundary b(a); semi-implicit: the largest b tried that stays.
std::string map_plane(Output& out) {
    std::string text = "a,predicted_b,explicit_b,semi_implicit_stays_to_b\n";
    double worst = 0;
    for (double a = 0; a <= 1.901; a += out.effort == Effort::quick ? 0.5 : 0.1) {
        const double predicted = 4 - 2 * a;
        const auto grows = [&](double b) {
            return runs_away(ControlScheme::explicit_, {b * mass / (dt * dt), 0, a * mass / dt}, dt, 20000);
        };
        const double measured = scene::measure_largest_step(0.5 * predicted, 2 * predicted, grows);
        double stays = 0;
        for (const double b : {1.0, 10.0, 100.0, 1e3, 1e4})
            if (!runs_away(ControlScheme::semi_implicit, {b * mass / (dt * dt), 0, a * mass / dt}, dt, 20000))
                stays = b;
        text += fmt::format("{:.2f},{:.4f},{:.4f},{:g}\n", a, predicted, measured, stays);
        worst = std::max(worst, std::fabs(measured / predicted - 1));
    }
    out.measured("pid_plane_error", worst, "-", "largest |measured/predicted − 1| of K_p Δt² + 2 K_d Δt = 4 m");
    return text;
}

/// Where the text and we stand in that plane: drawbar and torque, hub node and rim or rigid rim.
std::string map_points(Output& out) {
    std::string text = "\n\n";
    const auto add = [&](const std::string& name, const WheelCase& w, double step_s, const char* scheme) {
        Case c;
        c.wheel = w;
        const ControlledInertia body = controlled_inertia(make_scene(c, Stage::sinkage).wheel);
        text += fmt::format("{} hub,{:.5g},{:.5g},{}\n", name, 1e4 * step_s / body.mass_kg,
                            1e4 * step_s * step_s / body.mass_kg, scheme);
        text += fmt::format("{} torque,{:.5g},{:.5g},{}\n", name, 1e3 * step_s / body.inertia_kg_m2,
                            1e3 * step_s * step_s / body.inertia_kg_m2, scheme);
        if (step_s == 5e-6) return;  // the same wheel again
        const char* which = w.body == WheelBody::elastic ? "elastic" : "rigid_rim";
        out.measured(fmt::format("derivative_limit_drawbar_{}", which), 2 * body.mass_kg / 1e4, "s", "2 m/K_d");
        out.measured(fmt::format("derivative_limit_torque_{}", which), 2 * body.inertia_kg_m2 / 1e3, "s", "2 I/K_d");
    };
    WheelCase elastic, rigid;
    elastic.body = WheelBody::elastic;
    add("text Earth", elastic, 1e-5, "explicit");
    add("text Mars", elastic, 5e-6, "explicit");
    add("ours", rigid, 4e-5, "semi-implicit");
    return text;
}

/// The loops on a wheel in free fall: measured limit against 2 m/K_d, for rings of the rim.
bool wheel_runs_away(Case c, double step_s) {
    c.time_step_s = step_s, c.gravity_m_s2 = 0, c.bed.disc_count = 1, c.wheel.load_N = 0;
    const Scene scene = make_scene(c, Stage::sinkage);
    State state = make_initial_state(c);
    state.wheel = place_wheel(scene.wheel, {0.75, 1});
    state.control.drawbar.target = 0.75 + 1e-9;
    state.control.torque.target = 1e-9;
    Workspace work = make_workspace(scene, state);
    for (int n = 0; n < 3000; ++n) {
        step(scene, state, work);
        const RigidBody& rim = state.wheel.rim;
        if (!(std::fabs(rim.position_m.x - 0.75) < 1e-4 && std::fabs(rim.angle_rad) < 1e-3)) return true;
    }
    return false;
}

void map_rings(Output& out) {
    const bool quick = out.effort == Effort::quick;
    std::string text = "rings,loop,predicted_s,all_parts_s,measured_s\n";
    double worst = 0;
    const auto add = [&](std::int64_t rings, WheelBody body, bool torque) {
        Case c;
        c.wheel.body = body, c.wheel.rim_rings = rings, c.control.scheme = ControlScheme::explicit_;
        // The other loop is held back so that each shows its own limit.
        GainsCase& other = torque ? c.control.drawbar : c.control.torque;
        other.proportional *= 1e-3, other.integral *= 1e-3, other.derivative *= 1e-3;
        const Scene scene = make_scene(c, Stage::sinkage);
        double loop = 0;
        for (const StepLimit& l : find_case_limits(scene))
            if (l.group == (torque ? LimitGroup::torque_loop : LimitGroup::drawbar_loop)) loop = l.step_s;
        State at_rest;
        at_rest.wheel = place_wheel(scene.wheel, {0, 0});
        const FrozenMode mode = find_failing_mode(scene, at_rest, Movable::wheel);
        const double all = largest_stable_phase(Integrator::symplectic_euler, mode.damping_ratio) / mode.omega_rad_s;
        const double measured = scene::measure_largest_step(0.5 * all, 1.7 * all,
                                                            [&](double step_s) { return wheel_runs_away(c, step_s); });
        worst = std::max(worst, std::fabs(measured / all - 1));
        text += fmt::format("{},{},{:.5g},{:.5g},{:.5g}\n", body == WheelBody::elastic ? rings : 0,
                            torque ? "torque" : "drawbar", loop, all, measured);
    };
    for (const bool torque : {false, true}) {
        add(2, WheelBody::rigid_rim, torque);
        for (const std::int64_t rings :
             quick ? std::vector<std::int64_t>{2} : std::vector<std::int64_t>{1, 2, 3, 4, 6, 8})
            add(rings, WheelBody::elastic, torque);
        text += "\n\n";
    }
    out.write("pid_wheel.csv", text);
    out.measured("pid_wheel_error", worst, "-", "largest |measured/predicted − 1| of explicit loops on whole wheels");
}

/// Routh: K_i m = K_p K_d, whatever the scheme.
void map_windup(Output& out) {
    std::string text = "K_p_K_d,predicted_K_i,explicit_K_i,semi_implicit_K_i\n";
    double worst = 0;
    for (const double gain : {1.0, 10.0}) {
        double measured[2];
        for (const ControlScheme scheme : {ControlScheme::explicit_, ControlScheme::semi_implicit}) {
            // Half a hundredth of the loop's own time a step; growth tenfold.
            const auto grows = [&](double ki) {
                return runs_away(scheme, {gain, ki, gain}, 0.005 / gain, 10000000, 1e-5);
            };
            measured[scheme == ControlScheme::explicit_ ? 0 : 1] =
                scene::measure_largest_step(0.9 * gain * gain, 1.2 * gain * gain, grows);
        }
        text += fmt::format("{},{},{:.5g},{:.5g}\n", gain, gain * gain, measured[0], measured[1]);
        for (const double m : measured) worst = std::max(worst, std::fabs(m / (gain * gain) - 1));
        if (out.effort == Effort::quick) break;
    }
    out.write("pid_windup.csv", text);
    out.measured("windup_error", worst, "-", "largest |measured/predicted − 1| of K_i m = K_p K_d");
}

}  // namespace

void map_control(Output& out) {
    const std::string plane = map_plane(out);
    out.write("pid_plane.csv", plane + map_points(out));
    map_rings(out);
    map_windup(out);
}

}  // namespace ifedem::maps

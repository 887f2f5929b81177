#include "step/integrate_wheel.hpp"

#include "core/bitmath.hpp"
#include "step/central_difference.hpp"
#include "traction/control.hpp"

namespace ifedem {
namespace {

struct Targets {
    double x_m = 0;
    double angle_clockwise_rad = 0;
};

Targets next_targets(const Scene& scene, const State& state) {
    Targets t{state.control.drawbar.target, state.control.torque.target};
    if (scene.stage == Stage::travel) {
        const double dt = scene.dem.step_s;
        const double time = static_cast<double>(state.progress.step + 1) * dt;
        const TravelTarget speed = travel_target(scene.c.travel, scene.c.wheel, time);
        t.x_m += dt * speed.speed_m_s;
        t.angle_clockwise_rad += dt * speed.omega_clockwise_rad_s;
    }
    return t;
}

/// W: in full but for the beginning of a sinkage with a ramp.
double load_now_N(const Scene& scene, const State& state) {
    const double load = scene.wheel.load_N, ramp_s = scene.c.stages.load_ramp_s;
    if (scene.stage != Stage::sinkage || !(ramp_s > 0)) return load;
    return load * min_of(1.0, static_cast<double>(state.progress.step) * scene.dem.step_s / ramp_s);
}

/// c of Eq 2.8: of absolute damping only, that of the rigid-motion frame is among the forces.
double absolute_damping_kg_s(const WheelModel& m, std::uint32_t n) {
    return m.damping_frame == DampingFrame::absolute ? m.elements.damping_kg_s[n] : 0.0;
}

void advance_free_nodes(const Scene& scene, State& state, const WheelWorkspace& work, std::uint32_t except) {
    const WheelModel& m = scene.wheel;
    const double dt = scene.dem.step_s;
    for (const std::uint32_t n : m.free_node) {
        Vec2& v = state.wheel.velocity_m_s[n];
        const double mass = m.elements.mass_kg[n], c = absolute_damping_kg_s(m, n);
        if (n != except)
            v = {advance_velocity(v.x, work.force_N[n].x, mass, c, dt),
                 advance_velocity(v.y, work.force_N[n].y, mass, c, dt)};
    }
}

void move_free_nodes(const Scene& scene, State& state) {
    for (const std::uint32_t n : scene.wheel.free_node)
        state.wheel.position_m[n] += scene.dem.step_s * state.wheel.velocity_m_s[n];
}

/// The rim as one rigid body: its nodes' forces add up on it, and it carries its nodes along.
void advance_rigid_rim(const Scene& scene, State& state, const WheelWorkspace& work) {
    const WheelModel& m = scene.wheel;
    const ControlCase& control = scene.c.control;
    const double dt = scene.dem.step_s;
    RigidBody& rim = state.wheel.rim;
    Vec2 force = work.damping_on_body.force_N + Vec2{0, -load_now_N(scene, state)};
    double moment = work.damping_on_body.moment_Nm;
    for (const std::uint32_t n : m.mesh.rigid) {
        force += work.force_N[n];
        moment += cross(state.wheel.position_m[n] - rim.position_m, work.force_N[n]);
    }
    const double c = m.damping_frame == DampingFrame::absolute ? m.body_damping_1_s : 0.0;
    const Targets target = next_targets(scene, state);
    rim.velocity_m_s.x =
        advance_controlled(control.scheme, control.drawbar,
                           {m.body_mass_kg, c * m.body_mass_kg, rim.position_m.x, rim.velocity_m_s.x, force.x},
                           target.x_m, dt, state.control.drawbar);
    rim.velocity_m_s.y = advance_velocity(rim.velocity_m_s.y, force.y, m.body_mass_kg, c * m.body_mass_kg, dt);
    rim.omega_rad_s =
        -advance_controlled(control.scheme, control.torque,
                            {m.body_inertia_kg_m2, c * m.body_inertia_kg_m2, -rim.angle_rad, -rim.omega_rad_s, -moment},
                            target.angle_clockwise_rad, dt, state.control.torque);
    rim.position_m += dt * rim.velocity_m_s;
    rim.angle_rad += dt * rim.omega_rad_s;
    const CosSin turn = cos_sin(rim.angle_rad);
    for (const std::uint32_t n : m.mesh.rigid) {
        const Vec2 at = m.mesh.mesh.node_m[n];
        const Vec2 r{turn.cos * at.x - turn.sin * at.y, turn.sin * at.x + turn.cos * at.y};
        state.wheel.position_m[n] = rim.position_m + r;
        state.wheel.velocity_m_s[n] = rim.velocity_m_s + cross(rim.omega_rad_s, r);
    }
}

/// Mean clockwise angular velocity of the rim-surface nodes about the hub (the rate of Eq 3.4).
double mean_rim_spin(const WheelModel& m, const WheelState& w) {
    const Vec2 hub = w.position_m[m.mesh.hub], hub_v = w.velocity_m_s[m.mesh.hub];
    double sum = 0;
    for (const std::uint32_t n : m.mesh.rim_surface) {
        const Vec2 r = w.position_m[n] - hub;
        sum -= cross(r, w.velocity_m_s[n] - hub_v) / dot(r, r);
    }
    return sum / static_cast<double>(m.mesh.rim_surface.size());
}

/// T as equal tangential moments on the rim-surface nodes: T/(N r_n) on each, clockwise.
void add_torque(const WheelModel& m, WheelState& w, double torque_Nm, double dt) {
    const Vec2 hub = w.position_m[m.mesh.hub];
    const double share = torque_Nm / static_cast<double>(m.mesh.rim_surface.size());
    for (const std::uint32_t n : m.mesh.rim_surface) {
        const Vec2 r = w.position_m[n] - hub;
        const double scale = share / dot(r, r) * dt / m.elements.mass_kg[n];
        w.velocity_m_s[n] += scale * Vec2{r.y, -r.x};
    }
}

/// Inertia that the mean spin shows to T: 1 / (1/N² Σ 1/(m r²)).
double rim_inertia_kg_m2(const WheelModel& m, const WheelState& w) {
    const Vec2 hub = w.position_m[m.mesh.hub];
    double sum = 0;
    for (const std::uint32_t n : m.mesh.rim_surface) {
        const Vec2 r = w.position_m[n] - hub;
        sum += 1.0 / (m.elements.mass_kg[n] * dot(r, r));
    }
    const auto count = static_cast<double>(m.mesh.rim_surface.size());
    return count * count / sum;
}

/// The elastic rim: P and W at the hub node, T on the rim surface, θ its mean (the text's points of application).
void advance_elastic_rim(const Scene& scene, State& state, const WheelWorkspace& work) {
    const WheelModel& m = scene.wheel;
    const ControlCase& control = scene.c.control;
    const double dt = scene.dem.step_s;
    WheelState& w = state.wheel;
    const std::uint32_t hub = m.mesh.hub;
    const Targets target = next_targets(scene, state);
    advance_free_nodes(scene, state, work, hub);
    Vec2& v = w.velocity_m_s[hub];
    const double mass = m.elements.mass_kg[hub], c = absolute_damping_kg_s(m, hub);
    v.y = advance_velocity(v.y, work.force_N[hub].y - load_now_N(scene, state), mass, c, dt);
    v.x = advance_controlled(control.scheme, control.drawbar, {mass, c, w.position_m[hub].x, v.x, work.force_N[hub].x},
                             target.x_m, dt, state.control.drawbar);
    // The nodes have been advanced without T; the loop sees their mean spin as its free motion.
    const double spin = mean_rim_spin(m, w);
    static_cast<void>(advance_controlled(control.scheme, control.torque,
                                         {rim_inertia_kg_m2(m, w), 0.0, -w.rim.angle_rad, spin, 0.0},
                                         target.angle_clockwise_rad, dt, state.control.torque));
    add_torque(m, w, state.control.torque.output, dt);
    w.rim.omega_rad_s = -mean_rim_spin(m, w);
    w.rim.angle_rad += dt * w.rim.omega_rad_s;
    move_free_nodes(scene, state);
    w.rim.position_m = w.position_m[hub];
    w.rim.velocity_m_s = w.velocity_m_s[hub];
}

void add_to_series(const Scene& scene, State& state, const WheelWorkspace& work) {
    SeriesSums& s = state.series;
    s.steps += 1;
    s.drawbar_N += state.control.drawbar.output;
    s.torque_Nm += state.control.torque.output;
    for (const std::uint32_t n : scene.wheel.mesh.boundary) {
        const Vec2 f = work.contact_force_N[n];
        s.fx_positive_N += f.x > 0 ? f.x : 0.0;
        s.fx_negative_N += f.x < 0 ? f.x : 0.0;
        s.fy_N += f.y;
    }
    s.effective_radius_m += effective_radius_m(scene.wheel, state.wheel);
    s.hub_speed_m_s += state.wheel.rim.velocity_m_s.x;
    s.omega_clockwise_rad_s -= state.wheel.rim.omega_rad_s;
}

}  // namespace

void add_wheel_forces(const Scene& scene, const State& state, WheelWorkspace& work) {
    work.force_N = work.contact_force_N;
    if (scene.wheel.free_node.empty()) return;
    add_internal_force(scene.wheel.elements, state.wheel.position_m, work.force_N);
    work.damping_on_body = add_damping_forces(scene.wheel, state.wheel, work.force_N);
}

void integrate_wheel(const Scene& scene, State& state, const WheelWorkspace& work) {
    if (scene.wheel.body == WheelBody::elastic) {
        advance_elastic_rim(scene, state, work);
    } else {
        advance_free_nodes(scene, state, work, WheelMesh::no_node);
        move_free_nodes(scene, state);
        advance_rigid_rim(scene, state, work);
    }
    add_to_series(scene, state, work);
}

}  // namespace ifedem

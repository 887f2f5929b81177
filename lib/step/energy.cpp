#include "step/energy.hpp"

#include <cmath>

#include "dem/closed_pairs.hpp"
#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/convert.hpp"
#include "step/step.hpp"

namespace ifedem {
namespace {

double squared(double a) { return a * a; }

double kinetic_energy(const Disc& d) {
    const double v2 = squared(d.vx_m_s) + squared(d.vy_m_s);
    return 0.5 * (v2 + 0.5 * squared(d.omega_rad_s * d.radius_m)) / d.inverse_mass_1_kg;
}

/// A contact's geometry and relative velocities between two moving discs.
struct PairMotion {
    double overlap = 0, approach = 0, sliding = 0;
};
PairMotion pair_motion(const Disc& a, const Disc& b) {
    const Vec2 d{b.x_m - a.x_m, b.y_m - a.y_m};
    const double distance = norm(d), overlap = a.radius_m + b.radius_m - distance;
    if (overlap <= 0) return {overlap, 0, 0};
    const Vec2 normal = (1.0 / distance) * d, u{a.vx_m_s - b.vx_m_s, a.vy_m_s - b.vy_m_s};
    const double lever = distance / (a.radius_m + b.radius_m);
    return {overlap, dot(u, normal),
            cross(normal, u) + lever * (a.omega_rad_s * a.radius_m + b.omega_rad_s * b.radius_m)};
}

/// `at` with velocities half-way between two steps.
Disc midway(const Disc& at, const Disc& after) {
    Disc d = at;
    d.vx_m_s = 0.5 * (at.vx_m_s + after.vx_m_s);
    d.vy_m_s = 0.5 * (at.vy_m_s + after.vy_m_s);
    d.omega_rad_s = 0.5 * (at.omega_rad_s + after.omega_rad_s);
    return d;
}

double spring_energy(const ContactConstants& k, double spring_m) {
    return 0.5 * k.tangential_stiffness_N_m * squared(spring_m);
}

void add_pair_losses(const Scene& scene, const std::vector<Disc>& before, const std::vector<double>& springs_before,
                     const State& after, const DemWorkspace& work, EnergyFlow& flow) {
    const double dt = scene.dem.step_s;
    const ContactConstants& k = scene.dem.soil;
    for (std::size_t n = 0; n < work.i.size(); ++n) {
        const Disc &a = before[work.i[n]], &b = before[work.j[n]];
        const double released = spring_energy(k, springs_before[n]) - spring_energy(k, after.pairs.tangential_m[n]);
        const PairMotion seen = pair_motion(a, b);
        flow.lost_tangential_W += released / dt;
        if (seen.overlap <= 0) continue;
        const PairMotion mean =
            pair_motion(midway(a, after.discs.disc[work.i[n]]), midway(b, after.discs.disc[work.j[n]]));
        const auto f = contact_forces(k, seen.overlap, seen.approach, seen.sliding, work.damping_Ns_m[n],
                                      springs_before[n], dt, 0.0);
        flow.lost_normal_W += (f.normal_N - k.normal_stiffness_N_m * seen.overlap) * mean.approach;
        flow.lost_tangential_W += f.tangential_N * mean.sliding;
    }
}

/// The same for a contact with a wall or the wheel, whose force is known.
void add_boundary_losses(const ContactConstants& k, const Disc& mean, Vec2 normal, const BoundaryForce& f,
                         Vec2 surface_velocity, double old_spring_m, double dt, EnergyFlow& flow) {
    flow.lost_tangential_W += (spring_energy(k, old_spring_m) - spring_energy(k, f.tangential_spring_m)) / dt;
    if (f.overlap_m <= 0) return;
    const Vec2 u = Vec2{mean.vx_m_s, mean.vy_m_s} - surface_velocity;
    flow.lost_normal_W += (f.normal_N - k.normal_stiffness_N_m * f.overlap_m) * dot(u, normal);
    flow.lost_tangential_W += f.tangential_N * (cross(normal, u) + mean.omega_rad_s * f.arm_m);
}

void add_wall_losses(const Scene& scene, const std::vector<Disc>& before, const std::vector<double>& springs_before,
                     const State& after, const DemWorkspace& work, EnergyFlow& flow) {
    for (std::size_t n = 0; n < work.wall.size(); ++n) {
        const std::uint32_t p = work.wall[n].position;
        const WallSide side = find_wall_side(scene.dem, work.wall[n].wall, before[p]);
        const BoundaryForce f =
            boundary_force(scene.dem.wall, scene.dem.damping_ratio, before[p], side.normal, side.distance_m,
                           side.opposite_radius_m, side.velocity_m_s, springs_before[n], scene.dem.step_s);
        add_boundary_losses(scene.dem.wall, midway(before[p], after.discs.disc[p]), side.normal, f, side.velocity_m_s,
                            springs_before[n], scene.dem.step_s, flow);
    }
}

void add_rolling_losses(const Scene& scene, const std::vector<Disc>& before, const State& after,
                        const DemWorkspace& work, EnergyFlow& flow) {
    const double dt = scene.dem.step_s;
    for (std::size_t p = 0; p < before.size(); ++p) {
        const Disc& d = before[p];
        const double inertia = 0.5 * squared(d.radius_m) / d.inverse_mass_1_kg;
        const double free = d.omega_rad_s + dt / inertia * (d.radius_m * work.kept_force[p].turning_N);
        const double omega = after.discs.disc[p].omega_rad_s;
        flow.lost_rolling_W += (free - omega) * inertia / dt * 0.5 * (d.omega_rad_s + omega);
    }
}

void add_wheel_losses(const Scene& scene, const std::vector<Disc>& before, const WheelState& wheel_before,
                      const State& after, const WheelWorkspace& work, EnergyFlow& flow) {
    const WheelModel& m = scene.wheel;
    const auto mean_velocity = [&](std::uint32_t n) {
        return 0.5 * (wheel_before.velocity_m_s[n] + after.wheel.velocity_m_s[n]);
    };
    for (const WheelContact& c : work.contact) {
        const Vec2 surface = (1.0 - c.share) * mean_velocity(c.from) + c.share * mean_velocity(c.to);
        add_boundary_losses(scene.dem.wheel, midway(before[c.position], after.discs.disc[c.position]),
                            Vec2{0, 0} - c.outward, c.on_disc, surface, c.old_spring_m, scene.dem.step_s, flow);
    }
    const RigidBody &rim0 = wheel_before.rim, &rim1 = after.wheel.rim;
    flow.torque_W = -after.control.torque.output * 0.5 * (rim0.omega_rad_s + rim1.omega_rad_s);
    flow.drawbar_W = after.control.drawbar.output * 0.5 * (rim0.velocity_m_s.x + rim1.velocity_m_s.x);
    const bool absolute = m.damping_frame == DampingFrame::absolute;
    const RigidMotion frame = absolute ? RigidMotion{} : damping_frame(m, wheel_before);
    for (const std::uint32_t n : m.free_node) {
        const Vec2 seen = wheel_before.velocity_m_s[n] - frame.velocity_m_s -
                          cross(frame.omega_rad_s, wheel_before.position_m[n] - frame.centre_m);
        flow.lost_wheel_W += m.elements.damping_kg_s[n] * dot(absolute ? mean_velocity(n) : seen, mean_velocity(n));
    }
    const Vec2 rim_velocity = 0.5 * (rim0.velocity_m_s + rim1.velocity_m_s);
    const double rim_omega = 0.5 * (rim0.omega_rad_s + rim1.omega_rad_s);
    const Vec2 seen =
        rim0.velocity_m_s - frame.velocity_m_s - cross(frame.omega_rad_s, rim0.position_m - frame.centre_m);
    flow.lost_wheel_W +=
        m.body_damping_1_s *
        (m.body_mass_kg * dot(absolute ? rim_velocity : seen, rim_velocity) +
         m.body_inertia_kg_m2 * (absolute ? rim_omega : rim0.omega_rad_s - frame.omega_rad_s) * rim_omega);
}

void add_soil_losses(const Scene& scene, const std::vector<Disc>& before, const SoilState& soil_before,
                     const State& after, const SoilWorkspace& work, EnergyFlow& flow) {
    const auto mean_velocity = [&](std::uint32_t n) {
        return 0.5 * (soil_before.velocity_m_s[n] + after.soil.velocity_m_s[n]);
    };
    const auto add_contact = [&](const ContactConstants& k, const SurfaceContact& c) {
        const Vec2 surface = (1.0 - c.share) * mean_velocity(c.from) + c.share * mean_velocity(c.to);
        add_boundary_losses(k, midway(before[c.position], after.discs.disc[c.position]), Vec2{0, 0} - c.outward,
                            c.on_disc, surface, c.old_spring_m, scene.dem.step_s, flow);
    };
    for (const SurfaceContact& c : work.contact) add_contact(scene.soil.contact, c);
    for (const SurfaceContact& c : work.attached.contact) add_contact(scene.dem.soil, c);
    for (const SoilNode& n : work.node)
        flow.lost_wheel_W += n.damping_kg_s * dot(mean_velocity(n.number), mean_velocity(n.number));
}

double stored_in_contact(const ContactConstants& k, double overlap_m, double spring_m) {
    return overlap_m > 0 ? 0.5 * k.normal_stiffness_N_m * squared(overlap_m) + spring_energy(k, spring_m) : 0.0;
}

void add_soil_energy(const Scene& scene, const State& state, const SoilWorkspace& work, EnergyStore& e) {
    for (const SurfaceContact& c : work.contact)
        e.springs_J += stored_in_contact(scene.soil.contact, c.on_disc.overlap_m, c.on_disc.tangential_spring_m);
    for (const SurfaceContact& c : work.attached.contact)
        e.springs_J += stored_in_contact(scene.dem.soil, c.on_disc.overlap_m, c.on_disc.tangential_spring_m);
    for (const SoilNode& n : work.node) {
        const Vec2 v = state.soil.velocity_m_s[n.number];
        e.kinetic_soil_J += 0.5 * n.mass_kg * dot(v, v);
        e.height_soil_J -= n.mass_kg * dot(scene.soil.gravity_m_s2, state.soil.position_m[n.number]);
    }
    e.strain_J += strain_energy_J(work.elements, state.soil.position_m);
}

std::vector<double> springs_of(const std::vector<BoundaryContact>& contacts) {
    std::vector<double> springs;
    for (const BoundaryContact& c : contacts) springs.push_back(c.tangential_m);
    return springs;
}

}  // namespace

EnergyStore measure_energy(const Scene& scene, const State& state, const Workspace& work) {
    EnergyStore e;
    for (const Disc& d : state.discs.disc) {
        e.kinetic_discs_J += kinetic_energy(d);
        e.height_discs_J -= dot(scene.dem.gravity_m_s2, {d.x_m, d.y_m}) / d.inverse_mass_1_kg;
    }
    const auto& disc = state.discs.disc;
    for_each_closed_pair(disc, work.dem, [&](const ClosedPair& c) {
        e.springs_J += stored_in_contact(scene.dem.soil, c.overlap_m, state.pairs.tangential_m[c.number]);
    });
    for (std::size_t n = 0; n < work.dem.wall.size(); ++n) {
        const Disc& d = disc[work.dem.wall[n].position];
        const WallSide side = find_wall_side(scene.dem, work.dem.wall[n].wall, d);
        e.springs_J += stored_in_contact(scene.dem.wall, d.radius_m + side.opposite_radius_m - side.distance_m,
                                         state.wall_contacts[n].tangential_m);
    }
    if (scene.has_soil_elements()) add_soil_energy(scene, state, work.soil, e);
    if (!scene.has_wheel()) return e;
    for (const auto& contact : work.wheel.contact)
        e.springs_J +=
            stored_in_contact(scene.dem.wheel, contact.on_disc.overlap_m, contact.on_disc.tangential_spring_m);
    const WheelModel& m = scene.wheel;
    for (const std::uint32_t n : m.free_node)
        e.kinetic_wheel_J +=
            0.5 * m.elements.mass_kg[n] * dot(state.wheel.velocity_m_s[n], state.wheel.velocity_m_s[n]);
    const RigidBody& rim = state.wheel.rim;
    if (m.body != WheelBody::elastic)
        e.kinetic_wheel_J += 0.5 * m.body_mass_kg * dot(rim.velocity_m_s, rim.velocity_m_s) +
                             0.5 * m.body_inertia_kg_m2 * squared(rim.omega_rad_s);
    if (!m.free_node.empty()) e.strain_J += strain_energy_J(m.elements, state.wheel.position_m);
    e.height_load_J = m.load_N * rim.position_m.y;
    return e;
}

EnergyFlow step_and_measure(const Scene& scene, State& state, Workspace& work) {
    // step() would do these first: list positions now hold for the whole step.
    convert_at_boundary(scene, state, work);
    update_lists(scene.dem, state, work.dem);
    const std::vector<Disc> discs = state.discs.disc;
    const std::vector<double> pair_springs = state.pairs.tangential_m, wall_springs = springs_of(state.wall_contacts);
    const WheelState wheel = state.wheel;
    const SoilState soil = state.soil;
    work.dem.keep_forces = true;
    step(scene, state, work);
    work.dem.keep_forces = false;
    EnergyFlow flow;
    add_pair_losses(scene, discs, pair_springs, state, work.dem, flow);
    add_wall_losses(scene, discs, wall_springs, state, work.dem, flow);
    add_rolling_losses(scene, discs, state, work.dem, flow);
    if (scene.has_soil_elements()) add_soil_losses(scene, discs, soil, state, work.soil, flow);
    if (scene.has_wheel()) add_wheel_losses(scene, discs, wheel, state, work.wheel, flow);
    return flow;
}

void add_to_ledger(EnergyLedger& ledger, const EnergyFlow& flow, double interval_s) {
    ledger.work_torque_J += flow.torque_W * interval_s;
    ledger.work_drawbar_J += flow.drawbar_W * interval_s;
    ledger.lost_normal_J += flow.lost_normal_W * interval_s;
    ledger.lost_tangential_J += flow.lost_tangential_W * interval_s;
    ledger.lost_rolling_J += flow.lost_rolling_W * interval_s;
    ledger.lost_wheel_J += flow.lost_wheel_W * interval_s;
}

}  // namespace ifedem

// Hand-made scenes of a few discs, walls and wheels.
#pragma once
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/bitmath.hpp"
#include "core/random.hpp"
#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/scene.hpp"
#include "step/step.hpp"

namespace ifedem::scene {

/// What one simulation consists of, kept together.
struct World {
    Scene scene;
    State state;
    Workspace work;
};

/// A soil of Table 3-3's stiffness without gravity, friction or rolling resistance: tests add what they look at.
inline constexpr double stiffness_N_m = 1e5;

inline ContactConstants make_contact(double normal_N_m, double tangential_N_m, double friction,
                                     ContactEnd end = ContactEnd::no_attraction, double rolling_half_chords = 0) {
    ContactConstants k;
    k.normal_stiffness_N_m = normal_N_m;
    k.tangential_stiffness_N_m = tangential_N_m;
    k.inverse_tangential_stiffness_m_N = 1.0 / tangential_N_m;
    k.friction = friction;
    k.damping_ratio_of_ratios = std::sqrt(tangential_N_m / normal_N_m);
    k.rolling_chords = 0.5 * rolling_half_chords;
    k.smallest_normal_N = end == ContactEnd::no_attraction ? 0.0 : -std::numeric_limits<double>::infinity();
    return k;
}

/// The same contact between everything, no walls.
inline DemConstants make_dem(const ContactConstants& contact, double damping_ratio, double step_s,
                             double gravity_m_s2 = 0) {
    DemConstants k;
    k.soil = k.wall = k.wheel = contact;
    k.damping_ratio = damping_ratio;
    k.step_s = step_s;
    k.gravity_m_s2 = {0, -gravity_m_s2};
    return k;
}

inline Disc make_disc(Vec2 at_m, double radius_m, double mass_kg, Vec2 velocity_m_s = {}, double omega_rad_s = 0) {
    Disc d;
    d.x_m = at_m.x, d.y_m = at_m.y;
    d.vx_m_s = velocity_m_s.x, d.vy_m_s = velocity_m_s.y;
    d.omega_rad_s = omega_rad_s;
    d.radius_m = radius_m;
    d.inverse_mass_1_kg = 1.0 / mass_kg;
    return d;
}

inline double mass_of(const Disc& d) { return 1.0 / d.inverse_mass_1_kg; }
inline double inertia_of(const Disc& d) { return 0.5 * mass_of(d) * d.radius_m * d.radius_m; }
inline Vec2 centre_of(const Disc& d) { return {d.x_m, d.y_m}; }
inline Vec2 velocity_of(const Disc& d) { return {d.vx_m_s, d.vy_m_s}; }

/// Numbers the discs from 0. One thread: these scenes are too small to share.
inline State make_state(std::vector<Disc> discs, Integrator integrator = Integrator::symplectic_euler) {
    omp_set_num_threads(1);
    State s;
    s.discs.disc = std::move(discs);
    for (std::uint32_t n = 0; n < s.discs.disc.size(); ++n) s.discs.id.push_back(n);
    if (integrator != Integrator::symplectic_euler) s.discs.acceleration.resize(s.discs.disc.size());
    return s;
}

inline void fit_radii(DemConstants& k, const std::vector<Disc>& discs) {
    k.smallest_radius_m = k.largest_radius_m = discs.front().radius_m;
    for (const Disc& d : discs) {
        k.smallest_radius_m = std::fmin(k.smallest_radius_m, d.radius_m);
        k.largest_radius_m = std::fmax(k.largest_radius_m, d.radius_m);
    }
}

/// Discs alone: step() as in consolidation.
inline World make_world(DemConstants k, const std::vector<Disc>& discs,
                        Integrator integrator = Integrator::symplectic_euler) {
    World w;
    fit_radii(k, discs);
    w.scene.c.integrator = integrator;
    w.scene.dem = std::move(k);
    w.state = make_state(discs, integrator);
    w.work = make_workspace(w.scene, w.state);
    w.work.dem.keep_forces = true;
    return w;
}

inline void advance(World& w, std::int64_t steps) {
    for (std::int64_t n = 0; n < steps; ++n) step(w.scene, w.state, w.work);
}

/// List position of the disc that began as number `id`.
inline std::size_t position_of(const World& w, std::uint32_t id) {
    for (std::size_t p = 0; p < w.state.discs.id.size(); ++p)
        if (w.state.discs.id[p] == id) return p;
    return w.state.discs.id.size();
}
inline const Disc& disc_of(const World& w, std::uint32_t id) { return w.state.discs.disc[position_of(w, id)]; }

/// The force on a disc at the last evaluation.
inline const DiscForce& force_on(const World& w, std::size_t position) { return w.work.dem.kept_force[position]; }

/// Forces that move nothing.
inline void evaluate_forces(World& w, double spring_step_s) {
    add_forces(w.scene.dem, w.state, w.work.dem, spring_step_s,
               [](const Block&, std::span<DiscForce> force) { std::ranges::fill(force, DiscForce{}); });
}

/// `count` discs of 2 to 3 mm, none overlapping by more than a tenth of a radius, in a box of about `fill` of their
/// area.
inline std::vector<Disc> scatter_discs(std::size_t count, double fill, double speed_m_s, Random& random,
                                       double& side_m) {
    side_m = 2 * 0.003 + std::sqrt(static_cast<double>(count) * pi * 0.0025 * 0.0025 / fill);
    std::vector<Disc> discs;
    const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    for (std::size_t tries = 0; discs.size() < count && tries < 2000 * count; ++tries) {
        const double r = between(0.002, 0.003);
        const Vec2 at{between(r, side_m - r), between(r, side_m - r)};
        bool fits = true;
        for (const Disc& d : discs) fits = fits && norm(centre_of(d) - at) > 0.95 * (d.radius_m + r);
        if (!fits) continue;
        const Vec2 v{between(-speed_m_s, speed_m_s), between(-speed_m_s, speed_m_s)};
        discs.push_back(make_disc(at, r, 260 * pi * r * r, v, between(-1, 1) * speed_m_s / r));
    }
    return discs;
}

/// Four flat walls around [0, side]².
inline std::vector<FlatWall> make_box(double side_m) {
    return {{{0, 0}, {0, 1}}, {{0, 0}, {1, 0}}, {{side_m, 0}, {-1, 0}}, {{0, side_m}, {0, -1}}};
}

/// Fixed discs shoulder to shoulder along the floor and the sides of [0, side]², open at the top as the bin is.
inline std::vector<WallDisc> make_box_of_discs(double side_m, double radius_m) {
    std::vector<WallDisc> walls;
    for (double s = -radius_m; s < side_m + radius_m; s += 2 * radius_m) {
        walls.push_back({{s, -radius_m}, radius_m});
        walls.push_back({{-radius_m, s + 2 * radius_m}, radius_m});
        walls.push_back({{side_m + radius_m, s + 2 * radius_m}, radius_m});
    }
    return walls;
}

struct Momentum {
    Vec2 linear_Ns;
    double angular_Nms = 0;  ///< about the origin, spins included
};
inline Momentum momentum_of(const State& state) {
    Momentum m;
    for (const Disc& d : state.discs.disc) {
        m.linear_Ns += mass_of(d) * velocity_of(d);
        m.angular_Nms += mass_of(d) * cross(centre_of(d), velocity_of(d)) + inertia_of(d) * d.omega_rad_s;
    }
    return m;
}

/// A case at the beginning of its consolidation, one thread.
inline World begin(const Case& c) {
    omp_set_num_threads(1);
    World w;
    w.scene = make_scene(c, Stage::consolidation);
    w.state = make_initial_state(c);
    begin_stage(w.scene, w.state);
    w.work = make_workspace(w.scene, w.state);
    return w;
}

}  // namespace ifedem::scene

// One disc on an inclined plane: sliding, rolling and Eq 2.18 in closed form.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/dem_scenes.hpp"

namespace ifedem::scene {

inline constexpr double earth_gravity_m_s2 = 9.81;
inline constexpr double disc_mass = 0.0075, disc_radius = 0.003, plane_stiffness = 1e6, plane_step = 5e-6;

/// A disc at rest on a plane through the origin that falls to the right by `slope`, pressed in by its own weight.
inline World make_disc_on_plane(double slope, double friction, double rolling_chords, Vec2 along_and_spin = {}) {
    DemConstants dem = make_dem(
        make_contact(plane_stiffness, plane_stiffness / 4, friction, ContactEnd::no_attraction, rolling_chords), 0.2,
        plane_step, earth_gravity_m_s2);
    const Vec2 normal{std::sin(slope), std::cos(slope)}, down{std::cos(slope), -std::sin(slope)};
    dem.flat_walls = {{{0, 0}, normal}};
    const double height = disc_radius - disc_mass * earth_gravity_m_s2 * std::cos(slope) / plane_stiffness;
    return make_world(dem,
                      {make_disc(height * normal, disc_radius, disc_mass, along_and_spin.x * down, along_and_spin.y)});
}

/// Acceleration down the slope and angular acceleration (clockwise) over the second half of `time_s`.
struct Acceleration {
    double along = 0, clockwise = 0;
};
inline Acceleration run_down(World& w, double slope, double time_s) {
    const Vec2 down{std::cos(slope), -std::sin(slope)};
    const auto half = static_cast<std::int64_t>(0.5 * time_s / plane_step);
    advance(w, half);
    const Disc before = disc_of(w, 0);
    advance(w, half);
    const Disc& after = disc_of(w, 0);
    const double t = static_cast<double>(half) * plane_step;
    return {dot(velocity_of(after) - velocity_of(before), down) / t, -(after.omega_rad_s - before.omega_rad_s) / t};
}

// The contact's arm is r less the overlap of 2.5e-5 r: the closed forms hold for a rigid disc to about that.
inline constexpr double rigid_tolerance = 1e-4;

/// Full chord of a disc pressed on a plane by its weight.
inline double chord_m(double slope) {
    const double overlap = disc_mass * earth_gravity_m_s2 * std::cos(slope) / plane_stiffness;
    return 2 * std::sqrt(overlap * (2 * disc_radius - overlap));
}

/// A disc set sliding on a flat plane: when it rolls, and how fast. Closed: v0/(3 µ g) and 2/3.
struct Launch {
    static constexpr double speed_m_s = 0.3;
    double time_s = 0, speed_share = 0, slip_m_s = 0;
};
inline Launch launch_sliding(double friction) {
    World w = make_disc_on_plane(0, friction, 0, {Launch::speed_m_s, 0});
    const auto slip = [&] { return disc_of(w, 0).vx_m_s + disc_of(w, 0).omega_rad_s * disc_radius; };
    int steps = 0;
    for (; slip() > 0 && steps < 100000; ++steps) advance(w, 1);
    advance(w, 20000);
    return {steps * plane_step, disc_of(w, 0).vx_m_s / Launch::speed_m_s, slip()};
}

/// A disc that may not turn (a rolling resistance without end) is a block; its state when it should have stopped.
inline Disc stop_block(double friction, double speed_m_s) {
    World w = make_disc_on_plane(0, friction, 1e9, {speed_m_s, 0});
    advance(w, static_cast<std::int64_t>((speed_m_s / (friction * earth_gravity_m_s2) + 0.02) / plane_step));
    return disc_of(w, 0);
}

/// A column of equal discs at rest: the sum of its overlaps in m g/K_n, and the worst overlap's relative error.
struct Column {
    double sum = 0, worst = 0;
    std::vector<double> overlap;  ///< from the floor upwards
};
inline Column settle_column(int count) {
    constexpr double mass = 0.005, radius = 0.0025;
    std::vector<Disc> discs;
    for (int k = 0; k < count; ++k) discs.push_back(make_disc({0, (2 * k + 1) * radius}, radius, mass));
    DemConstants dem = make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, 0.6), 0.7, 3e-5, earth_gravity_m_s2);
    dem.flat_walls = {{{0, 0}, {0, 1}}};
    World w = make_world(dem, discs);
    advance(w, 30000);
    const double unit = mass * earth_gravity_m_s2 / stiffness_N_m;
    double below = -radius;
    Column column;
    for (int k = 0; k < count; ++k) {
        const double overlap = 2 * radius - (disc_of(w, static_cast<std::uint32_t>(k)).y_m - below);
        below = disc_of(w, static_cast<std::uint32_t>(k)).y_m;
        column.worst = std::fmax(column.worst, std::fabs(overlap / ((count - k) * unit) - 1));
        column.sum += overlap / unit;
        column.overlap.push_back(overlap / unit);
    }
    return column;
}

/// A disc that spins on a frictionless plane under Eq 2.18: ω when half of the closed form's stopping time has gone,
/// and, of 1000 steps after the whole of it, the largest |ω| and how often it changed sign.
struct SpinDown {
    static constexpr double omega_rad_s = 50;
    double closed_time_s = 0, half_way_share = 0, largest_after_rad_s = 0;
    int reversals = 0;
};
inline double spin_loss_rad_s2() {
    return chord_m(0) * disc_mass * earth_gravity_m_s2 / (0.5 * disc_mass * disc_radius * disc_radius);
}
inline SpinDown spin_down(RollingScheme scheme) {
    World w = make_disc_on_plane(0, 0, 2, {0, SpinDown::omega_rad_s});
    w.scene.dem.rolling = scheme;
    SpinDown result;
    result.closed_time_s = SpinDown::omega_rad_s / spin_loss_rad_s2();
    const auto half = static_cast<std::int64_t>(0.5 * result.closed_time_s / plane_step);
    advance(w, half);
    result.half_way_share = disc_of(w, 0).omega_rad_s / SpinDown::omega_rad_s;
    advance(w, half + 10);
    for (int n = 0; n < 1000; ++n) {
        const double before = disc_of(w, 0).omega_rad_s;
        advance(w, 1);
        result.reversals += before * disc_of(w, 0).omega_rad_s < 0 ? 1 : 0;
        result.largest_after_rad_s = std::fmax(result.largest_after_rad_s, std::fabs(disc_of(w, 0).omega_rad_s));
    }
    return result;
}

}  // namespace ifedem::scene

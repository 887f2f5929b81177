// Discs that collide with each other and with a wall, and what linear spring and dashpot make of it in closed form.
#pragma once
#include <cmath>
#include <cstdint>

#include "support/dem_scenes.hpp"

namespace ifedem::scene {

inline const char* name_of(Integrator i) {
    if (i == Integrator::symplectic_euler) return "symplectic";
    return i == Integrator::modified_euler_one ? "modified-1" : "modified-2";
}

// ---- Head-on collision of two discs: linear spring and dashpot ----------------------------------------------------

/// Restitution and duration of δ̈ + 2ζω δ̇ + ω²δ = 0 from touch to the end of the contact.
struct Impact {
    double restitution = 0;
    double duration_omega = 0;  ///< t ω0
};

/// Ends where the overlap does: half a damped period. Ends where the force does (no attraction): Schwager & Pöschel
/// 2007.
inline Impact closed_form(double zeta, ContactEnd end) {
    const double damped = std::sqrt(1 - zeta * zeta);
    const double phase = end == ContactEnd::attraction ? pi : pi - std::atan2(2 * zeta * damped, 1 - 2 * zeta * zeta);
    return {std::exp(-zeta / damped * phase), phase / damped};
}

/// Where the contact begins: exactly at a step, or anywhere between two, shared evenly by many pairs of discs.
enum class Entry { at_a_step, spread };

/// What the code makes of it: the mean over the pairs (for spread entries without their noise) and the worst of them.
struct Measured {
    double mean_restitution = 0, mean_duration_omega = 0;
    double worst_error = 0;  ///< of restitution, relative
};

inline Measured collide(double zeta, ContactEnd end, Integrator integrator, double step_share, Entry entry) {
    constexpr double mass = 0.005, radius = 0.0025, approach = 0.2;
    const std::size_t pairs = entry == Entry::spread ? 64 : 1;
    const double omega = std::sqrt(stiffness_N_m / (mass / 2));
    const Impact exact = closed_form(zeta, end);
    const double dt = step_share * exact.duration_omega / omega;
    std::vector<Disc> discs;
    for (std::size_t k = 0; k < pairs; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(pairs),
                     y = 0.02 * static_cast<double>(k);
        const double gap = entry == Entry::spread ? share * approach * dt : -1e-16;
        discs.push_back(make_disc({0, y}, radius, mass, {approach / 2, 0}));
        discs.push_back(make_disc({2 * radius + gap, y}, radius, mass, {-approach / 2, 0}));
    }
    World w = make_world(make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, 0, end), zeta, dt), discs, integrator);
    if (integrator != Integrator::symplectic_euler && entry == Entry::at_a_step) {
        const double first = 2 * zeta * omega * approach / 2;  // C δ̇ / m: the dashpot acts at once
        w.state.discs.acceleration = {{-first, 0, 0, 0}, {first, 0, 0, 0}};
    }
    double pushes = 0;
    for (int n = 0; n < static_cast<int>(1.4 / step_share) + 3; ++n) {
        advance(w, 1);
        for (std::size_t p = 0; p < discs.size(); ++p) pushes += force_on(w, p).x_N != 0 ? 0.5 : 0.0;
    }
    Measured m;
    for (std::uint32_t k = 0; k < pairs; ++k) {
        const double e = (disc_of(w, 2 * k + 1).vx_m_s - disc_of(w, 2 * k).vx_m_s) / approach;
        m.mean_restitution += e / static_cast<double>(pairs);
        m.worst_error = std::fmax(m.worst_error, std::fabs(e / exact.restitution - 1));
    }
    m.mean_duration_omega = pushes / static_cast<double>(pairs) * dt * omega;
    return m;
}

/// ζ that gives a wanted restitution, by bisection of the closed form.
inline double find_damping_ratio(double restitution, ContactEnd end) {
    double low = 0, high = 0.707;  // e falls from 1; the atan2 branch ends at 1/√2
    for (int n = 0; n < 100; ++n) {
        const double middle = 0.5 * (low + high);
        (closed_form(middle, end).restitution > restitution ? low : high) = middle;
    }
    return low;
}

/// Chung & Ooi 2011, test 3: mean of rebound over impact speed of many discs that fall on a wall, e put in through ζ.
inline double rebound_over_impact(double wanted, ContactEnd end) {
    constexpr int side_by_side = 64;
    constexpr double mass = 2.6e-4, radius = 0.0025, speed = 3.9, stiffness = 1e8;
    const double zeta = find_damping_ratio(wanted, end),
                 dt = closed_form(zeta, end).duration_omega / std::sqrt(stiffness / mass) / 1000;
    std::vector<Disc> discs;
    for (int k = 0; k < side_by_side; ++k)
        discs.push_back(
            make_disc({0.02 * k, radius + speed * dt * (k + 0.5) / side_by_side}, radius, mass, {0, -speed}));
    DemConstants dem = make_dem(make_contact(stiffness, stiffness / 4, 0, end), zeta, dt);
    dem.flat_walls = {{{0, 0}, {0, 1}}};
    World w = make_world(dem, discs);
    advance(w, 1400);
    double mean = 0;
    for (const Disc& d : w.state.discs.disc) mean += d.vy_m_s / speed / side_by_side;
    return mean;
}

/// Test 4: oblique impact on a wall at an angle from the normal. Above tan θ = 3 µ (1 + e) a disc slides throughout,
/// and then the friction impulse is µ times the normal one, whatever the law.
struct ObliqueImpact {
    static constexpr double mass = 2.618e-4, radius = 0.0025, speed = 3.9, friction = 0.092, restitution = 0.98;
    double normal = 0, tangential = 0, spin_rad_s = 0;                    ///< rebound over impact; clockwise
    double closed_tangential = 0, closed_spin_rad_s = 0, coming_m_s = 0;  ///< `coming`: tangential, before
};
inline ObliqueImpact strike_wall(double degrees) {
    constexpr double stiffness = 1e10, friction = ObliqueImpact::friction, e = ObliqueImpact::restitution,
                     mass = ObliqueImpact::mass, radius = ObliqueImpact::radius, speed = ObliqueImpact::speed;
    const double zeta = find_damping_ratio(e, ContactEnd::no_attraction);
    const double dt = closed_form(zeta, ContactEnd::no_attraction).duration_omega / std::sqrt(stiffness / mass) / 1000;
    const double angle = degrees * pi / 180, vt = speed * std::sin(angle), vn = speed * std::cos(angle);
    DemConstants dem = make_dem(make_contact(stiffness, stiffness / 4, friction), zeta, dt);
    dem.flat_walls = {{{0, 0}, {0, 1}}};
    World w = make_world(dem, {make_disc({0, radius + 0.5 * vn * dt}, radius, mass, {vt, -vn})});
    advance(w, 1400);
    const Disc& d = disc_of(w, 0);
    return {d.vy_m_s / vn,
            d.vx_m_s / vt,
            -d.omega_rad_s,
            1 - friction * (1 + e) / std::tan(angle),
            2 * friction * (1 + e) * vn / radius,
            vt};
}

/// Test 7: two equal discs with the same spin collide head-on at 0.2 m/s. Turning the picture by 180° changes nothing.
struct SpinningPair {
    static constexpr double friction = 0.4, radius = 0.0025, approach_m_s = 0.2;
    double omega_a_rad_s = 0, omega_b_rad_s = 0, tangential_a_m_s = 0, tangential_b_m_s = 0;
    double restitution = 0, momentum_per_mass_m_s = 0;
};
inline SpinningPair collide_spinning(double omega_rad_s) {
    constexpr double radius = SpinningPair::radius, speed = SpinningPair::approach_m_s;
    const DemConstants dem =
        make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, SpinningPair::friction), 0.1, 5e-6);
    const Vec2 n{0.6, 0.8}, centre = (radius + 1e-11) * n;
    World w = make_world(dem, {make_disc(Vec2{} - centre, radius, 0.005, speed * n, omega_rad_s),
                               make_disc(centre, radius, 0.005, -speed * n, omega_rad_s)});
    advance(w, 400);
    const Disc &a = disc_of(w, 0), &b = disc_of(w, 1);
    return {a.omega_rad_s,
            b.omega_rad_s,
            cross(n, velocity_of(a)),
            cross(n, velocity_of(b)),
            -dot(n, velocity_of(a)) / speed,
            norm(velocity_of(a) + velocity_of(b))};
}

}  // namespace ifedem::scene

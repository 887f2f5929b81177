// Two discs that oscillate about a touch: the step limit of a contact in closed form.
#pragma once
#include <cmath>

#include "support/dem_scenes.hpp"

namespace ifedem::scene {

inline constexpr double squeeze_N = 0.1, soft_N_m = 100, pair_mass = 0.005, pair_radius = 0.0025;

/// Two discs held together by soft frictionless walls, so that they can oscillate about a touch.
inline World make_squeezed_pair(double zeta, double tangential_N_m, double dt) {
    DemConstants dem = make_dem(make_contact(stiffness_N_m, tangential_N_m, 1e3), zeta, dt);
    dem.wall = make_contact(soft_N_m, soft_N_m, 0);
    const double first = pair_radius - squeeze_N / soft_N_m,
                 second = first + 2 * pair_radius - squeeze_N / stiffness_N_m;
    dem.flat_walls = {{{0, 0}, {1, 0}}, {{second + first, 0}, {-1, 0}}};
    return make_world(dem,
                      {make_disc({first, 0}, pair_radius, pair_mass), make_disc({second, 0}, pair_radius, pair_mass)});
}

/// Growth a step of a mode that flips sign at every step, and the largest amplitude in 100 steps, times the first.
inline double growth_a_step(World w, double Disc::*speed, double kick) {
    w.state.discs.disc[0].*speed = kick;
    w.state.discs.disc[1].*speed = speed == &Disc::omega_rad_s ? kick : -kick;
    advance(w, 40);
    const double early = std::fabs(disc_of(w, 0).*speed);
    advance(w, 20);
    return std::pow(std::fabs(disc_of(w, 0).*speed) / early, 1.0 / 20);
}
inline double largest_amplification(World w, double Disc::*speed, double kick) {
    w.state.discs.disc[0].*speed = kick;
    w.state.discs.disc[1].*speed = speed == &Disc::omega_rad_s ? kick : -kick;
    double largest = 0;
    for (int n = 0; n < 100; ++n) {  // later the squeezed pair buckles sideways, as it should
        advance(w, 1);
        largest = std::fmax(largest, std::fabs(disc_of(w, 0).*speed) / kick);
    }
    return largest;
}

// Symplectic steps of ẍ + 2ζω ẋ + ω²x = 0 with a lagged dashpot: λ² − (2 − Ω² − 2ζΩ) λ + 1 − 2ζΩ = 0, Ω = ω Δt. λ = −1
// at Ω = 2 (√(1+ζ²) − ζ): without damping the pair normal limit 2/√(2k/m).
inline double flip_factor(double zeta, double big_omega) {
    const double trace = 2 - big_omega * big_omega - 2 * zeta * big_omega, product = 1 - 2 * zeta * big_omega;
    return 0.5 * (trace - std::sqrt(trace * trace - 4 * product));
}

}  // namespace ifedem::scene

#pragma once
#include <cmath>

#include "support/dem_scenes.hpp"

namespace ifedem::scene {

/// A column of equal discs between floor and ceiling, squeezed so that no contact opens under a small disturbance.
inline World make_squeezed_column(int count, double damping_ratio, double step_s, Integrator integrator) {
    constexpr double radius = 0.002, mass = 0.0032, overlap = 2e-5;
    DemConstants k = make_dem(make_contact(stiffness_N_m, 0.25 * stiffness_N_m, 0.0), damping_ratio, step_s);
    const double pitch = 2 * radius - overlap;
    std::vector<Disc> discs;
    for (int n = 0; n < count; ++n) discs.push_back(make_disc({0.05, radius - overlap + n * pitch}, radius, mass));
    const double top = 2 * (radius - overlap) + (count - 1) * pitch;
    k.flat_walls = {{{0, 0}, {0, 1}}, {{0, top}, {0, -1}}};
    return make_world(k, discs, integrator);
}

/// Whether a disc goes a thousand times as far from where the discs rest now as a speed of `start` takes it in a step.
/// (Looking at velocities in the end would not do: modified Euler with two evaluations runs to a false rest beside the
/// true one.)
template <class Disturb>
bool grows(World w, double start, const Disturb& disturb) {
    std::vector<Vec2> rest(w.state.discs.disc.size());
    for (std::size_t p = 0; p < rest.size(); ++p)
        rest[w.state.discs.id[p]] = {w.state.discs.disc[p].x_m, w.state.discs.disc[p].y_m};
    disturb(w.state.discs.disc);
    for (int n = 0; n < 4000; ++n) {
        advance(w, 1);
        for (std::size_t p = 0; p < rest.size(); ++p) {
            const Disc& d = w.state.discs.disc[p];
            const double gone = norm(Vec2{d.x_m, d.y_m} - rest[w.state.discs.id[p]]);
            if (!(gone < 1000 * start * w.scene.dem.step_s)) return true;
        }
    }
    return false;
}

inline bool column_grows(int count, double damping_ratio, double step_s, Integrator integrator) {
    constexpr double start = 1e-6;
    return grows(make_squeezed_column(count, damping_ratio, step_s, integrator), start, [&](std::vector<Disc>& discs) {
        for (std::size_t n = 0; n < discs.size(); ++n)
            discs[n].vy_m_s = (n % 2 == 0 ? start : -start) * (1 + 0.1 * static_cast<double>(n));
    });
}

/// The largest step at which a system does not grow, by bisection between one that does not and one that does.
template <class Grows>
double measure_largest_step(double stable_s, double unstable_s, const Grows& grows) {
    for (int n = 0; n < 12; ++n) {
        const double middle = std::sqrt(stable_s * unstable_s);
        (grows(middle) ? unstable_s : stable_s) = middle;
    }
    return std::sqrt(stable_s * unstable_s);
}

}  // namespace ifedem::scene

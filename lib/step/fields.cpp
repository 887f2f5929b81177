#include "step/fields.hpp"

#include <cmath>

#include "core/bitmath.hpp"

namespace ifedem {

DiscFields measure_fields(const Scene& scene, const State& state, const Workspace& work) {
    const auto& disc = state.discs.disc;
    std::vector<double> sum(disc.size(), 0.0);  // Σ arm · spring force over the contacts of a disc
    for (std::size_t n = 0; n < work.dem.i.size(); ++n) {
        const Disc &a = disc[work.dem.i[n]], &b = disc[work.dem.j[n]];
        const double overlap = a.radius_m + b.radius_m - norm({b.x_m - a.x_m, b.y_m - a.y_m});
        if (overlap <= 0) continue;
        const double force = scene.dem.soil.normal_stiffness_N_m * overlap;
        sum[work.dem.i[n]] += (a.radius_m - 0.5 * overlap) * force;
        sum[work.dem.j[n]] += (b.radius_m - 0.5 * overlap) * force;
    }
    DiscFields fields;
    for (std::size_t p = 0; p < disc.size(); ++p) {
        const Disc& d = disc[p];
        const double volume = pi * d.radius_m * d.radius_m * scene.c.soil.thickness_m;
        fields.speed_m_s.push_back(static_cast<float>(std::sqrt(d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s)));
        fields.pressure_Pa.push_back(static_cast<float>(0.5 * sum[p] / volume));
    }
    return fields;
}

}  // namespace ifedem

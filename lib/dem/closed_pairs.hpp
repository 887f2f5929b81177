#pragma once
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Two discs of the inner list that touch.
struct ClosedPair {
    std::size_t number = 0;      ///< in the inner list: its spring is pairs.tangential_m[number]
    std::uint32_t i = 0, j = 0;  ///< list positions
    Vec2 normal;                 ///< unit, from i to j
    double distance_m = 0, overlap_m = 0;
};

/// Calls f(ClosedPair) in list order, for what is measured between steps; the step has its own loop (pair_kernel.hpp).
template <class F>
void for_each_closed_pair(const std::vector<Disc>& disc, const DemWorkspace& work, F&& f) {
    for (std::size_t n = 0; n < work.i.size(); ++n) {
        const Disc &a = disc[work.i[n]], &b = disc[work.j[n]];
        const Vec2 between{b.x_m - a.x_m, b.y_m - a.y_m};
        const double distance = norm(between), overlap = a.radius_m + b.radius_m - distance;
        if (overlap > 0) f(ClosedPair{n, work.i[n], work.j[n], (1.0 / distance) * between, distance, overlap});
    }
}

}  // namespace ifedem

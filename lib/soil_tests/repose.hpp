#pragma once
#include <cstdint>
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

// Angle of repose: a column of sand whose right wall is taken away from the top downwards, one wall disc at a time, so
// that the sand spills slowly. (Taking the wall away at once measures the run-out of a collapse instead.)

struct ReposeScene {
    std::int64_t discs = 0;
    double column_m = 0, floor_m = 0, wall_radius_m = 0;
    double gate_m = 0;  ///< height of the wall that is taken away
    double pace_s =
        0;  ///< for one of its discs; ten times as long to settle before, twelve times to come to rest after
};

/// Chapter 2's 0.12 m of column on 0.8 m of floor at 0.05 s a wall disc, in largest radii of another sand.
[[nodiscard]] ReposeScene scale_repose(const Case& sand, std::int64_t discs);

struct Repose {
    double angle_deg = 0;  ///< slope of the surface between 15 and 85 % of its height, by least squares; NaN if flat
    std::vector<Disc> discs;
};

/// Filled, at rest, then spilt, all with the sand's friction: between discs, and with floor and gate.
[[nodiscard]] Repose spill(const Case& sand, const ReposeScene& scene);

}  // namespace ifedem

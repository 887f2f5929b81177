#pragma once
#include <cstdint>
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// A rigid plate of wall discs pressed into the program's own bed at a constant speed, from its first touch down to a
/// quarter of its width. It is a fifth as wide as the bin, the sand's friction_wall below it and at its sides.
struct PlatePress {
    double width_m = 0;
    std::vector<double> sinkage_m, pressure_Pa;  ///< a point is a mean over a hundredth of the way
    std::vector<Disc> discs;                     ///< at the end
};

/// Consolidated as the program does it, then with the sand's friction.
[[nodiscard]] PlatePress press_plate(const Case& sand, std::int64_t discs);

}  // namespace ifedem

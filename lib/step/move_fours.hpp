#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"

namespace ifedem {

/// A block's discs as plain pointers: what is built for newer instructions uses no library code, see core/pack.hpp.
struct MotionBatch {
    Disc* disc = nullptr;
    const DiscForce* force = nullptr;
    const Reference* from = nullptr;  ///< where the inner skins begin
    const double* spin_per_moment = nullptr;
    std::uint32_t count = 0;
    double step_s = 0, fall_x_m_s = 0, fall_y_m_s = 0;
    bool rolling_springs = false;
};

/// Moves four discs at a time, with the bits of integrate_symplectic()'s loop under RollingScheme::limit: the first
/// count / 4 × 4. Returns whether one of them has left its inner skin. Needs AVX2.
bool move_fours(const MotionBatch& batch);

}  // namespace ifedem

#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"

namespace ifedem {

/// A block's discs as plain pointers: what is built for newer instructions uses no library code, see core/pack.hpp.
struct MotionBatch {
    Disc* disc = nullptr;
    DiscForce* force = nullptr;       ///< taken: zeros are left
    const Reference* from = nullptr;  ///< where the inner skins begin
    const double* spin_per_moment = nullptr;
    std::uint32_t count = 0;
    double step_s = 0, fall_x_m_s = 0, fall_y_m_s = 0;
    double calm_m_s = 0;  ///< see move_fours()
    bool rolling_springs = false;
};

/// Moves four discs at a time, with the bits of integrate_symplectic()'s loop under RollingScheme::limit: the first
/// count / 4 × 4. Returns whether all are calm, that is, no faster than `calm_m_s`. Needs AVX2.
bool move_fours(const MotionBatch& batch);

struct Watch {
    bool left = false;   ///< one has left its inner skin
    double spare_m = 0;  ///< else the least that one may still go, beside rounding
    double fastest_m_s = 0;
};

/// The same discs where they stand. Needs AVX2.
Watch watch_fours(const MotionBatch& batch);

}  // namespace ifedem

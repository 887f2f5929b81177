#pragma once
#include <functional>
#include <span>

#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// What to do with a block and the complete forces on its discs. It takes them: zeros are to be left.
using BlockVisitor = std::function<void(Block&, std::span<DiscForce>)>;

/// Work that neither reads what add_forces() writes nor writes what it reads.
struct Alongside {
    std::function<void()> work;
    double blocks = 0;  ///< what it costs, in blocks of discs
};

/// The forces of all contacts of discs with discs and walls and, from work.wheel_force, with the wheel; tangential
/// springs advance by `spring_step_s` (0 evaluates without advancing). Calls `finished` for each block as soon as its
/// sums are complete and no pair still to come reads its discs, while they are in the cache. One thread a block at
/// most; the order of every sum is fixed by the lists. The first thread does the work alongside before its blocks, of
/// which it gets so many fewer.
void add_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s,
                const BlockVisitor& finished, const Alongside& alongside = {});

/// A disc against a body of infinite mass at distance `centre_distance_m` along the unit vector `normal` (from the disc
/// to the body): force on the disc, what turns it and its rolling limit, and the new spring.
struct BoundaryForce {
    Vec2 force_N;
    double turning_N = 0;  ///< moment over the radius
    double rolling_limit_Nm = 0;
    double tangential_spring_m = 0;
    double overlap_m = 0;
    double normal_N = 0, tangential_N = 0, arm_m = 0;  ///< for the energy account
    [[nodiscard]] DiscForce on_disc() const { return {force_N.x, turning_N, force_N.y, rolling_limit_Nm}; }
};
/// `opposite_radius_m` is 0 for a straight surface. The dashpot takes the disc's mass alone.
[[nodiscard]] BoundaryForce boundary_force(const ContactConstants& k, double damping_ratio, const Disc& disc,
                                           Vec2 normal, double centre_distance_m, double opposite_radius_m,
                                           Vec2 surface_velocity_m_s, double old_spring_m, double spring_step_s);

/// From a disc's centre to its contact point, which divides the distance to another disc as the radii do; on a straight
/// surface (opposite radius 0) it is the foot.
[[nodiscard]] inline double contact_arm_m(double distance_m, double radius_m, double opposite_radius_m) {
    return opposite_radius_m > 0 ? distance_m * radius_m / (radius_m + opposite_radius_m) : distance_m;
}

/// Of a contact's springs alone, on the disc that `normal` points away from; overlap > 0.
[[nodiscard]] inline Vec2 spring_force_N(const ContactConstants& k, Vec2 normal, double overlap_m, double spring_m) {
    return Vec2{} - (k.normal_stiffness_N_m * overlap_m * normal +
                     k.tangential_stiffness_N_m * spring_m * Vec2{-normal.y, normal.x});
}

/// Where a wall (flat, or one disc of it) stands as seen from a disc.
struct WallSide {
    Vec2 normal;  ///< unit, from the disc to the wall
    double distance_m = 0;
    double opposite_radius_m = 0;
    Vec2 velocity_m_s = {};
};
/// Walls are numbered flat ones first, then discs.
[[nodiscard]] WallSide find_wall_side(const DemConstants& k, std::uint32_t wall, const Disc& d);

}  // namespace ifedem

#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Fills work.force with the forces of all disc–disc contacts and advances their tangential springs by `spring_step_s`
/// (0 evaluates without advancing). One thread a block at most; the order of every sum is fixed by the lists.
void add_pair_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s);

/// Adds the forces of flat walls or wall discs to the discs' own slots.
void add_wall_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s);

/// A disc against a body of infinite mass at distance `centre_distance_m` along the unit vector `normal` (from the disc
/// to the body): force on the disc, its moment and rolling limit, and the new spring.
struct BoundaryForce {
    Vec2 force_N;
    double moment_Nm = 0;
    double rolling_limit_Nm = 0;
    double tangential_spring_m = 0;
    double overlap_m = 0;
    double normal_N = 0, tangential_N = 0, arm_m = 0;  ///< for the energy account
};
/// `opposite_radius_m` is 0 for a straight surface. The dashpot takes the disc's mass alone.
[[nodiscard]] BoundaryForce boundary_force(const ContactConstants& k, double damping_ratio, const Disc& disc,
                                           Vec2 normal, double centre_distance_m, double opposite_radius_m,
                                           Vec2 surface_velocity_m_s, double old_spring_m, double spring_step_s);

/// Where a wall (flat, or one disc of it) stands as seen from a disc.
struct WallSide {
    Vec2 normal;  ///< unit, from the disc to the wall
    double distance_m = 0;
    double opposite_radius_m = 0;
};
[[nodiscard]] WallSide find_wall_side(const DemConstants& k, std::uint32_t wall, const Disc& d);

/// Advances velocities and positions by the symplectic Euler rule v += a Δt, x += v Δt (v stands at half steps).
/// Notes in work.block_moved which blocks have a disc that left its inner skin.
void integrate_symplectic(const DemConstants& k, State& state, DemWorkspace& work);

/// Angular velocity after a step whose other moments alone would give `omega_free`, with rolling resistance (Eq 2.18):
/// as a limit it can stop but never reverse the rotation.
[[nodiscard]] double apply_rolling(RollingScheme rolling, double omega_free_rad_s, double omega_now_rad_s,
                                   double largest_change_rad_s);

}  // namespace ifedem

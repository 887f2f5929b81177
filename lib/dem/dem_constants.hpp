#pragma once
#include <cmath>
#include <vector>

#include "core/vec2.hpp"
#include "dem/contact_law.hpp"
#include "model/case.hpp"

namespace ifedem {

// How far a disc may go before a list is made anew; two discs closer than both their skins are listed. They are part of
// the results: a rebuild of the outer list sorts the discs anew and with them the order of sums. A few discs that a lug
// throws would wear out one skin for all, so a disc faster than the rms speed has wider ones in proportion.
// The fewest refreshes among six choices tried; their times differed by less than the machine's noise.
inline constexpr double outer_skin_m = 1.0e-3;
inline constexpr double inner_skin_m = 0.15e-3;
inline constexpr double largest_skin_m = 4e-3;
inline constexpr double swift_speed = 1;  ///< in rms speeds
/// Discs a block: the unit of parallel work and of summation; never the thread count, so that bits do not depend on it.
inline constexpr std::size_t discs_per_block = 1024;

/// A straight wall: the half-plane behind `point`, `normal` pointing into the soil.
struct FlatWall {
    Vec2 point_m;
    Vec2 normal;
};

/// A disc of a wall made of discs; fixed but in soil tests.
struct WallDisc {
    Vec2 centre_m;
    double radius_m = 0;
    Vec2 velocity_m_s = {};  ///< for its friction and dashpot; who moves it moves the centre too
};

/// What the soil is made of and stands in; constant within a stage.
struct DemConstants {
    ContactConstants soil;
    ContactConstants wall;
    ContactConstants wheel;
    double damping_ratio = 0;
    Vec2 gravity_m_s2;
    double step_s = 0;
    double smallest_radius_m = 0;
    double largest_radius_m = 0;
    RollingScheme rolling = RollingScheme::limit;
    /// Other codes' rolling resistance between discs instead of Eq 2.18: a spring K_s R_eff² on the relative rotation,
    /// capped at soil.rolling_cap × R_eff × f_n. For comparing costs only (tests/bench): no case asks for it, and its
    /// memory is in the workspace, so it is not saved.
    bool rolling_springs = false;
    std::vector<FlatWall> flat_walls;
    std::vector<WallDisc> wall_discs;
};

/// `friction_*` differ between consolidation and the later stages; everything else is the case's.
[[nodiscard]] DemConstants make_dem_constants(const Case& c, double friction_soil, double friction_wall);

/// 2 ζ √(K m): the dashpot of a pair of reduced mass m (Eq 2.17's C_n at damping ratio ζ).
[[nodiscard]] inline double dashpot_Ns_m(double damping_ratio, double stiffness_N_m, double reduced_mass_kg) {
    return 2.0 * damping_ratio * std::sqrt(stiffness_N_m * reduced_mass_kg);
}

}  // namespace ifedem

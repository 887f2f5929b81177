#pragma once
#include <vector>

#include "core/vec2.hpp"
#include "dem/contact_law.hpp"
#include "model/case.hpp"

namespace ifedem {

// Half-width of the neighbour search beyond touching. They are part of the results: a rebuild of the outer list sorts
// the discs anew and with them the order of sums. Measured optimum of rebuild cost against list length.
inline constexpr double outer_skin_m = 1.6e-3;
inline constexpr double inner_skin_m = 0.3e-3;
/// Discs a block: the unit of parallel work and of summation; never the thread count, so that bits do not depend on it.
inline constexpr std::size_t discs_per_block = 1024;

/// A straight wall: the half-plane behind `point`, `normal` pointing into the soil.
struct FlatWall {
    Vec2 point_m;
    Vec2 normal;
};

/// A fixed disc of a wall made of discs.
struct WallDisc {
    Vec2 centre_m;
    double radius_m = 0;
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
    std::vector<FlatWall> flat_walls;
    std::vector<WallDisc> wall_discs;
};

/// `friction_*` differ between consolidation and the later stages; everything else is the case's.
[[nodiscard]] DemConstants make_dem_constants(const Case& c, double friction_soil, double friction_wall);

/// 2 ζ √(K m): the dashpot of a pair of reduced mass m (Eq 2.17's C_n at damping ratio ζ).
[[nodiscard]] double dashpot_Ns_m(double damping_ratio, double stiffness_N_m, double reduced_mass_kg);

}  // namespace ifedem

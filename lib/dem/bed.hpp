#pragma once
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Discs of the case's radii (shares by number, shuffled by `bed.seed`) in rows shoulder to shoulder at the largest
/// radius, a small random shift each, from the floor upwards: "generated and filled into the bin" (section 3.2.2), not
/// yet settled.
[[nodiscard]] DiscState generate_bed(const Case& c);

/// List positions by the height of the discs' tops, the lowest first, ties by id.
[[nodiscard]] std::vector<std::uint32_t> sort_by_top(const DiscState& discs);

/// Levels the surface (section 4.2.4): of all discs the `count` with the lowest tops stay, ties by id. Ids are numbered
/// anew without gaps; contacts between what stays keep their springs.
void level_surface(State& state, std::size_t count);

/// Of the disc that reaches highest; 0 without discs.
[[nodiscard]] double highest_top_m(const DiscState& discs);

/// Porosity of the bed between `bottom_m` and `top_m`, over the bin's middle (`margin_m` from each side wall): 1 − area
/// of the discs cut by that rectangle / its area.
[[nodiscard]] double measure_porosity(const DiscState& discs, double length_m, double margin_m, double bottom_m,
                                      double top_m);

/// Height of the soil surface: mean over columns of width 4 r_max of the highest disc top.
[[nodiscard]] double measure_surface_m(const DiscState& discs, double length_m, double largest_radius_m);

/// Root mean square of the discs' speed.
[[nodiscard]] double rms_speed_m_s(const DiscState& discs);

}  // namespace ifedem

#pragma once
#include "model/case.hpp"

namespace ifedem {

// How large and how fine a scene is: what `ifedem doubt` makes more of and `ifedem fit` less. Each function takes a
// case and changes one thing; a factor of 1 changes nothing. Lengths come out in whole tenths of a millimetre.

/// Realisation k = 1, 2, …: packing seed k, and a lug phase of the golden section of the lugs' pitch times k − 1, so
/// that any number of phases is spread evenly (a smooth tread: the pitch of its columns).
[[nodiscard]] Case make_realisation(const Case& c, int k);

/// Depth of the bed, by the number of discs. A deeper bed also gets so much more time to settle.
[[nodiscard]] Case with_depth(const Case& c, double factor);

/// The bed's length, its discs, and the place where the wheel starts: `factor` times the soil behind the wheel, and at
/// least as many times the soil ahead of the travel's end.
[[nodiscard]] Case with_length(const Case& c, double factor);

/// What the bed has behind the wheel at the start, or ahead of it at the end of travel; the depth stays.
[[nodiscard]] Case with_soil_behind(const Case& c, double factor);
[[nodiscard]] Case with_soil_ahead(const Case& c, double factor);

/// Blocks of the top row that are discs at the start and stay so around the wheel, in the midst of which it stands; the
/// conversions' margin changes with them. Where they would leave the grid they end with it.
[[nodiscard]] Case with_region(const Case& c, double factor);

/// False where soil elements fix the bed's size.
[[nodiscard]] bool has_discs_only(const Case& c);

/// False without a region of discs between soil elements.
[[nodiscard]] bool has_region(const Case& c);

/// Radii of the discs, with as many more discs as fill the same bed.
[[nodiscard]] Case with_disc_radii(const Case& c, double factor);

/// Elements of the wheel in each direction: rings, and columns between lugs (at least one each; a lug stays one
/// column).
[[nodiscard]] Case with_mesh(const Case& c, double factor);

/// False for a plate, and for a wheel from a Gmsh file.
[[nodiscard]] bool can_refine_mesh(const Case& c);

[[nodiscard]] Case with_time_step(const Case& c, double factor);

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <vector>

#include "fem/mesh.hpp"

namespace ifedem {

/// Fills the circle of the mesh's first nodes (at `angle_rad`, on `rim_radius_m`) with quads: `rings` rings around a
/// block of a × b quads with rounded sides, 2 (a + b) = number of columns. Angles become equal on the way inwards, so
/// that the narrow columns under the lugs do not end in slivers. Returns the centre node. Throws Error(bad_input) if
/// the number of columns is not a multiple of four: no block with a centre node fits then.
std::uint32_t add_hub_core(Mesh& mesh, const std::vector<double>& angle_rad, double rim_radius_m, std::int64_t rings);

}  // namespace ifedem

#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec2.hpp"
#include "fem/mesh.hpp"
#include "model/case.hpp"

namespace ifedem {

/// The four-node quads of a Gmsh file, each with the name of its physical surface.
struct GmshMesh {
    std::vector<Vec2> node_m;  ///< as in the file, which must be in metres
    std::vector<std::array<std::uint32_t, 4>> quad;
    std::vector<std::string> group;  ///< one per quad
};

/// Reads the text of a Gmsh file, format 2.2 or 4.1, ASCII. Lines and points are passed over. Throws Error(bad_input),
/// "name:line: what is wrong (why). What to do?", for everything else that is no plane mesh of four-node quads.
[[nodiscard]] GmshMesh parse_gmsh(std::string_view text, const std::string& name);

/// A wheel from a mesh about its hub at the origin. Physical surfaces named rim, intermediate, surface and lug are its
/// parts; the contact surface is the outer loop of edges that belong to one quad; holes between spokes are free. The
/// rim surface is the loop around the hub (rigid and rigid-rim, for which quads of the rim are left out), or where rim
/// and layers meet (elastic, which needs a node at the hub). Turned by wheel.lug_phase_deg. Throws Error(bad_input),
/// also where the mesh contradicts wheel.rim_radius_m, tread_radius_m and lug_height_m, which other parts rely on.
[[nodiscard]] WheelMesh make_gmsh_wheel(const GmshMesh& mesh, const WheelCase& wheel, const std::string& name);

/// Both, from the file wheel.mesh_file, whose checksum must be wheel.mesh_checksum unless that is empty.
[[nodiscard]] WheelMesh read_gmsh_wheel(const WheelCase& wheel);

}  // namespace ifedem

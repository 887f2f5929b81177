#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"
#include "model/case.hpp"

namespace ifedem {

enum class Part : std::uint8_t { rim, intermediate, surface, lug };  ///< WR, WI, WS, WL of section 3.2.2

/// Four-node quads, nodes counter-clockwise.
struct Mesh {
    std::vector<Vec2> node_m;
    std::vector<std::array<std::uint32_t, 4>> quad;
    std::vector<Part> part;  ///< one per quad
};

/// A wheel about its hub at the origin, at angle 0.
struct WheelMesh {
    Mesh mesh;
    std::vector<std::uint32_t>
        boundary;  ///< outer loop, counter-clockwise; segment k runs from boundary[k] to the next
    std::vector<std::uint32_t> rim_surface;  ///< nodes at the rim radius: T acts here, θ is their mean (Eq 3.4)
    std::vector<std::uint32_t>
        rigid;  ///< nodes that move with the rim: rim surface (rigid rim), all (rigid), none (elastic)
    static constexpr std::uint32_t no_node = 0xffffffffU;
    std::uint32_t hub = no_node;  ///< centre node: W and P act here; only an elastic rim has one
};

/// Mesh of rings and columns with U-lugs (pairs of blocks with parallel sides, corners on the outermost circle).
/// Counter-clockwise from wheel.lug_phase_deg a pair is: lug, gap, lug, rest of the pitch; lug and gap are arcs at the
/// tread radius. With lug_pairs = 0 the tread is smooth, with smooth_columns columns (0: as many as twelve pairs would
/// have). Rigid and rigid-rim wheels carry no elements inside the rim; an elastic rim is rings around a block of quads
/// with the hub in its centre. Nodes and elements from the rim surface outwards are numbered alike whatever the body. A
/// plate is a rigid rectangle about the hub. With wheel.mesh_file a wheel's mesh is that file's (fem/gmsh.hpp). Throws
/// Error(bad_input) where the sizes contradict each other, by the rules of a case.
[[nodiscard]] WheelMesh make_wheel_mesh(const WheelCase& wheel);

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <vector>

#include "fem/elements.hpp"

namespace ifedem {

enum class PlaneFriction { none, stick };  ///< a node slides freely on the plane, or stays where it first touched

/// A rigid horizontal plane that nodes cannot pass downwards.
struct RigidPlane {
    double height_m = 0;
    PlaneFriction friction = PlaneFriction::none;
};

/// Which coordinates of the nodes are held (index 2·node for x, 2·node + 1 for y) and what pushes on the others.
struct Supports {
    std::vector<std::uint8_t> held;
    std::vector<Vec2> load_N;
};

/// Node positions in equilibrium and which nodes lie on the plane.
struct StaticState {
    std::vector<Vec2> position_m;
    std::vector<std::uint8_t> touching;
};

enum class Convergence { reached, failed };

/// Newton's method for internal force + load + reactions = 0 from the positions in `state`; held coordinates stay as
/// they are there. The tangent is the central difference of each element's force, so it needs no second derivation of
/// the corotational terms. Contact is an active set: a node joins when it is below the plane and leaves when the plane
/// would have to pull. On failure (no convergence, or a singular tangent) `state` is left as it was.
[[nodiscard]] Convergence find_equilibrium(const ElementSet& set, const Supports& supports, StaticState& state);
[[nodiscard]] Convergence find_equilibrium(const ElementSet& set, const Supports& supports, const RigidPlane& plane,
                                           StaticState& state);

/// Sum of the plane's upward push on the touching nodes.
[[nodiscard]] double plane_load_N(const ElementSet& set, const Supports& supports, const StaticState& state);

}  // namespace ifedem

#pragma once
#include "step/scene.hpp"

namespace ifedem {

/// Gathers contact, internal and damping forces of every node into work.force_N.
void add_wheel_forces(const Scene& scene, const State& state, WheelWorkspace& work);

/// Advances nodes and rim by the central difference (Eq 2.8 in its leapfrog form) under those forces, the load W, and
/// the drawbar pull P and torque T of the two control loops: W and P at the hub, T on the rim surface. During sinkage
/// the loops hold the hub's x and the rim's angle where they are.
void integrate_wheel(const Scene& scene, State& state, const WheelWorkspace& work);

}  // namespace ifedem

#pragma once
#include "step/scene.hpp"

namespace ifedem {

/// Advances the nodes of the soil's elements by the central difference (Eq 2.8) under work.force_N. Their damping acts
/// on the absolute velocity: unlike the wheel they have no motion of their own that it could brake.
void integrate_soil(const Scene& scene, State& state, const SoilWorkspace& work);

}  // namespace ifedem

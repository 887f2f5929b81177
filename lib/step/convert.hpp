#pragma once
#include "step/scene.hpp"

namespace ifedem {

/// The conversions that are due at the boundary before a step (section 5.2.2: every elements.conversion_interval_steps
/// steps of travel). Each is noted in state.soil.conversions with what it did to mass, momentum, energy and surface.
/// Doing it twice at one boundary is doing it once.
void convert_at_boundary(const Scene& scene, State& state, Workspace& work);

}  // namespace ifedem

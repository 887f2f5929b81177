#pragma once
#include "step/scene.hpp"

namespace ifedem {

/// One time step; the phase order of the whole program is in its body.
void step(const Scene& scene, State& state, Workspace& work);

}  // namespace ifedem

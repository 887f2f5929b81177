#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Cuts the discs into blocks and gives every block its halo; see README.md, "Blocks".
void lay_out_blocks(const State& state, DemWorkspace& work);

}  // namespace ifedem

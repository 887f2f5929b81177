#pragma once
#include <cstdint>
#include <vector>

#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Takes the discs at the list positions `remove` (ascending) out of the state and appends `add`. Ids are closed up in
/// their old order and the new discs get the next ones, so that they stay 0 … n − 1; contacts between discs that stay
/// keep their springs. The neighbour lists are made anew at once: the state that is left is that of a step's end.
void edit_discs(const DemConstants& k, const std::vector<std::uint32_t>& remove, const std::vector<Disc>& add,
                State& state, DemWorkspace& work);

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <vector>

#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Takes the discs out of the state whose list positions `stays` has as 0. Ids are closed up in their old order, so
/// that they stay 0 … n − 1; the lists' pairs and all contacts between what stays keep their order and springs.
void keep_discs(const std::vector<char>& stays, State& state);

/// Takes the discs at the list positions `remove` (ascending) out of the state and appends `add`. Ids are closed up in
/// their old order and the new discs get the next ones, so that they stay 0 … n − 1; contacts between discs that stay
/// keep their springs. The neighbour lists are made anew at once: the state that is left is that of a step's end.
void edit_discs(const DemConstants& k, const std::vector<std::uint32_t>& remove, const std::vector<Disc>& add,
                State& state, DemWorkspace& work);

}  // namespace ifedem

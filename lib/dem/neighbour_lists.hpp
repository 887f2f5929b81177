#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Brings the neighbour lists up to date where the workspace's flags ask for it. The outer rebuild sorts the discs by
/// cell (memory order = spatial order) and carries every tangential spring over to the pair's new place.
void update_lists(const DemConstants& k, State& state, DemWorkspace& work);

/// Makes a workspace for a state that has just been created or read: nothing in the state changes but empty lists.
void attach_workspace(const DemConstants& k, State& state, DemWorkspace& work);

}  // namespace ifedem

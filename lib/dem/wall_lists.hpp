#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Discs that may come near a wall before the next rebuild, seen from where they stood at the last one.
void find_outer_walls(const DemConstants& k, const State& state, DemWorkspace& work);

/// Candidates for wall contact in order of position and wall, springs carried over.
void refresh_wall_contacts(const DemConstants& k, State& state, DemWorkspace& work);

/// The candidates as they stand in the state.
void unpack_walls(const State& state, DemWorkspace& work);

}  // namespace ifedem

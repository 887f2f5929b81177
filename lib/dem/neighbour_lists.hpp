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

/// Whether the disc has gone further than its skin; written so that NaN counts as gone.
[[nodiscard]] inline bool has_left(const Disc& d, const Reference& from) {
    const double dx = d.x_m - from.x_m, dy = d.y_m - from.y_m;
    return !(dx * dx + dy * dy <= from.skin_m * from.skin_m);
}

/// After a step in which some disc has left its inner skin: the inner list is due, and the outer one if it cannot give
/// every disc a new inner skin within its outer one.
void ask_for_lists(const State& state, DemWorkspace& work);

}  // namespace ifedem

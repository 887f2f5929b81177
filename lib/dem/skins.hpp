#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Whether the disc has gone further than its skin; written so that NaN counts as gone.
[[nodiscard]] inline bool has_left(const Disc& d, const Reference& from) {
    const double dx = d.x_m - from.x_m, dy = d.y_m - from.y_m;
    return !(dx * dx + dy * dy <= from.skin_m * from.skin_m);
}

/// Where the discs stand now, with skins for a new outer list.
void note_outer_references(State& state);

/// The same for a new inner list. An inner skin ends where the outer one does, so that no pair can come near unseen.
void note_inner_references(State& state);

/// After a step in which some disc has left its inner skin: the inner list is due, and the outer one if it cannot give
/// every disc a new inner skin within its outer one.
void ask_for_lists(const State& state, DemWorkspace& work);

}  // namespace ifedem

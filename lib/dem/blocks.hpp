#pragma once
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Cuts the discs into blocks and gives every block its force slots; see README.md, "Blocks".
void lay_out_blocks(const State& state, DemWorkspace& work);

/// The force on the disc at a list position, once its block is finished.
[[nodiscard]] inline const DiscForce& force_on(const DemWorkspace& work, std::size_t position) {
    return work.force[work.block[position / discs_per_block].slot(static_cast<std::uint32_t>(position))];
}

}  // namespace ifedem

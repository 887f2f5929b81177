#pragma once
#include <string>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Writes into a run directory, if the run averaged contact forces:
///   contact_stress.csv   means over the window, a line a segment of the lower half
///   contact_blocks.csv   the sums of each block of the window, a line a segment with contacts; the segment after the
///                        last is for contacts on the upper half
///   contact_balance.csv  what the momentum balance of each block needs
void write_contact_stress(const std::string& directory, const Case& c, const StressState& stress);

/// The sums back, to the last bit. Throws Error(bad_input) if the run averaged none.
[[nodiscard]] StressState read_contact_stress(const std::string& directory, const Case& c);

}  // namespace ifedem

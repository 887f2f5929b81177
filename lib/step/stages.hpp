#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// consolidation → free sinkage → travel (section 2.6), each named by the hash of all that its end depends on.
[[nodiscard]] std::string stage_hash(const Case& c, Stage stage, int results_version);

/// What a run of all three stages costs: discs times steps, summed over the stages. Discs of the bed; those that blocks
/// of soil elements turn into are not foreseen.
[[nodiscard]] double count_disc_steps(const Case& c);

}  // namespace ifedem

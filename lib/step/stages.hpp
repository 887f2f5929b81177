#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// consolidation → free sinkage → travel (section 2.6), each named by the hash of all that its end depends on.
[[nodiscard]] std::string stage_hash(const Case& c, Stage stage, int results_version);

/// What a stage, or a run of all three stages, costs: discs times steps. Discs as planned for the beginning; those that
/// blocks of soil elements turn into later are not foreseen.
[[nodiscard]] double count_disc_steps(const Case& c, Stage stage);
[[nodiscard]] double count_disc_steps(const Case& c);

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

#include "check/run.hpp"
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Facts about the end of a stage: rest, porosity, surface.
[[nodiscard]] std::vector<RunValue> describe_stage(const Case& c, const State& state, Stage stage);

/// Facts about a run: program, machine, peak memory.
[[nodiscard]] std::vector<RunValue> describe_run(const Case& c, const State& state, int threads);

/// Largest resident size of the process so far.
[[nodiscard]] double peak_memory_MB();

/// "0.1.0", and what built it.
[[nodiscard]] std::string program_version();
[[nodiscard]] std::string compiler_name();

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

enum class Existing { refuse, replace };  ///< what `run` does with a directory that is already there
enum class Show { progress, nothing };
enum class UnstableStep { refuse, allow };  ///< what `run` does with a step beyond a limit

struct RunRequest {
    std::string case_path;
    std::string directory;
    std::string stage_cache = "build/stages";
    std::vector<Override> overrides;
    Stage last_stage = Stage::travel;  ///< an earlier one ends in the cache only
    int threads = 1;
    Existing existing = Existing::refuse;
    Show show = Show::progress;
    UnstableStep unstable_step = UnstableStep::refuse;
    bool profile = false;
    std::uint64_t stop_at_step = 0;  ///< of all stages together; 0: go on to the end
};

/// Simulates a case: stages found in the cache are taken from there, the travel is recorded in the directory. Returns
/// what the program returns.
[[nodiscard]] int run_case(const RunRequest& request);

/// Goes on from the directory's last checkpoint (from the beginning if it was stopped before the first,
/// or if the checkpoint or the results are damaged).
[[nodiscard]] int resume_case(const RunRequest& request);

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"

namespace ifedem {

struct SweepRequest {
    std::string case_path;
    std::string directory;
    std::string stage_cache = "build/stages";
    std::vector<Override> overrides;
    std::string slips;  ///< "0:70:10" or "0,20,60", %; empty: the case's own
    std::string loads;  ///< N; empty: the case's own
    int jobs = 1;
};

/// Runs a case for every load and slip, at most `jobs` at a time, and writes sweep.csv, curves, pictures and
/// index.html into the directory. Finished runs are kept, interrupted ones gone on with. Returns what the program
/// returns: done, health if a run was stopped by its health check, or 128 + a signal.
[[nodiscard]] int run_sweep(const SweepRequest& request);

/// "0:70:10" → 0, 10, …, 70 (the end belongs to it); "5,20" → 5, 20. Throws Error(bad_input), naming `option`.
[[nodiscard]] std::vector<double> parse_values(const std::string& text, const std::string& option);

}  // namespace ifedem

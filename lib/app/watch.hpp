#pragma once
#include <string>
#include <vector>

namespace ifedem {

struct WatchRequest {
    std::vector<std::string> directories;
};

/// Prints a line every few seconds, "7 of 12 runs done, 3 min left", until all runs are complete or its parent ends.
void watch_runs(const WatchRequest& request);

}  // namespace ifedem

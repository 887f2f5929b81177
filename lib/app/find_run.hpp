#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"

namespace ifedem {

struct FindRequest {
    std::string case_path;
    std::vector<Override> overrides;
    std::vector<std::string> directories;  ///< where a finished run may be
};

/// What a run would cost, and whether it is there already, as one line: disc-steps of the stages before travel,
/// disc-steps of travel, then the first of the directories that holds a finished run of the same case (whatever its
/// name) by this results version, or "-".
[[nodiscard]] std::string find_run(const FindRequest& request);

}  // namespace ifedem

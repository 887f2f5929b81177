#pragma once
#include <string>

namespace ifedem {

struct ConfinedRequest {
    std::string case_path;
    std::string directory;
};

/// Section 5.1.6 for the block's discs prepared as the case says and with their full mass: confined.csv (the curves of
/// Fig 5-8), stress.csv (σ_y of every disc, Fig 5-9) and measurements.csv. Throws Error.
void write_confined(const ConfinedRequest& request);

}  // namespace ifedem

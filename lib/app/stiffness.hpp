#pragma once
#include <string>
#include <vector>

namespace ifedem {

struct StiffnessRequest {
    std::vector<std::string> case_paths;
    std::string directory;
    double load_N = 0;  ///< of the secant; 0: each case's own
};

/// Writes stiffness.csv (wheel,phase_deg,deflection_m,load_N) and stiffness_summary.csv
/// (wheel,stiffness_N_mm,min_N_mm,max_N_mm): Eq 3.9 over one pitch of lug pairs.
void write_stiffness(const StiffnessRequest& request);

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

namespace ifedem {

struct StressRequest {
    std::vector<std::string> run_directories;
    std::string directory;       ///< for what comes out
    std::string soil_directory;  ///< of `ifedem soil`; "": no semi-empirical wheel
};

/// Contact stress of runs (chapter 4): groups them by slip, realisations together, and writes
///   measurements.csv   what claims refer to, one line a quantity
///   curves.csv         slip_percent,theta_deg and both stresses by both decompositions, means over realisations
///   angles.csv         entry, exit and peaks against slip with 95 % intervals
///   relative_peak.csv  θ'_M/θ'_1 against slip
///   performance.csv    H, P_d, R by the controllers and by the integrals
///   load.csv           W by the integrals
///   parametric.csv     the semi-empirical wheel on the same soil, with Wong & Reece's c1 and c2 of compact sand; then
///                      the travels beside it: slip, H, P_d, R by the controllers, the same by the integrals
/// Throws Error(bad_input) for a run without contact stress.
void write_stress(const StressRequest& request);

}  // namespace ifedem

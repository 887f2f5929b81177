#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/metrics.hpp"
#include "check/run.hpp"
#include "check/statistics.hpp"

namespace ifedem {

/// One point of a load–deflection curve of a wheel on a rigid flat.
struct StiffnessPoint {
    std::string wheel;
    double phase_deg = 0;
    double deflection_m = 0;
    double load_N = 0;
};
struct StiffnessSummary {
    std::string wheel;
    double stiffness_N_mm = 0;
    double least_N_mm = 0;  ///< over lug phases
    double most_N_mm = 0;
};

/// A run with its window means.
struct MeasuredRun {
    Run run;
    Condition condition;
    RunMetrics metrics;     ///< over the text's window, or the same share of a shorter travel
    std::string shortfall;  ///< why no claim may use it: "travelled 0.06 m of the 0.8 m …"; "" if all is well
};

/// All runs of a report, and the wheels' stiffness.
struct Campaign {
    std::vector<MeasuredRun> runs;  ///< sorted by condition, then by name
    std::vector<StiffnessSummary> stiffness;
    std::vector<StiffnessPoint> stiffness_points;
    std::vector<std::string> unusable;  ///< directories without a finished run, with the reason
};

/// Directories with case.toml are runs, directories with stiffness_summary.csv hold the wheels' stiffness; others are
/// noted as unusable, so that one run that failed does not take the report with it. Realisations of one condition must
/// differ in seed or lug phase and in nothing else that matters: else throws Error(bad_input).
[[nodiscard]] Campaign read_campaign(const std::vector<std::string>& directories);

/// Values of a metric by slip, for one wheel, gravity and load, by the text's averaging windows unless
/// another window is given. Runs with a shortfall are left out.
using ValuesBySlip = std::map<double, std::vector<double>>;
[[nodiscard]] ValuesBySlip collect(const Campaign& campaign, const std::string& wheel, const std::string& gravity,
                                   double load_N, double RunMetrics::*member,
                                   const std::optional<Window>& window = std::nullopt);

/// Scatter that all slips of such a set share.
[[nodiscard]] PooledScatter pool(const ValuesBySlip& values);

}  // namespace ifedem

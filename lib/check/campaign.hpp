#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/measurements.hpp"
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

/// What a variation of one input does to one metric under one condition, against the default's same realisations.
struct Effect {
    std::string variant;
    std::string changes;  ///< "contact.damping_ratio 0.2 → 0.1"
    std::string gravity;
    double load_N = 0;
    double slip_percent = 0;
    std::size_t n = 0;
    std::string metric;
    double before = 0, before_uncertainty = 0;  ///< the default's mean and U over these realisations
    double after = 0, after_uncertainty = 0;
    double effect = 0;
    double half_width = 0;  ///< 95 %; infinite if nothing tells the scatter
};

/// What more of one thing does to one quantity: a line of `ifedem doubt`.
struct Doubt {
    std::string variation;
    std::string changes;
    std::string quantity;  ///< "Pd"
    std::string units;
    std::size_t n = 0;
    double difference = 0, half_width = 0;  ///< infinite where a single pair tells no half-width
    double tolerance = 0;
    std::string verdict;
    double relative_cost = 0;
    std::string note;  ///< why it was not run
};

/// A run with its window means.
struct MeasuredRun {
    Run run;
    Condition condition;
    RunMetrics metrics;     ///< over the text's window, or the same share of a shorter travel
    std::string shortfall;  ///< why no claim may use it: "travelled 0.06 m of the 0.8 m …"; "" if all is well
};

/// All runs of a report, the wheels' stiffness, and what was measured otherwise.
struct Campaign {
    std::vector<MeasuredRun> runs;  ///< sorted by condition, then by name
    std::vector<StiffnessSummary> stiffness;
    std::vector<StiffnessPoint> stiffness_points;
    std::vector<Measurement> measurements;
    std::vector<Effect> effects;           ///< of a directory with effects.csv
    std::vector<Doubt> doubts;             ///< of a directory with doubt.csv
    std::vector<std::string> directories;  ///< as given; figures may draw files of theirs
    std::vector<std::string> unusable;     ///< directories without a finished run, with the reason
};

/// Directories with case.toml are runs, those with stiffness_summary.csv hold the wheels' stiffness, those with
/// measurements.csv whatever was measured, those with doubt.csv what `ifedem doubt` found; others are noted as
/// unusable, so that one run that failed does not take the report with it. Throws Error(bad_input) if a measurement's
/// name stands twice, or if realisations of one condition differ in more than seed and lug phase.
[[nodiscard]] Campaign read_campaign(const std::vector<std::string>& directories);

/// nullptr if nothing of this name was measured.
[[nodiscard]] const Measurement* find_measurement(const Campaign& campaign, const std::string& name);

/// U of a measurement with that of reading the text's number: its own, or by scatter and n; nothing where a single
/// value tells neither.
[[nodiscard]] std::optional<double> uncertainty_of(const Measurement& m, double reading);

/// What one curve over slip stands for.
struct Curve {
    std::string wheel;
    std::string gravity;
    double load_N = 0;
    auto operator<=>(const Curve&) const = default;
};
[[nodiscard]] bool is_on(const Curve& curve, const Condition& condition);

/// Values of a metric by slip on one curve, by the text's averaging windows unless another window is given. Runs with a
/// shortfall are left out.
using ValuesBySlip = std::map<double, std::vector<double>>;
[[nodiscard]] ValuesBySlip collect(const Campaign& campaign, const Curve& curve, const MetricInfo& metric,
                                   const std::optional<Window>& window = std::nullopt);

/// Scatter that all slips of such a set share.
[[nodiscard]] PooledScatter pool(const ValuesBySlip& values);

/// Scatter of one run where a curve has single runs: that of its own slips if these tell it well (6 degrees of
/// freedom); else that of all realisations on the planet, both wheels and all loads, in share of the load for forces.
struct BorrowedScatter {
    PooledScatter pooled;
    bool from_other_curves = false;
};
[[nodiscard]] BorrowedScatter borrow_scatter(const Campaign& campaign, const Curve& curve, const MetricInfo& metric,
                                             const std::optional<Window>& window = std::nullopt);

}  // namespace ifedem

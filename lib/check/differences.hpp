#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "check/metrics.hpp"
#include "check/statistics.hpp"

namespace ifedem {

/// A window mean by its short name: H, Pd, R, z, or a metric's own ("torque_Nm").
struct ComparedMetric {
    std::string name;
    const MetricInfo* metric = nullptr;
};

/// "H,Pd,z". Throws Error(bad_input), listing what there is.
[[nodiscard]] std::vector<ComparedMetric> parse_quantities(const std::string& text);

/// "5%" → 0.05, more than 0 and less than 100 %. Throws Error(bad_input).
[[nodiscard]] double parse_tolerance(const std::string& text);

/// What a change of a case does to one quantity, over realisations that share seed and lug phase.
struct Difference {
    double before = 0, after = 0;  ///< means
    PairedDifference paired;       ///< after − before, 95 %
    double tolerance = 0;          ///< as a share of |before|, in the quantity's unit
};

/// Needs equally many runs on both sides, in the same order; `tolerance` as a share.
[[nodiscard]] Difference find_difference(std::span<const RunMetrics> before, std::span<const RunMetrics> after,
                                         const ComparedMetric& quantity, double tolerance);

/// What to expect of a change without effect whose beds are other packings: 0 ± t s √(2/n), with the scatter s of n
/// runs.
[[nodiscard]] Difference expect_no_difference(std::span<const RunMetrics> runs, const ComparedMetric& quantity,
                                              double tolerance);

/// "Within scatter" as everywhere: the interval contains 0 and is narrower than the tolerance. It moves if the interval
/// does not contain 0, be it by less than the tolerance.
enum class Movement { moves, within_scatter, cannot_tell };
[[nodiscard]] Movement judge_movement(const Difference& difference);
[[nodiscard]] std::string_view to_text(Movement movement);  ///< "within scatter"

/// When a difference counts as less than the tolerance.
/// `shown`: |mean| + half-width ≤ tolerance. A change that truly makes a difference beyond the tolerance passes in less
/// than one case of forty, and more scatter makes it harder to pass, never easier.
/// `mean`: |mean| ≤ tolerance. That is what a few realisations can give where the scatter between packings exceeds the
/// tolerance. It shows nothing, but scatter does not help to pass it either: rules such as |mean| − half-width ≤
/// tolerance let everything pass that scatters enough.
enum class DifferenceEvidence { shown, mean };
[[nodiscard]] bool is_small(const Difference& difference, DifferenceEvidence evidence);

/// How many realisations would narrow the interval to the tolerance, if the differences scatter as these do; infinite
/// for a tolerance of 0.
[[nodiscard]] double realisations_needed(const Difference& difference);

}  // namespace ifedem

#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/statistics.hpp"
#include "check/verdict.hpp"

namespace ifedem {

/// Means over realisations by slip, with what is known of their errors.
struct TrendPoints {
    std::vector<double> slip_percent;
    std::vector<double> mean;
    std::vector<double> weight;       ///< 1/σ² of each mean; 1/n-scaled if no scatter is known
    std::vector<double> uncertainty;  ///< U of each point (no reading uncertainty: the text gives no number)
    std::vector<double> n;            ///< realisations of each point
    PooledScatter scatter;
    std::size_t runs = 0;
};
[[nodiscard]] TrendPoints trend_points(const ValuesBySlip& values, const PooledScatter& scatter);

/// What a judgement of curves found.
struct TrendResult {
    Finding finding = Finding::too_uncertain;
    std::optional<double> statistic;  ///< Kendall's τ in the claimed direction, the curvature's share of the rise, …
    double uncertainty = 0;
    std::string tolerance_text;
    std::optional<double> error_over_tolerance;
    std::string detail;
};

/// Monotonic: the weighted isotonic fit leaves no point by more than its U, and Kendall's τ is significant at 5 %.
/// Outside if the fit is left; too uncertain if τ is not significant. `direction` is +1 for increasing, −1 for
/// decreasing.
[[nodiscard]] TrendResult judge_monotonic(const TrendPoints& points, double direction);

/// Linear: the best parabola lies off its chord by at most `share` of the rise. Outside needs both a larger share and a
/// significant quadratic term (F-test with run errors, 5 %); too uncertain if the 95 % half-width of the share exceeds
/// the tolerance.
[[nodiscard]] TrendResult judge_linear(const TrendPoints& points, double share);

/// The one that decides for all: the worst finding, and the largest error among those. `names` go before the details.
[[nodiscard]] TrendResult combine(const std::vector<TrendResult>& results, const std::vector<std::string>& names);

}  // namespace ifedem

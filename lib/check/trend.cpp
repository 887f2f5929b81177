#include "check/trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/csv.hpp"

namespace ifedem {
namespace {

constexpr double significance = 0.05;

}  // namespace

TrendPoints trend_points(const ValuesBySlip& values, const PooledScatter& scatter) {
    TrendPoints points;
    points.scatter = scatter;
    const double s = points.scatter.deviation;
    const double variance = s > 0 ? s * s : 1;
    for (const auto& [slip, group] : values) {
        const auto n = static_cast<double>(group.size());
        points.slip_percent.push_back(slip);
        points.n.push_back(n);
        points.mean.push_back(mean(group));
        points.weight.push_back(n / variance);
        // The pooled scatter for all, so that a point with two lucky realisations does not pose as exact.
        const double freedom = points.scatter.degrees_of_freedom;
        points.uncertainty.push_back(freedom > 0 ? student_t_quantile(0.975, freedom) * s * std::sqrt(1 + 1 / n)
                                                 : std::numeric_limits<double>::infinity());
        points.runs += group.size();
    }
    return points;
}

TrendResult judge_monotonic(const TrendPoints& points, double direction) {
    std::vector<double> y = points.mean;
    for (double& v : y) v *= direction;
    const auto fit = isotonic_fit(y, points.weight);
    const auto rank = kendall(points.slip_percent, y);
    double worst = 0;
    for (std::size_t k = 0; k < y.size(); ++k) worst = std::max(worst, std::abs(y[k] - fit[k]) / points.uncertainty[k]);
    TrendResult result;
    result.statistic = rank.tau;
    result.tolerance_text = "U of each point, p 0.05";
    result.error_over_tolerance = worst;
    result.finding = worst > 1                          ? Finding::outside
                     : rank.probability <= significance ? Finding::within
                                                        : Finding::too_uncertain;
    result.detail = fmt::format("τ = {:.2f} over {} slips, p = {:.2g}; worst step back {:.2f} U", rank.tau, y.size(),
                                rank.probability, worst);
    return result;
}

TrendResult judge_linear(const TrendPoints& points, double share) {
    const double run_freedom = points.scatter.deviation > 0 ? points.scatter.degrees_of_freedom : 0;
    const CurvatureTest test = test_curvature(points.slip_percent, points.mean, points.weight, run_freedom);
    TrendResult result;
    result.statistic = test.sagitta_share;
    result.uncertainty = test.sagitta_uncertainty;
    result.tolerance_text = format_number(share);
    result.error_over_tolerance = test.sagitta_share / share;
    const bool is_curved = test.probability < significance;
    if (!(test.sagitta_share <= share)) {
        result.finding = is_curved ? Finding::outside : Finding::too_uncertain;
    } else {
        result.finding = test.sagitta_uncertainty <= share ? Finding::within : Finding::too_uncertain;
    }
    result.detail = fmt::format("parabola off its chord by {:.1f} ± {:.1f} % of the rise; F = {:.2f}, p = {:.2g}",
                                100 * test.sagitta_share, 100 * test.sagitta_uncertainty, test.f, test.probability);
    return result;
}

TrendResult combine(const std::vector<TrendResult>& results, const std::vector<std::string>& names) {
    TrendResult all = results.front();
    std::vector<std::string> details;
    for (std::size_t k = 0; k < results.size(); ++k) {
        const TrendResult& r = results[k];
        const bool is_worse =
            r.finding > all.finding ||
            (r.finding == all.finding && r.error_over_tolerance.value_or(0) > all.error_over_tolerance.value_or(0));
        if (is_worse) all = r;
        details.push_back(results.size() == 1 ? r.detail : fmt::format("{}: {}", names[k], r.detail));
    }
    all.detail = fmt::format("{}", fmt::join(details, "; "));
    return all;
}

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

#include "check/trend.hpp"

namespace ifedem {

// Two curves over slip against each other, by the interval of their difference over realisations. Runs of two
// conditions are independent (the motion of the soil is chaotic), so a difference has the variance s²(1/n_a + 1/n_b)
// with each curve's pooled scatter s.

/// The first above the second: their mean difference over the slips is positive by more than its 95 % half-width, and
/// no single slip contradicts it. Outside if the mean is negative by more than its half-width, or a slip is
/// significantly reversed (5 % shared by `conditions`, all slips of all curves of the claim).
[[nodiscard]] TrendResult judge_exceeds(const TrendPoints& first, const TrendPoints& second, std::size_t conditions);

/// Equal within a tolerance at every slip: |difference| and its 95 % half-width are no larger than the tolerance.
/// Outside if a difference exceeds the tolerance and its half-width; else too uncertain.
[[nodiscard]] TrendResult judge_same(const TrendPoints& first, const TrendPoints& second, double tolerance);

/// The magnitude of the first's mean slope is larger than the second's by more than its 95 % half-width (weighted lines
/// with run errors). Needs at least three slips each.
[[nodiscard]] TrendResult judge_steeper(const TrendPoints& first, const TrendPoints& second);

/// The weighted parabolas of all pairs of curves cross between the first and the last slip, and the crossings lie
/// within `tolerance_percent` of slip. The curves are drawn anew 1000 times within their run errors: within if it holds
/// in 95 % of these, outside in 5 % or fewer. Needs at least four slips a curve.
[[nodiscard]] TrendResult judge_cross(const std::vector<TrendPoints>& curves, double tolerance_percent);

/// The opposite for the first curves against the others: their pairs do not all cross within `tolerance_percent` of
/// slip. How the others stand to each other does not count.
[[nodiscard]] TrendResult judge_not_cross(const std::vector<TrendPoints>& curves,
                                          const std::vector<TrendPoints>& others, double tolerance_percent);

}  // namespace ifedem

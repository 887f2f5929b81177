#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/evaluate.hpp"

namespace ifedem {

// The data of figures as CSV text, ready for a file and for gnuplot.

/// gravity and load of one curve, "earth 170"; a third word is a slip.
struct CurveName {
    std::string gravity;
    double load_N = 0;
    double slip_percent = 0;
};
[[nodiscard]] CurveName parse_curve(const std::string& text);

/// curve,kind,slip_percent,value,uncertainty,n,label with kinds mean, run, fit (weighted parabola), text (the
/// dissertation's own number), and label, above, below (where words stand).
/// Nothing if no run fits.
[[nodiscard]] std::optional<std::string> slip_data(const Campaign& campaign, const std::vector<Outcome>& outcomes,
                                                   const std::string& metric, const std::vector<CurveName>& curves);

/// travel_m and mean, least and greatest of T, P_d and z in bins of travel.
[[nodiscard]] std::string series_data(const MeasuredRun& run);

/// row,label,error_over_tolerance,verdict,n of all numbers with a tolerance, worst last.
[[nodiscard]] std::optional<std::string> agreement_data(const std::vector<Outcome>& outcomes);

[[nodiscard]] std::optional<std::string> stiffness_data(const Campaign& campaign);

/// The first run of B3 under this condition.
[[nodiscard]] const MeasuredRun* find_run(const Campaign& campaign, const CurveName& curve);

}  // namespace ifedem

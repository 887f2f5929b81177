#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/evaluate.hpp"

namespace ifedem {

// The data of figures as CSV text, ready for a file and for gnuplot.

/// One curve of a figure, "B6 earth 170" ("earth 170" for B3); a further word is a slip.
struct CurveName {
    Curve curve;
    double slip_percent = 0;
};
[[nodiscard]] CurveName parse_curve(const std::string& text);

/// A word for data files and gnuplot: "B6-earth-170".
[[nodiscard]] std::string to_word(const Curve& curve);

/// A curve's slip: the commanded one, of the unloaded radius, or that of Eq 3.8 with the effective radius, measured.
enum class SlipAxis { set, measured };

/// curve,kind,slip_percent,value,uncertainty,n,label with kinds mean, run, fit (weighted parabola), text (the
/// dissertation's own number), and label, above, below (where words stand). The label names what tells the curves
/// apart. Nothing if no run fits.
[[nodiscard]] std::optional<std::string> slip_data(const Campaign& campaign, const std::vector<Outcome>& outcomes,
                                                   const std::string& metric, const std::vector<CurveName>& curves,
                                                   SlipAxis axis);

/// travel_cm and mean, least and greatest of T, P_d and z in bins of travel.
[[nodiscard]] std::string series_data(const MeasuredRun& run);

/// row,label,error_over_tolerance,verdict of all numbers with a tolerance, in the order of the claims; errors beyond
/// three tolerances count as three.
[[nodiscard]] std::optional<std::string> agreement_data(const std::vector<Outcome>& outcomes);

[[nodiscard]] std::optional<std::string> stiffness_data(const Campaign& campaign);

/// The first run under this condition.
[[nodiscard]] const MeasuredRun* find_run(const Campaign& campaign, const CurveName& name);

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

namespace ifedem {

// Measurements of `ifedem calibrate` against what a real sand gave.

enum class TargetVerdict { within, too_high, too_low, cannot_tell };

/// How a measurement stands to what the real sand gave: within U and U no more than a tenth of the target, beyond U, or
/// too uncertain to tell.
struct TargetMatch {
    double off = 0;          ///< measured less target, in the quantity's units
    double uncertainty = 0;  ///< U: 95 % half-width of the mean; infinite for one realisation
    TargetVerdict verdict = TargetVerdict::cannot_tell;
};
[[nodiscard]] TargetMatch match_target(const std::vector<double>& values, double target);

/// The value with as many decimals as an uncertainty or scatter of two digits has, "–" if it is not finite; and with
/// its sign.
[[nodiscard]] std::string number_within(double value, double scatter);
[[nodiscard]] std::string signed_within(double value, double scatter);

/// "friction_soil × 0.5: −4.1 ± 0.8", the strongest first: the lines of such a table whose interval leaves out
/// 0. Throws Error(bad_input) for another table.
[[nodiscard]] std::vector<std::string> list_knobs(const std::string& knob_table, const std::string& path,
                                                  const std::string& quantity);

}  // namespace ifedem

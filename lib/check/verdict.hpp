#pragma once
#include <optional>
#include <string_view>

namespace ifedem {

/// From best to worst.
enum class Verdict { match, unresolved, differs_explained, not_reproduced, not_computable };
inline constexpr int verdict_count = 5;

[[nodiscard]] std::string_view to_text(Verdict verdict);
[[nodiscard]] std::optional<Verdict> parse_verdict(std::string_view text);
[[nodiscard]] bool is_worse(Verdict outcome, Verdict expected);

/// Whether the distance is small enough, and whether the uncertainty lets one tell.
enum class Finding { within, too_uncertain, outside };

/// |error| ≤ U, where U itself may be at most `uncertainty_limit`.
[[nodiscard]] Finding compare_within_uncertainty(double error, double uncertainty, double uncertainty_limit);

/// |error| ≤ tolerance, where U may be at most the tolerance. Beyond the tolerance it is outside however large U is:
/// the computed number is compared with a number of the text, and only one that agrees can be too uncertain to say so.
/// (Differences of two of our own curves that U could explain are too uncertain either way: judge_same().)
[[nodiscard]] Finding compare_within_tolerance(double error, double uncertainty, double tolerance);

/// A one-sided statement: `margin` > 0 on the side that the text claims. It holds if margin > U, fails if margin < −U.
[[nodiscard]] Finding compare_side(double margin, double uncertainty);

/// A bound: it fails where the excess is more than its own uncertainty, if that is known (finite).
[[nodiscard]] Finding compare_with_bound(double excess, double uncertainty);

/// Outside turns into differs-explained only with evidence.
enum class Evidence { none, given };
[[nodiscard]] Verdict decide(Finding finding, Evidence evidence);

}  // namespace ifedem

#pragma once
#include <cstddef>
#include <string>
#include <variant>

#include "check/claim_runs.hpp"
#include "check/trend.hpp"

namespace ifedem {

struct CurveJudgement {
    TrendResult result;
    double scatter = 0;  ///< of one run, on the first curve
    std::size_t n = 0;   ///< runs on all curves
};

/// Judges a claim about curves over slip (is_about_curves): every curve of the first side, against its partner of the
/// second where there are two. The worst decides.
[[nodiscard]] std::variant<CurveJudgement, Missing> judge_curves(const Campaign& campaign, const Claim& claim);

/// What such a judgement's number counts in, for a metric in `units`.
[[nodiscard]] std::string units_of_statistic(Comparison comparison, const std::string& units);

}  // namespace ifedem

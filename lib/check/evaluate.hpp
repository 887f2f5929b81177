#pragma once
#include <optional>
#include <string>
#include <vector>

#include "check/campaign.hpp"
#include "check/claims.hpp"
#include "check/ledger.hpp"
#include "check/verdict.hpp"

namespace ifedem {

/// One line of checks.csv.
struct Outcome {
    Claim claim;
    LedgerRow ledger;
    std::string units;
    std::string condition;
    std::string reference_text;
    std::optional<double> reference;
    std::optional<double> computed;
    double scatter = 0;
    double uncertainty = 0;  ///< U
    std::size_t n = 0;
    std::string tolerance_text;
    std::optional<double> error_over_tolerance;
    Verdict verdict = Verdict::not_computable;
    std::string detail;  ///< the reason, or the numbers behind a trend

    [[nodiscard]] bool is_worse_than_expected() const { return is_worse(verdict, claim.expected); }
};

/// Judges every claim. Ledger rows of the same chapters that need a verdict and have no claim are added as
/// not-computable with expected verdict match, so that they fail the check.
/// `root` is the directory that evidence files are named from.
[[nodiscard]] std::vector<Outcome> evaluate(const std::vector<Claim>& claims, const Ledger& ledger,
                                            const Campaign& campaign, const std::string& root);

}  // namespace ifedem

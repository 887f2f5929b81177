#pragma once
#include <array>
#include <string>
#include <vector>

#include "check/evaluate.hpp"

namespace ifedem {

/// The nearest directory above `path` that holds reference_data/dissertation.csv: the project's root.
/// Throws Error(bad_input) if there is none.
[[nodiscard]] std::string find_root(const std::string& path);

/// Reads claims, ledger and runs and judges them. Throws Error(bad_input) or Error(io).
struct CheckResult {
    std::vector<Outcome> outcomes;
    Campaign campaign;
    std::string root;
};
[[nodiscard]] CheckResult check_claims(const std::string& claims_path, const std::vector<std::string>& run_dirs);

/// The chapter's claims, then those of its folders that have some.
[[nodiscard]] std::vector<Claim> read_all_claims(const std::string& path, const Ledger& ledger);

/// checks.csv: a line an outcome; U stands in the last column.
[[nodiscard]] std::string checks_to_csv(const std::vector<Outcome>& outcomes);

/// The way back, as far as the file goes: evidence and detail are both in `detail`, and a check whose claim is gone has
/// comparison `none`. Throws Error(bad_input) for a row that is not of the ledger.
[[nodiscard]] std::vector<Outcome> read_checks(const std::string& path, const std::vector<Claim>& claims,
                                               const Ledger& ledger);

/// How often each verdict was given, best first.
[[nodiscard]] std::array<std::size_t, verdict_count> count_verdicts(const std::vector<Outcome>& outcomes);

/// "12 match, 3 unresolved, 0 differs-explained, 1 not-reproduced, 37 not-computable".
[[nodiscard]] std::string verdict_line(const std::vector<Outcome>& outcomes);

/// The `check` command: writes `out_path`, prints each row that is worse than expected and the verdict line.
/// Returns 0, or 1 if a verdict is worse than its claim expects or a ledger row has no claim.
int run_check(const std::string& claims_path, const std::vector<std::string>& run_dirs, const std::string& out_path);

}  // namespace ifedem

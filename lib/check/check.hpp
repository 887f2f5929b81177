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

/// checks.csv, columns as in the manual.
[[nodiscard]] std::string checks_to_csv(const std::vector<Outcome>& outcomes);

/// How often each verdict was given, best first.
[[nodiscard]] std::array<std::size_t, verdict_count> count_verdicts(const std::vector<Outcome>& outcomes);

/// "12 match, 3 unresolved, 0 differs-explained, 1 not-reproduced, 37 not-computable".
[[nodiscard]] std::string verdict_line(const std::vector<Outcome>& outcomes);

/// The `check` command: writes `out_path`, prints each row that is worse than expected and the verdict line.
/// Returns 0, or 1 if a verdict is worse than its claim expects or a ledger row has no claim.
int run_check(const std::string& claims_path, const std::vector<std::string>& run_dirs, const std::string& out_path);

}  // namespace ifedem

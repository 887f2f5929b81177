#include "check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

std::string optional_number(const std::optional<double>& value) {
    return value ? format_number(*value) : std::string();
}

std::string evidence_text(const Outcome& o) {
    if (o.claim.evidence.empty()) return o.detail;
    return o.detail.empty() ? o.claim.evidence : o.claim.evidence + "; " + o.detail;
}

}  // namespace

std::string find_root(const std::string& path) {
    namespace fs = std::filesystem;
    for (fs::path p = fs::absolute(path).lexically_normal(); !p.empty(); p = p.parent_path()) {
        if (fs::exists(p / "reference_data" / "dissertation.csv")) return p.string();
        if (p == p.parent_path()) break;
    }
    fail_input(fmt::format(
        "{}: no directory above holds reference_data/dissertation.csv. Use the claims of a checkout?", path));
}

std::vector<Claim> read_all_claims(const std::string& path, const Ledger& ledger) {
    namespace fs = std::filesystem;
    std::vector<Claim> claims = read_claims(path, ledger);
    if (fs::path(path).filename() != "claims.csv") return claims;
    std::vector<std::string> further;
    for (const auto& entry : fs::directory_iterator(fs::absolute(path).parent_path()))
        if (fs::exists(entry.path() / "claims.csv")) further.push_back((entry.path() / "claims.csv").string());
    std::sort(further.begin(), further.end());
    for (const auto& file : further) {
        const std::vector<Claim> more = read_claims(file, ledger);
        claims.insert(claims.end(), more.begin(), more.end());
    }
    std::set<std::string> ids;
    for (const Claim& claim : claims)
        if (!ids.insert(claim.id).second)
            fail_input(fmt::format("{}: {} is claimed here and in a folder beside it. Take one away?", path, claim.id));
    return claims;
}

CheckResult check_claims(const std::string& claims_path, const std::vector<std::string>& run_dirs) {
    CheckResult result;
    result.root = find_root(claims_path);
    const Ledger ledger = read_ledger(result.root);
    const auto claims = read_all_claims(claims_path, ledger);
    result.campaign = read_campaign(run_dirs);
    result.outcomes = evaluate(claims, ledger, result.campaign, result.root);
    return result;
}

std::string checks_to_csv(const std::vector<Outcome>& outcomes) {
    std::string text =
        "id,chapter,quantity,units,condition,reference,computed,scatter,n,tolerance,error_over_tolerance,verdict,"
        "expected,"
        "evidence,source,uncertainty\n";
    for (const auto& o : outcomes)
        text += csv_line({o.claim.id, std::to_string(o.ledger.chapter), o.ledger.quantity, o.units, o.condition,
                          o.reference_text, optional_number(o.computed), o.computed ? format_number(o.scatter) : "",
                          o.n > 0 ? std::to_string(o.n) : "", o.tolerance_text, optional_number(o.error_over_tolerance),
                          std::string(to_text(o.verdict)), std::string(to_text(o.claim.expected)), evidence_text(o),
                          source_text(o.ledger), o.computed ? format_number(o.uncertainty) : ""});
    return text;
}

std::vector<Outcome> read_checks(const std::string& path, const std::vector<Claim>& claims, const Ledger& ledger) {
    const CsvTable table = read_csv(path);
    const auto uncertainty = table.find("uncertainty");
    std::vector<Outcome> outcomes;
    for (const CsvRow& row : table.rows) {
        const auto cell = [&](const char* column) { return row.cells[table.require(column)]; };
        Outcome o;
        o.claim.id = cell("id");
        const auto claim =
            std::find_if(claims.begin(), claims.end(), [&](const Claim& c) { return c.id == o.claim.id; });
        if (claim != claims.end()) o.claim = *claim;
        const auto statement = ledger.find(o.claim.base_id());
        const auto verdict = parse_verdict(cell("verdict")), expected = parse_verdict(cell("expected"));
        if (statement == ledger.end() || !verdict || !expected)
            fail_input(fmt::format("{}:{}: {} is no row of the ledger, or its verdict is none. Check the chapter anew?",
                                   path, row.line, o.claim.id));
        o.ledger = statement->second;
        o.claim.expected = *expected;
        o.units = cell("units");
        o.condition = cell("condition");
        o.reference_text = cell("reference");
        o.computed = parse_number(cell("computed"));
        o.scatter = parse_number(cell("scatter")).value_or(0);
        o.uncertainty = uncertainty ? parse_number(row.cells[*uncertainty]).value_or(0) : 0;
        o.n = count_of(table, row, "n");
        o.tolerance_text = cell("tolerance");
        o.error_over_tolerance = parse_number(cell("error_over_tolerance"));
        o.verdict = *verdict;
        o.detail = cell("evidence");
        outcomes.push_back(std::move(o));
    }
    return outcomes;
}

std::array<std::size_t, verdict_count> count_verdicts(const std::vector<Outcome>& outcomes) {
    std::array<std::size_t, verdict_count> counts{};
    for (const auto& o : outcomes) ++counts[static_cast<std::size_t>(o.verdict)];
    return counts;
}

std::string verdict_line(const std::vector<Outcome>& outcomes) {
    const auto counts = count_verdicts(outcomes);
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < counts.size(); ++k)
        parts.push_back(fmt::format("{} {}", counts[k], to_text(static_cast<Verdict>(k))));
    return fmt::format("{}", fmt::join(parts, ", "));
}

int run_check(const std::string& claims_path, const std::vector<std::string>& run_dirs, const std::string& out_path) {
    const CheckResult result = check_claims(claims_path, run_dirs);
    write_text(out_path, checks_to_csv(result.outcomes));
    for (const auto& reason : result.campaign.unusable) fmt::print("not used: {}\n", reason);
    bool is_worse_somewhere = false;
    for (const auto& o : result.outcomes) {
        if (!o.is_worse_than_expected()) continue;
        is_worse_somewhere = true;
        fmt::print("{} {}: {} where {} was expected ({})\n", o.claim.id, o.ledger.quantity, to_text(o.verdict),
                   to_text(o.claim.expected), o.detail.empty() ? "see " + out_path : o.detail);
    }
    fmt::print("verdicts: {}\n", verdict_line(result.outcomes));
    return static_cast<int>(is_worse_somewhere ? ExitCode::check_worse : ExitCode::done);
}

}  // namespace ifedem

#include "check/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <variant>

#include "check/claim_runs.hpp"
#include "check/csv.hpp"
#include "check/judge_curves.hpp"
#include "check/statistics.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

// Match needs U ≤ max(10 % of the value, 0.05 W): a larger one could not tell the text's statement from its neighbours.
constexpr double uncertainty_share = 0.10;
constexpr double uncertainty_share_of_load = 0.05;

/// A number as a claim needs it.
struct Quantity {
    double value = 0;
    double scatter = 0;
    double uncertainty = 0;
    std::size_t n = 0;
    std::string detail;
};

struct Judge {
    const Campaign& campaign;
    const Ledger& ledger;
    const Claim& claim;
    Outcome& out;

    [[nodiscard]] Evidence evidence(const std::string& root) const {
        if (claim.evidence.empty()) return Evidence::none;
        return std::filesystem::exists(std::filesystem::path(root) / claim.evidence) ? Evidence::given : Evidence::none;
    }
};

/// Why there is no run: none was made, or it did not get far enough.
Missing missing_run(const Judge& j, std::size_t side) {
    const auto& s = j.claim.selection;
    for (const auto& run : j.campaign.runs) {
        const bool fits = is_on(s.sides.at(side)[0], run.condition) &&
                          std::abs(run.condition.slip_percent - s.slip_from_percent) < 1e-9;
        if (fits && !run.shortfall.empty()) return {run.shortfall};
    }
    return {fmt::format("no run of {}", wanted_runs(j.claim, side))};
}

/// Mean, scatter and U of one side of a claim at its one slip.
std::variant<Quantity, Missing> window_mean(const Judge& j, std::size_t side, const std::string& printed,
                                            const std::string& units) {
    const Curve& curve = j.claim.selection.sides.at(side)[0];
    const auto values = collect_curve(j.campaign, j.claim, curve);
    const auto group = values.find(j.claim.selection.slip_from_percent);
    if (group == values.end()) return missing_run(j, side);
    if (std::any_of(group->second.begin(), group->second.end(), [](double v) { return !std::isfinite(v); }))
        return Missing{fmt::format("the runs do not record {}", without_prefix(j.claim.metric))};
    const double reading = reading_uncertainty(printed, units, curve.gravity);
    const auto borrowed = borrow_scatter(j.campaign, curve, metric_of(j.claim));
    const Estimate e = estimate(group->second, reading, borrowed.pooled);
    Quantity q{e.mean, e.scatter, e.uncertainty, e.n, {}};
    if (e.borrowed)
        q.detail = !std::isfinite(e.uncertainty) ? "n = 1 and no scatter known"
                   : borrowed.from_other_curves  ? "n = 1, scatter borrowed from all realisations on the planet"
                                                 : "n = 1, scatter borrowed from the slips with several realisations";
    return q;
}

/// The text's reading of one side of a ratio is a force or a length, whose reading uncertainty is known.
std::variant<Quantity, Missing> ratio_of_means(const Judge& j) {
    const std::string units(find_metric(without_prefix(j.claim.metric))->unit);
    const auto top = window_mean(j, 0, "1", units);
    const auto bottom = window_mean(j, 1, "1", units);
    if (const auto* missing = std::get_if<Missing>(&top)) return *missing;
    if (const auto* missing = std::get_if<Missing>(&bottom)) return *missing;
    const auto& a = std::get<Quantity>(top);
    const auto& b = std::get<Quantity>(bottom);
    Quantity q;
    q.value = a.value / b.value;
    q.scatter = ratio_uncertainty(a.value, a.scatter, b.value, b.scatter);
    q.uncertainty = ratio_uncertainty(a.value, a.uncertainty, b.value, b.uncertainty);
    q.n = std::min(a.n, b.n);
    q.detail = fmt::format("{:.4g}/{:.4g}", a.value, b.value);
    return q;
}

std::variant<Quantity, Missing> gravity_ratio(const Judge& j) {
    std::optional<double> mars;
    std::optional<double> earth;
    for (const auto& run : j.campaign.runs) {
        if (run.condition.gravity == "mars") mars = run.run.c.gravity_m_s2;
        if (run.condition.gravity == "earth") earth = run.run.c.gravity_m_s2;
    }
    if (!mars || !earth) return Missing{"needs a run on Earth and one on Mars"};
    return Quantity{*mars / *earth, 0, 0, 1, "from the cases' own gravity"};
}

/// Stiffness over lug phases; the half range is what the text, which names no phase, leaves open.
std::variant<Quantity, Missing> stiffness(const Judge& j, const std::string& printed, const std::string& units) {
    for (const auto& s : j.campaign.stiffness)
        if (s.wheel == j.claim.selection.wheel) {
            const double half_range = 0.5 * (s.most_N_mm - s.least_N_mm);
            return Quantity{s.stiffness_N_mm, half_range,
                            std::hypot(half_range, reading_uncertainty(printed, units, "")), 1,
                            fmt::format("{:.4g}–{:.4g} N/mm over lug phases", s.least_N_mm, s.most_N_mm)};
        }
    return Missing{fmt::format("no stiffness file for wheel {}", j.claim.selection.wheel)};
}

/// A number from measurements.csv. One value tells no scatter: without a tolerance of the claim's own nothing can be
/// said.
std::variant<Quantity, Missing> measured(const Judge& j) {
    const std::string name = without_prefix(j.claim.metric);
    const Measurement* m = find_measurement(j.campaign, name);
    if (m == nullptr)
        return Missing{fmt::format("not measured yet (no measurements.csv holds {}){}{}", name,
                                   j.claim.note.empty() ? "" : "; ", j.claim.note)};
    const bool is_against_ledger = !j.claim.reference_id.empty();
    if (is_against_ledger && m->units != j.out.ledger.units)
        return Missing{
            fmt::format("{} was measured in {} but the ledger row is in {}", name, m->units, j.out.ledger.units)};
    // Only what was read off the text has a last digit; a bound of the claim's own has none, nor has a closed form.
    const bool is_read = is_against_ledger && j.out.ledger.kind != "exact";
    const double reading =
        is_read ? reading_uncertainty(j.out.reference_text, j.out.units, j.claim.first_gravity()) : 0;
    Quantity q{m->value, m->scatter, 0, m->n, m->note};
    j.out.units = m->units;
    q.uncertainty =
        uncertainty_of(*m, reading).value_or(j.claim.tolerance ? 0.0 : std::numeric_limits<double>::infinity());
    return q;
}

std::variant<Quantity, Missing> compute(const Judge& j) {
    const std::string& metric = j.claim.metric;
    if (metric.starts_with("measured:")) return measured(j);
    if (metric == "gravity_ratio") return gravity_ratio(j);
    if (metric == "stiffness_N_mm") return stiffness(j, j.out.reference_text, j.out.ledger.units);
    if (metric.starts_with("ratio:")) return ratio_of_means(j);
    return window_mean(j, 0, j.out.reference_text, j.out.units);
}

double uncertainty_limit(const Judge& j, double reference) {
    const double share = uncertainty_share * std::abs(reference);
    const auto& sides = j.claim.selection.sides;
    if (j.out.units != "N" || sides.empty()) return share;
    return std::max(share, uncertainty_share_of_load * sides[0][0].load_N);
}

void add_detail(Outcome& out, const std::string& text) {
    if (text.empty()) return;
    out.detail += (out.detail.empty() ? "" : "; ") + text;
}

/// A number against U, or against the claim's own tolerance.
Finding judge_equal(const Judge& j, const Quantity& q, double reference) {
    const double error = q.value - reference;
    const double tolerance = j.claim.tolerance.value_or(q.uncertainty);
    j.out.tolerance_text = format_number(tolerance);
    if (std::isfinite(tolerance) && tolerance > 0) j.out.error_over_tolerance = error / tolerance;
    if (j.claim.tolerance) return compare_within_tolerance(error, q.uncertainty, tolerance);
    const double limit = uncertainty_limit(j, reference);
    if (q.uncertainty > limit) add_detail(j.out, fmt::format("U may be at most {:.3g}", limit));
    return compare_within_uncertainty(error, q.uncertainty, limit);
}

/// By more than the claim's own threshold, which U has to tell, or by more than U.
Finding judge_side(const Judge& j, const Quantity& q, double reference) {
    const double sign = j.claim.comparison == Comparison::above ? 1.0 : -1.0;
    const double margin = sign * (q.value - reference);
    const double tolerance = j.claim.tolerance.value_or(q.uncertainty);
    j.out.tolerance_text = format_number(tolerance);
    if (std::isfinite(tolerance) && tolerance > 0) j.out.error_over_tolerance = -margin / tolerance;
    return compare_side(margin - j.claim.tolerance.value_or(0), q.uncertainty);
}

Finding judge_at_most(const Judge& j, const Quantity& q, double reference) {
    j.out.tolerance_text = "bound";
    j.out.error_over_tolerance = q.value / reference;
    return compare_with_bound(q.value - reference, q.uncertainty);
}

std::variant<Finding, Missing> judge_number(const Judge& j) {
    const double reference = j.claim.reference.value_or(0);
    j.out.reference = reference;
    auto result = compute(j);
    if (const auto* missing = std::get_if<Missing>(&result)) return *missing;
    const auto& q = std::get<Quantity>(result);
    j.out.computed = q.value;
    j.out.scatter = q.scatter;
    j.out.uncertainty = q.uncertainty;
    j.out.n = q.n;
    add_detail(j.out, q.detail);
    if (j.claim.comparison == Comparison::equal) return judge_equal(j, q, reference);
    if (j.claim.comparison == Comparison::at_most) return judge_at_most(j, q, reference);
    return judge_side(j, q, reference);
}

std::variant<Finding, Missing> judge_trends(const Judge& j) {
    const auto judged = judge_curves(j.campaign, j.claim);
    if (const auto* missing = std::get_if<Missing>(&judged)) return *missing;
    const auto& [result, scatter, n] = std::get<CurveJudgement>(judged);
    j.out.computed = result.statistic;
    j.out.uncertainty = result.uncertainty;
    j.out.scatter = scatter;
    j.out.n = n;
    j.out.tolerance_text = result.tolerance_text;
    j.out.error_over_tolerance = result.error_over_tolerance;
    add_detail(j.out, result.detail);
    return result.finding;
}

std::string describe_condition(const Claim& claim, const LedgerRow& row) {
    const auto& sides = claim.selection.sides;
    if (claim.comparison == Comparison::none || sides.empty()) return row.condition;
    if (sides.size() == 1) return wanted_runs(claim, 0);
    return fmt::format("{} {} {}", wanted_runs(claim, 0), is_about_curves(claim.comparison) ? "against" : "over",
                       wanted_runs(claim, 1));
}

std::string describe_reference(const Claim& claim, const Ledger& ledger) {
    if (claim.reference_id.empty())
        return claim.reference ? format_number(*claim.reference) : ledger.at(claim.base_id()).value;
    const std::string& value = ledger.at(claim.reference_id).value;
    return value;
}

Outcome judge_claim(const Claim& claim, const Ledger& ledger, const Campaign& campaign, const std::string& root) {
    Outcome out;
    out.claim = claim;
    out.ledger = ledger.at(claim.base_id());
    const auto* info = find_metric(without_prefix(claim.metric));
    out.units = claim.metric.starts_with("ratio:") ? "-" : info ? std::string(info->unit) : out.ledger.units;
    out.condition = describe_condition(claim, out.ledger);
    out.reference_text = describe_reference(claim, ledger);
    if (claim.comparison == Comparison::none) {
        out.detail = claim.note;
        return out;
    }
    const Judge j{campaign, ledger, claim, out};
    const bool is_curves = is_about_curves(claim.comparison);
    if (is_curves) out.units = units_of_statistic(claim.comparison, out.units);
    const auto finding = is_curves ? judge_trends(j) : judge_number(j);
    if (const auto* missing = std::get_if<Missing>(&finding)) {
        out.detail = missing->reason;
        return out;
    }
    out.verdict = decide(std::get<Finding>(finding), j.evidence(root));
    if (!claim.evidence.empty() && j.evidence(root) == Evidence::none)
        add_detail(out, fmt::format("the evidence {} does not exist", claim.evidence));
    return out;
}

}  // namespace

std::vector<Outcome> evaluate(const std::vector<Claim>& claims, const Ledger& ledger, const Campaign& campaign,
                              const std::string& root) {
    std::vector<Outcome> outcomes;
    std::set<std::string> claimed;
    std::set<int> chapters;
    for (const auto& claim : claims) {
        outcomes.push_back(judge_claim(claim, ledger, campaign, root));
        claimed.insert(claim.base_id());
        // A value from elsewhere may be checked in any chapter; it does not call for the rest of its own.
        if (outcomes.back().ledger.needs_verdict()) chapters.insert(outcomes.back().ledger.chapter);
    }
    for (const auto& [id, row] : ledger) {
        if (!row.needs_verdict() || !chapters.contains(row.chapter) || claimed.contains(id)) continue;
        Outcome missing;
        missing.claim.id = id;
        missing.ledger = row;
        missing.units = row.units;
        missing.condition = row.condition;
        missing.reference_text = row.value;
        missing.detail = "no claim declares this ledger row";
        outcomes.push_back(std::move(missing));
    }
    return outcomes;
}

}  // namespace ifedem

#include "check/judge_curves.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <vector>

#include "check/csv.hpp"
#include "check/ordering.hpp"

namespace ifedem {
namespace {

std::string name_of(const Curve& curve) {
    return fmt::format("{} {} {:g} N", curve.wheel, capitalised(curve.gravity), curve.load_N);
}

/// The points of one curve over the claim's slips, or which of them are missing.
std::variant<TrendPoints, Missing> curve_points(const Campaign& campaign, const Claim& claim, const Curve& curve,
                                                std::size_t fewest) {
    auto values = collect_curve(campaign, claim, curve);
    const auto& s = claim.selection;
    std::erase_if(values, [&](const auto& item) {
        return item.first < s.slip_from_percent - 1e-9 || item.first > s.slip_to_percent + 1e-9;
    });
    if (values.size() < fewest)
        return Missing{s.slip_from_percent < s.slip_to_percent
                           ? fmt::format("only {} of the slips {:g}–{:g} % of {} were run", values.size(),
                                         s.slip_from_percent, s.slip_to_percent, name_of(curve))
                           : fmt::format("no run of {}, slip {:g} %", name_of(curve), s.slip_from_percent)};
    return trend_points(values, borrow_scatter(campaign, curve, metric_of(claim)).pooled);
}

/// All slips that the text uses for a range of them: 0, 10, … 70 %. A statement about a range needs each.
std::size_t slips_in_range(const Selection& s) {
    return 1 + static_cast<std::size_t>((s.slip_to_percent - s.slip_from_percent) / 10 + 1e-9);
}

std::size_t fewest_points(const Claim& claim) {
    const bool is_pointwise = claim.comparison == Comparison::exceeds || claim.comparison == Comparison::same;
    constexpr std::size_t fewest_for_a_fit = 4;
    return is_pointwise ? slips_in_range(claim.selection) : fewest_for_a_fit;
}

using Sides = std::vector<std::vector<TrendPoints>>;

/// The lines NAME_sSLIP of measurements.csv at the claim's slips. Each has its own scatter.
std::variant<TrendPoints, Missing> measured_points(const Campaign& campaign, const Claim& claim) {
    const auto& s = claim.selection;
    const std::string name = without_prefix(claim.metric) + "_s";
    std::map<double, const Measurement*> by_slip;
    for (const Measurement& m : campaign.measurements) {
        if (!m.name.starts_with(name)) continue;
        const auto slip = parse_number(m.name.substr(name.size()));
        if (slip && *slip >= s.slip_from_percent - 1e-9 && *slip <= s.slip_to_percent + 1e-9) by_slip[*slip] = &m;
    }
    if (by_slip.size() < fewest_points(claim))
        return Missing{fmt::format("measurements.csv holds {} at {} of the slips {:g}–{:g} %",
                                   without_prefix(claim.metric), by_slip.size(), s.slip_from_percent,
                                   s.slip_to_percent)};
    TrendPoints points;
    for (const auto& [slip, m] : by_slip) {
        const auto n = static_cast<double>(m->n);
        points.slip_percent.push_back(slip);
        points.mean.push_back(m->value);
        points.n.push_back(n);
        points.weight.push_back(m->scatter > 0 ? n / (m->scatter * m->scatter) : n);
        points.uncertainty.push_back(uncertainty_of(*m, 0).value_or(std::numeric_limits<double>::infinity()));
        points.runs += m->n;
    }
    return points;
}

std::variant<Sides, Missing> all_points(const Campaign& campaign, const Claim& claim) {
    Sides sides;
    if (claim.metric.starts_with("measured:")) {
        auto points = measured_points(campaign, claim);
        if (const auto* missing = std::get_if<Missing>(&points)) return *missing;
        sides.push_back({std::get<TrendPoints>(std::move(points))});
        return sides;
    }
    for (const auto& curves : claim.selection.sides) {
        sides.emplace_back();
        for (const auto& curve : curves) {
            auto points = curve_points(campaign, claim, curve, fewest_points(claim));
            if (const auto* missing = std::get_if<Missing>(&points)) return *missing;
            sides.back().push_back(std::get<TrendPoints>(std::move(points)));
        }
    }
    return sides;
}

TrendResult judge_curve(const Claim& claim, const Sides& sides, std::size_t k) {
    const std::size_t conditions = sides[0].size() * slips_in_range(claim.selection);
    switch (claim.comparison) {
        case Comparison::linear:
            return judge_linear(sides[0][k], *claim.tolerance);
        case Comparison::exceeds:
            return judge_exceeds(sides[0][k], sides[1][k], conditions);
        case Comparison::same:
            return judge_same(sides[0][k], sides[1][k], *claim.tolerance);
        case Comparison::steeper:
            return judge_steeper(sides[0][k], sides[1][k]);
        default:
            return judge_monotonic(sides[0][k], claim.comparison == Comparison::increasing ? 1.0 : -1.0);
    }
}

}  // namespace

std::variant<CurveJudgement, Missing> judge_curves(const Campaign& campaign, const Claim& claim) {
    const auto points = all_points(campaign, claim);
    if (const auto* missing = std::get_if<Missing>(&points)) return *missing;
    const auto& sides = std::get<Sides>(points);
    std::vector<TrendResult> results;
    std::vector<std::string> names;
    const auto c = claim.comparison;
    if (c == Comparison::cross || c == Comparison::not_cross) {
        results.push_back(c == Comparison::cross ? judge_cross(sides[0], *claim.tolerance)
                                                 : judge_not_cross(sides[0], sides[1], *claim.tolerance));
        names.emplace_back();
    } else {
        for (std::size_t k = 0; k < sides[0].size(); ++k) {
            results.push_back(judge_curve(claim, sides, k));
            names.push_back(claim.selection.sides.empty() ? claim.metric : name_of(claim.selection.sides[0][k]));
        }
    }
    CurveJudgement judgement{combine(results, names), sides[0][0].scatter.deviation, 0};
    for (const auto& side : sides)
        for (const auto& curve : side) judgement.n += curve.runs;
    return judgement;
}

std::string units_of_statistic(Comparison comparison, const std::string& units) {
    switch (comparison) {
        case Comparison::exceeds:
        case Comparison::same:
            return units;
        case Comparison::steeper:
            return units + " per %";
        case Comparison::cross:
        case Comparison::not_cross:
            return "% of slip";
        default:
            return "-";
    }
}

}  // namespace ifedem

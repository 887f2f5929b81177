#include "check/ordering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "check/csv.hpp"
#include "core/random.hpp"

namespace ifedem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// First less second at one slip both curves have.
struct Difference {
    double slip_percent = 0;
    double value = 0;
    double standard_error = 0;
};

struct Differences {
    std::vector<Difference> at;
    double freedom = 0;  ///< the smaller ν of the two; 0: nothing tells the scatter
};

Differences subtract(const TrendPoints& a, const TrendPoints& b) {
    Differences d;
    d.freedom = std::min(a.scatter.degrees_of_freedom, b.scatter.degrees_of_freedom);
    for (std::size_t i = 0; i < a.slip_percent.size(); ++i)
        for (std::size_t j = 0; j < b.slip_percent.size(); ++j) {
            if (std::abs(a.slip_percent[i] - b.slip_percent[j]) > 1e-9) continue;
            const double error =
                std::hypot(a.scatter.deviation / std::sqrt(a.n[i]), b.scatter.deviation / std::sqrt(b.n[j]));
            d.at.push_back({a.slip_percent[i], a.mean[i] - b.mean[j], error});
        }
    return d;
}

/// Half-width of an interval that leaves out `share` in all.
double half_width(double standard_error, double freedom, double share) {
    return freedom >= 1 ? student_t_quantile(1 - share / 2, freedom) * standard_error : infinity;
}

std::string scatter_text(double freedom) {
    return freedom >= 1 ? fmt::format("pooled scatter, ν = {:g}", freedom) : std::string("no scatter known");
}

}  // namespace

TrendResult judge_exceeds(const TrendPoints& first, const TrendPoints& second, std::size_t conditions) {
    const Differences d = subtract(first, second);
    double sum = 0;
    double variance = 0;
    const Difference* reversed = nullptr;
    for (const auto& at : d.at) {
        sum += at.value;
        variance += at.standard_error * at.standard_error;
        const double limit = half_width(at.standard_error, d.freedom, 0.05 / static_cast<double>(conditions));
        if (at.value < -limit && (reversed == nullptr || at.value < reversed->value)) reversed = &at;
    }
    const auto n = static_cast<double>(d.at.size());
    const double mean_difference = sum / n;
    TrendResult result;
    result.statistic = mean_difference;
    result.uncertainty = half_width(std::sqrt(variance) / n, d.freedom, 0.05);
    result.tolerance_text = format_number(result.uncertainty);
    if (std::isfinite(result.uncertainty) && result.uncertainty > 0)
        result.error_over_tolerance = -mean_difference / result.uncertainty;
    result.finding = reversed != nullptr ? Finding::outside : compare_side(mean_difference, result.uncertainty);
    result.detail = fmt::format("mean difference {:+.3g} ± {:.2g} over {:g} slips ({})", mean_difference,
                                result.uncertainty, n, scatter_text(d.freedom));
    if (reversed != nullptr)
        result.detail += fmt::format(", reversed at {:g} %: {:+.3g}", reversed->slip_percent, reversed->value);
    return result;
}

TrendResult judge_same(const TrendPoints& first, const TrendPoints& second, double tolerance) {
    const Differences d = subtract(first, second);
    TrendResult result;
    result.finding = Finding::within;
    result.tolerance_text = format_number(tolerance);
    result.statistic = 0;
    std::vector<std::string> texts;
    for (const auto& at : d.at) {
        const double h = half_width(at.standard_error, d.freedom, 0.05);
        const double size = std::abs(at.value);
        const Finding finding = size <= tolerance && h <= tolerance ? Finding::within
                                : size > tolerance && size > h      ? Finding::outside
                                                                    : Finding::too_uncertain;
        result.finding = std::max(result.finding, finding);
        if (size >= std::abs(*result.statistic)) result.statistic = at.value;
        result.uncertainty = std::max(result.uncertainty, h);
        texts.push_back(fmt::format("{:g} %: {:+.3g} ± {:.2g}", at.slip_percent, at.value, h));
    }
    result.error_over_tolerance = *result.statistic / tolerance;
    result.detail = fmt::format("differences at {} ({})", fmt::join(texts, ", "), scatter_text(d.freedom));
    return result;
}

TrendResult judge_steeper(const TrendPoints& first, const TrendPoints& second) {
    const auto a = fit_polynomial(first.slip_percent, first.mean, first.weight, 1);
    const auto b = fit_polynomial(second.slip_percent, second.mean, second.weight, 1);
    const double freedom = std::min(first.scatter.degrees_of_freedom, second.scatter.degrees_of_freedom);
    const double margin = std::abs(a.coefficients[1]) - std::abs(b.coefficients[1]);
    TrendResult result;
    result.statistic = margin;
    result.uncertainty = half_width(std::hypot(a.run_errors[1], b.run_errors[1]), freedom, 0.05);
    result.tolerance_text = format_number(result.uncertainty);
    if (std::isfinite(result.uncertainty) && result.uncertainty > 0)
        result.error_over_tolerance = -margin / result.uncertainty;
    result.finding = compare_side(margin, result.uncertainty);
    result.detail =
        fmt::format("slopes {:+.3g} and {:+.3g} per % of slip, magnitudes differ by {:+.2g} ± {:.2g} ({})",
                    a.coefficients[1], b.coefficients[1], margin, result.uncertainty, scatter_text(freedom));
    return result;
}

namespace {

/// The first slip in [low, high] where two parabolas have the same value, crossing there.
std::optional<double> find_crossing(const PolynomialFit& a, const PolynomialFit& b, double low, double high) {
    constexpr int steps = 700;  // a tenth of a percent: far below what the runs can tell
    const auto difference = [&](double x) { return a.at(x) - b.at(x); };
    double before = difference(low);
    for (int k = 1; k <= steps; ++k) {
        const double x = low + (high - low) * k / steps;
        const double after = difference(x);
        if ((before < 0) != (after < 0)) return x - (high - low) / steps * after / (after - before);
        before = after;
    }
    return std::nullopt;
}

struct Crossings {
    std::size_t pairs = 0;
    std::vector<double> slip_percent;
    [[nodiscard]] bool are_common(double tolerance_percent) const {
        return is_complete() && spread() <= tolerance_percent;
    }
    [[nodiscard]] bool is_complete() const { return slip_percent.size() == pairs; }
    [[nodiscard]] double spread() const {
        const auto [least, most] = std::minmax_element(slip_percent.begin(), slip_percent.end());
        return *most - *least;
    }
};

std::vector<PolynomialFit> fit_parabolas(const std::vector<TrendPoints>& curves,
                                         const std::vector<std::vector<double>>& values) {
    std::vector<PolynomialFit> fits;
    for (std::size_t k = 0; k < curves.size(); ++k)
        fits.push_back(fit_polynomial(curves[k].slip_percent, values[k], curves[k].weight, 2));
    return fits;
}

/// Of the first `apart` curves with the others; of all with each other if `apart` is 0.
Crossings find_crossings(const std::vector<TrendPoints>& curves, const std::vector<std::vector<double>>& values,
                         std::size_t apart) {
    const auto fits = fit_parabolas(curves, values);
    Crossings found;
    for (std::size_t i = 0; i < (apart == 0 ? curves.size() : apart); ++i)
        for (std::size_t j = apart == 0 ? i + 1 : apart; j < curves.size(); ++j) {
            ++found.pairs;
            const auto& slips = curves[i].slip_percent;
            if (const auto x = find_crossing(fits[i], fits[j], slips.front(), slips.back()))
                found.slip_percent.push_back(*x);
        }
    return found;
}

/// Twelve uniforms: close to normal, and the same bits everywhere, which std::log and std::cos do not promise.
double draw_normal(Random& random) {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += random.uniform();
    return sum;
}

std::vector<std::vector<double>> redraw(const std::vector<TrendPoints>& curves, Random& random) {
    std::vector<std::vector<double>> values;
    for (const auto& c : curves) {
        // Widened by Student's t over the normal quantile, since s itself is known by ν degrees of freedom only.
        const double s = c.scatter.deviation * student_t_quantile(0.975, c.scatter.degrees_of_freedom) / 1.96;
        values.push_back(c.mean);
        for (std::size_t k = 0; k < c.mean.size(); ++k) values.back()[k] += s / std::sqrt(c.n[k]) * draw_normal(random);
    }
    return values;
}

std::string describe(const Crossings& found) {
    const std::string count = fmt::format("{} of {} pairs cross", found.slip_percent.size(), found.pairs);
    if (found.slip_percent.empty()) return count;
    const auto [least, most] = std::minmax_element(found.slip_percent.begin(), found.slip_percent.end());
    return fmt::format("{}, at {:.0f}–{:.0f} % of slip", count, *least, *most);
}

/// How often a statement about the crossings holds where the curves are drawn anew within their run errors.
template <class Statement>
void judge_redraws(const std::vector<TrendPoints>& curves, std::size_t apart, TrendResult& result, Statement&& holds) {
    constexpr int draws = 1000;
    if (!std::all_of(curves.begin(), curves.end(),
                     [](const TrendPoints& c) { return c.scatter.degrees_of_freedom >= 1; }))
        return;
    Random random{1};
    int count = 0;
    for (int k = 0; k < draws; ++k) count += holds(find_crossings(curves, redraw(curves, random), apart)) ? 1 : 0;
    const double share = static_cast<double>(count) / draws;
    result.finding = share >= 0.95 ? Finding::within : share <= 0.05 ? Finding::outside : Finding::too_uncertain;
    result.detail +=
        fmt::format("; the statement holds in {:.0f} % of {} redraws within the run errors", 100 * share, draws);
}

std::vector<std::vector<double>> means_of(const std::vector<TrendPoints>& curves) {
    std::vector<std::vector<double>> means;
    for (const auto& c : curves) means.push_back(c.mean);
    return means;
}

}  // namespace

TrendResult judge_cross(const std::vector<TrendPoints>& curves, double tolerance_percent) {
    const Crossings found = find_crossings(curves, means_of(curves), 0);
    TrendResult result;
    result.tolerance_text = format_number(tolerance_percent);
    result.detail = describe(found);
    if (found.is_complete()) {
        result.statistic = found.spread();
        result.error_over_tolerance = found.spread() / tolerance_percent;
    }
    judge_redraws(curves, 0, result, [&](const Crossings& c) { return c.are_common(tolerance_percent); });
    return result;
}

TrendResult judge_not_cross(const std::vector<TrendPoints>& curves, const std::vector<TrendPoints>& others,
                            double tolerance_percent) {
    std::vector<TrendPoints> all = curves;
    all.insert(all.end(), others.begin(), others.end());
    const Crossings found = find_crossings(all, means_of(all), curves.size());
    TrendResult result;
    result.tolerance_text = format_number(tolerance_percent);
    result.detail = describe(found);
    if (found.is_complete()) result.statistic = found.spread();
    judge_redraws(all, curves.size(), result, [&](const Crossings& c) { return !c.are_common(tolerance_percent); });
    return result;
}

}  // namespace ifedem

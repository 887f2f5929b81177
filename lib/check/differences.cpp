#include "check/differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

struct ShortName {
    std::string_view name, metric;
};
constexpr ShortName short_names[] = {
    {"H", "gross_tractive_effort_N"}, {"Pd", "net_traction_N"}, {"R", "motion_resistance_N"}, {"z", "sinkage_cm"}};

std::string list_names() {
    std::string names = "H, Pd, R, z";
    for (const MetricInfo& info : metric_table()) names += fmt::format(", {}", info.name);
    return names;
}

std::vector<double> collect(std::span<const RunMetrics> runs, const ComparedMetric& quantity) {
    std::vector<double> values;
    for (const RunMetrics& run : runs) values.push_back(run.*quantity.metric->member);
    return values;
}

}  // namespace

std::vector<ComparedMetric> parse_quantities(const std::string& text) {
    std::vector<ComparedMetric> quantities;
    for (const std::string& name : split(text, ',')) {
        std::string_view metric = name;
        for (const ShortName& known : short_names)
            if (name == known.name) metric = known.metric;
        quantities.push_back({name, find_metric(metric)});
        if (quantities.back().metric == nullptr)
            fail_input(fmt::format("--quantities {}: '{}' is not known (there are {}). Correct it?", text, name,
                                   list_names()));
    }
    return quantities;
}

double parse_tolerance(const std::string& text) {
    const bool percent = text.ends_with('%');
    const auto value = percent ? parse_number(text.substr(0, text.size() - 1)) : std::nullopt;
    if (!value || !(*value > 0) || !(*value < 100))
        fail_input(
            fmt::format("--tolerance {} is no share of a quantity (it must be a number of per cent between 0 and "
                        "100). Write it like 5%?",
                        text));
    return *value / 100;
}

Difference find_difference(std::span<const RunMetrics> before, std::span<const RunMetrics> after,
                           const ComparedMetric& quantity, double tolerance) {
    const std::vector<double> a = collect(before, quantity), b = collect(after, quantity);
    const double from = mean(a);
    return {from, mean(b), paired_difference(a, b), tolerance * std::abs(from)};
}

Difference expect_no_difference(std::span<const RunMetrics> runs, const ComparedMetric& quantity, double tolerance) {
    const std::vector<double> values = collect(runs, quantity);
    const auto n = static_cast<double>(values.size());
    const double half_width = student_t_quantile(0.975, n - 1) * standard_deviation(values) * std::sqrt(2 / n);
    const double level = mean(values);
    return {level, level, {0, half_width, values.size()}, tolerance * std::abs(level)};
}

Movement judge_movement(const Difference& difference) {
    if (std::abs(difference.paired.mean) > difference.paired.half_width) return Movement::moves;
    return is_within_scatter(difference.paired, difference.tolerance) ? Movement::within_scatter
                                                                      : Movement::cannot_tell;
}

std::string_view to_text(Movement movement) {
    constexpr std::string_view words[] = {"moves", "within scatter", "cannot tell"};
    return words[static_cast<std::size_t>(movement)];
}

bool is_small(const Difference& difference, DifferenceEvidence evidence) {
    const double doubt = evidence == DifferenceEvidence::shown ? difference.paired.half_width : 0;
    return std::abs(difference.paired.mean) + doubt <= difference.tolerance;
}

double realisations_needed(const Difference& difference) {
    const auto n = static_cast<double>(difference.paired.n);
    const double scatter = difference.paired.half_width * std::sqrt(n) / student_t_quantile(0.975, n - 1);
    if (!(difference.tolerance > 0)) return std::numeric_limits<double>::infinity();
    double needed = std::max(2.0, std::ceil(std::pow(1.96 * scatter / difference.tolerance, 2)));
    while (student_t_quantile(0.975, needed - 1) * scatter > difference.tolerance * std::sqrt(needed)) ++needed;
    return needed;
}

}  // namespace ifedem

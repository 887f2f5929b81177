#include "check/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr std::array<const char*, 4> judged{"gross_tractive_effort_N", "net_traction_N", "motion_resistance_N",
                                            "sinkage_cm"};

/// Runs of one variant under one condition, each beside its partner.
struct Pairs {
    Condition condition;
    std::string changes;
    std::vector<RunMetrics> defaults, variants;
    std::optional<Window> window;  ///< if not the text's
};

std::string variant_of(const Run& run) { return run.name.substr(0, run.name.find('-')); }

Effect summarise(const std::string& variant, const Pairs& pairs, const MetricInfo& metric, const Campaign& campaign) {
    std::vector<double> before, after;
    for (std::size_t k = 0; k < pairs.variants.size(); ++k) {
        before.push_back(pairs.defaults[k].*metric.member);
        after.push_back(pairs.variants[k].*metric.member);
    }
    const Curve curve{pairs.condition.wheel, pairs.condition.gravity, pairs.condition.load_N};
    const PooledScatter scatter = borrow_scatter(campaign, curve, metric, pairs.window).pooled;
    const Estimate a = estimate(before, 0, scatter);
    const Estimate b = estimate(after, 0, scatter);
    const PairedDifference difference = paired_difference(before, after);
    Effect e{variant,
             pairs.changes,
             curve.gravity,
             curve.load_N,
             pairs.condition.slip_percent,
             a.n,
             std::string(metric.name),
             a.mean,
             a.uncertainty,
             b.mean,
             b.uncertainty,
             difference.mean,
             difference.half_width};
    constexpr std::size_t enough_pairs = 3;
    if (a.n < enough_pairs && scatter.degrees_of_freedom >= 1)
        e.half_width = student_t_quantile(0.975, scatter.degrees_of_freedom) * scatter.deviation *
                       std::sqrt(2 / static_cast<double>(a.n));
    return e;
}

/// A short label of changes: keys without their tables, each change once, no quotes.
std::string shorten(const std::string& changes) {
    std::vector<std::string> parts;
    for (std::string rest = changes; !rest.empty();) {
        const auto comma = rest.find(", ");
        std::string part = rest.substr(0, comma);
        rest = comma == std::string::npos ? "" : rest.substr(comma + 2);
        part.erase(0, part.substr(0, part.find(' ')).find_last_of('.') + 1);
        std::erase(part, '"');
        if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// Effects are named by variant, planet and slip.
void require_own_name(const Condition& condition, const std::map<Condition, Pairs>& conditions) {
    for (const auto& [other, pairs] : conditions)
        if (!(other == condition) && other.gravity == condition.gravity && other.slip_percent == condition.slip_percent)
            fail_input(
                fmt::format("{} and {} have the same planet and slip (effects are named by these). Measure them "
                            "apart?",
                            to_text(condition), to_text(other)));
}

}  // namespace

std::string describe_changes(const Case& from, const Case& to) {
    Case like = to;
    like.name = from.name;
    like.record = from.record;
    like.bed.seed = from.bed.seed;
    like.wheel.lug_phase_deg = from.wheel.lug_phase_deg;
    like.wheel.load_N = from.wheel.load_N;
    like.gravity_m_s2 = from.gravity_m_s2;
    like.travel.slip_percent = from.travel.slip_percent;
    const auto after = list_changes(from, like), before = list_changes(like, from);  // the same keys
    std::vector<std::string> changes;
    for (std::size_t k = 0; k < after.size(); ++k)
        changes.push_back(fmt::format("{} {} → {}", after[k].key, before[k].value, after[k].value));
    return fmt::format("{}", fmt::join(changes, ", "));
}

std::vector<Effect> measure_effects(const std::vector<std::string>& default_dirs,
                                    const std::vector<std::string>& variant_dirs) {
    const Campaign campaign = read_campaign(default_dirs);
    std::vector<std::string> order;
    std::map<std::string, std::map<Condition, Pairs>> found;
    for (const auto& directory : variant_dirs) {
        const Run run = read_run(directory);
        const auto partner = std::find_if(campaign.runs.begin(), campaign.runs.end(),
                                          [&](const MeasuredRun& m) { return is_same_realisation(m.run.c, run.c); });
        if (partner == campaign.runs.end())
            fail_input(
                fmt::format("{}: no default run has its planet, load, slip, seed and lug phase. Run one?", directory));
        const std::string variant = variant_of(run);
        if (std::find(order.begin(), order.end(), variant) == order.end()) order.push_back(variant);
        Pairs& pairs = found[variant][partner->condition];
        pairs.condition = partner->condition;
        pairs.changes = describe_changes(partner->run.c, run.c);
        const Window window = compared_window(run.c);
        if (run.c.travel.distance_m < partner->run.c.travel.distance_m) pairs.window = window;
        pairs.variants.push_back(measure(run, window));
        pairs.defaults.push_back(measure(partner->run, window));
    }
    std::vector<Effect> effects;
    for (const auto& variant : order)
        for (const auto& [condition, pairs] : found[variant]) {
            require_own_name(condition, found[variant]);
            for (const char* name : judged) effects.push_back(summarise(variant, pairs, *find_metric(name), campaign));
        }
    return effects;
}

void write_effects(const std::vector<std::string>& default_dirs, const std::vector<std::string>& variant_dirs,
                   const std::string& directory) {
    std::string table =
        "variant,changes,gravity,load_N,slip_percent,n,metric,default,default_U,value,value_U,effect,half_width\n";
    std::vector<Measurement> measurements;
    for (const auto& e : measure_effects(default_dirs, variant_dirs)) {
        table += csv_line({e.variant, e.changes, e.gravity, format_number(e.load_N), format_number(e.slip_percent),
                           std::to_string(e.n), e.metric, format_number(e.before), format_number(e.before_uncertainty),
                           format_number(e.after), format_number(e.after_uncertainty), format_number(e.effect),
                           format_number(e.half_width)});
        measurements.push_back({fmt::format("{}:{}:s{:g}:{}", e.variant, e.gravity, e.slip_percent, e.metric), e.effect,
                                std::string(find_metric(e.metric)->unit), 0, e.n, e.changes, e.half_width});
    }
    write_text(directory + "/effects.csv", table);
    write_text(directory + "/measurements.csv", measurements_csv(measurements));
}

std::vector<Effect> read_effects(const std::string& path) {
    const CsvTable table = read_csv(path);
    std::vector<Effect> effects;
    for (const auto& row : table.rows) {
        const auto text = [&](const char* column) { return row.cells[table.require(column)]; };
        const auto number = [&](const char* column) { return number_or_infinity(table, row, column); };
        effects.push_back({text("variant"), text("changes"), text("gravity"), number("load_N"), number("slip_percent"),
                           count_of(table, row, "n"), text("metric"), number("default"), number("default_U"),
                           number("value"), number("value_U"), number("effect"), number("half_width")});
        if (find_metric(effects.back().metric) == nullptr)
            fail_input(fmt::format("{}:{}: metric '{}' is not known. Write the file anew with `ifedem effects`?", path,
                                   row.line, effects.back().metric));
    }
    return effects;
}

std::optional<std::string> effects_data(const std::vector<Effect>& effects, const std::string& gravity,
                                        double slip_percent) {
    std::vector<std::string> labels;
    std::map<std::string, std::map<std::string, const Effect*>> by_label;
    for (const auto& e : effects) {
        if (e.gravity != gravity || std::abs(e.slip_percent - slip_percent) > 1e-9) continue;
        if (!by_label.contains(e.changes)) labels.push_back(e.changes);
        by_label[e.changes][e.metric] = &e;
    }
    if (labels.empty()) return std::nullopt;
    std::string text = "row,label";
    for (const char* metric : judged) text += fmt::format(",{0},{0}_half_width", metric);
    text += '\n';
    for (std::size_t k = 0; k < labels.size(); ++k) {
        std::vector<std::string> cells{std::to_string(k), shorten(labels[k])};
        for (const char* metric : judged) {
            const Effect& e = *by_label[labels[k]].at(metric);
            cells.push_back(format_number(e.effect));
            cells.push_back(format_number(e.half_width));
        }
        text += csv_line(cells);
    }
    return text;
}

}  // namespace ifedem

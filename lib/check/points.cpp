#include "check/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

#include "check/csv.hpp"
#include "check/effects.hpp"
#include "check/metrics.hpp"
#include "check/statistics.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

constexpr std::array<Quantity, 6> quantities{{{"gross_tractive_effort_N", "N", "H"},
                                              {"net_traction_N", "N", "P_d"},
                                              {"motion_resistance_N", "N", "R"},
                                              {"sinkage_cm", "cm", "z"},
                                              {"greatest_normal_stress_kPa", "kPa", "max σ"},
                                              {"greatest_tangential_stress_kPa", "kPa", "max τ"}}};

/// One run of one variant, measured once.
struct Trial {
    std::string variant;
    std::string run_variant;  ///< the same, but for windows: of the run that they look at
    Case c;
    std::string stopped;
    Work work;
    double simulated_s = 0;
    Values values;
    [[nodiscard]] double value(std::string_view quantity) const {
        const auto at = values.find(quantity);
        return at == values.end() ? unknown : at->second;
    }
};

using Trials = std::vector<Trial>;

Trial measure_trial(const Run& run, const Window& window, const std::string& variant) {
    Trial trial;
    trial.variant = trial.run_variant = variant;
    trial.c = run.c;
    const RunMetrics metrics = measure(run, window);
    for (const Quantity& q : quantities)
        if (const MetricInfo* metric = find_metric(q.name)) trial.values.emplace(q.name, metrics.*(metric->member));
    const double steps = run.number("total_steps");
    trial.work = {run.number("particles") * steps, run.number("ns_per_particle_step")};
    trial.simulated_s = steps * run.c.time_step_s;
    return trial;
}

Trial read_stopped(const fs::path& directory, const std::string& variant) {
    Trial trial;
    trial.variant = trial.run_variant = variant;
    trial.c = read_case((directory / "case.toml").string());
    trial.stopped = read_text((directory / "stopped.txt").string());
    trial.stopped.erase(trial.stopped.find_last_not_of(" \n") + 1);
    return trial;
}

/// Other windows of the same run, as shares of the travel: each costs what a travel to its end costs.
void add_windows(const Run& run, const Trial& whole, Trials& trials) {
    constexpr std::array<Window, 4> shares{{{0.25, 0.5}, {0.375, 0.625}, {0.5, 0.75}, {0.75, 1}}};
    const double way = compared_window(run.c).to_m;
    for (const Window& share : shares) {
        const Window window{share.from_m * way, share.to_m * way};
        if (window.to_m - window.from_m < lug_pair_pitch_m(run.c)) continue;
        Trial trial =
            measure_trial(run, window, fmt::format("window{:.3g}-{:.3g}cm", 100 * window.from_m, 100 * window.to_m));
        trial.run_variant = whole.variant;
        const auto& x = run.travel.at("wheel_x_m");
        const auto& time = run.travel.at("time_s");
        const auto end = std::ranges::find_if(x, [&](double place) { return place - x.front() >= window.to_m; });
        if (end != x.end()) {
            const double saved_s = time.back() - time[static_cast<std::size_t>(end - x.begin())];
            trial.work.disc_steps *= 1 - saved_s / whole.simulated_s;
        }
        trials.push_back(std::move(trial));
    }
}

Trials read_trials(const PointsRequest& request) {
    Trials trials, windows;
    for (const auto& name : request.run_dirs) {
        const fs::path directory = fs::path(name).lexically_normal();
        const std::string run_name = directory.filename().string();
        const std::string variant = run_name.substr(0, run_name.find('-'));
        if (!fs::exists(directory / "run.csv") && fs::exists(directory / "stopped.txt")) {
            trials.push_back(read_stopped(directory, variant));
            continue;
        }
        const Run run = read_run(directory.string());
        trials.push_back(measure_trial(run, compared_window(run.c), variant));
        if (request.measure_more) trials.back().values.merge(request.measure_more(run));
        if (variant == request.plain) add_windows(run, trials.back(), windows);
    }
    trials.insert(trials.end(), windows.begin(), windows.end());
    return trials;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The same machine's mood for all runs of a variant: one median, over its conditions and realisations.
void share_calibration(Trials& trials) {
    std::map<std::string, std::vector<double>> ns;
    for (const Trial& t : trials)
        if (t.stopped.empty()) ns[t.run_variant].push_back(t.work.ns_per_disc_step);
    for (Trial& t : trials)
        if (t.stopped.empty()) t.work.ns_per_disc_step = median(ns[t.run_variant]);
}

const Trial& find_partner(const Trials& trials, const std::string& variant, const Trial& of) {
    const auto found = std::ranges::find_if(trials, [&](const Trial& t) {
        return t.variant == variant && t.stopped.empty() && is_same_realisation(t.c, of.c);
    });
    if (found == trials.end())
        fail_input(
            fmt::format("'{}' at slip {:g} %, seed {}: there is no finished run of variant '{}' with the same "
                        "planet, load, slip, seed and lug phase. Run it?",
                        of.variant, of.c.travel.slip_percent, of.c.bed.seed, variant));
    return *found;
}

/// What a stopped run would have cost: the plain one's time at its own step, disc for disc.
Work planned_work(const Trial& stopped, const Trial& plain) {
    const double discs = static_cast<double>(planned_discs(stopped.c)) / static_cast<double>(planned_discs(plain.c));
    return {plain.work.disc_steps * discs * plain.c.time_step_s / stopped.c.time_step_s, plain.work.ns_per_disc_step};
}

/// Lines of the references that hold for a condition; empty cells hold for all.
struct References {
    CsvTable table;
    const Ledger* ledger = nullptr;

    [[nodiscard]] const LedgerRow* find(std::string_view quantity, const Condition& condition) const {
        for (const auto& row : table.rows) {
            const auto text = [&](const char* column) { return row.cells[table.require(column)]; };
            const auto agrees = [&](const char* column, double value) {
                return text(column).empty() || std::abs(parse_number(text(column)).value_or(unknown) - value) < 1e-9;
            };
            if (text("quantity") != quantity || (!text("wheel").empty() && text("wheel") != condition.wheel) ||
                (!text("gravity").empty() && text("gravity") != condition.gravity) ||
                !agrees("load_N", condition.load_N) || !agrees("slip_percent", condition.slip_percent))
                continue;
            const auto found = ledger->find(text("id"));
            if (found == ledger->end() || !found->second.number())
                fail_input(fmt::format("{}:{}: {} is no number of the ledger. Correct the id?", table.path, row.line,
                                       text("id")));
            return &found->second;
        }
        return nullptr;
    }
    [[nodiscard]] const LedgerRow& require(const std::string& quantity, const Condition& condition) const {
        const LedgerRow* row = find(quantity, condition);
        if (row == nullptr)
            fail_input(fmt::format("{}: no line for {} ({}). Add one?", table.path, quantity, to_text(condition)));
        return *row;
    }
};

/// Runs of one variant under one condition, each beside the finest's.
struct Group {
    std::string variant;
    std::vector<const Trial*> runs, finest, plain;
    [[nodiscard]] bool is_stopped() const { return !runs.front()->stopped.empty(); }
};

std::vector<double> values_of(const std::vector<const Trial*>& trials, const Quantity& quantity) {
    std::vector<double> out;
    for (const Trial* t : trials) out.push_back(t->value(quantity.name));
    return out;
}

using Groups = std::vector<Group>;

/// By condition; a variant of which one run was stopped counts as stopped.
std::map<Condition, Groups> group_trials(const Trials& trials, const PointsRequest& request) {
    std::map<Condition, Groups> groups;
    for (const Trial& trial : trials) {
        const Trial& finest = find_partner(trials, request.finest, trial);
        const Trial& plain = find_partner(trials, request.plain, trial);
        Groups& all = groups[condition_of(plain.c)];
        auto group = std::ranges::find(all, trial.variant, &Group::variant);
        if (group == all.end()) group = all.insert(all.end(), Group{trial.variant, {}, {}, {}});
        if (!group->runs.empty() && group->is_stopped()) continue;
        if (!trial.stopped.empty()) group->runs.clear(), group->finest.clear(), group->plain.clear();
        group->runs.push_back(&trial);
        group->finest.push_back(&finest);
        group->plain.push_back(&plain);
    }
    return groups;
}

Work mean_work(const Group& group) {
    if (group.is_stopped()) return planned_work(*group.runs.front(), *group.plain.front());
    Work work{0, group.runs.front()->work.ns_per_disc_step};
    for (const Trial* t : group.runs) work.disc_steps += t->work.disc_steps / static_cast<double>(group.runs.size());
    return work;
}

bool is_window(const Group& group) { return group.variant.starts_with("window"); }

Point make_point(const Group& group, const Quantity& quantity, const Work& fidelity, const LedgerRow* text) {
    Point p;
    p.quantity = quantity.name;
    p.variant = group.variant;
    p.changes = is_window(group) ? "averaged over another window"
                                 : describe_changes(group.plain.front()->c, group.runs.front()->c);
    p.n = group.runs.size();
    p.work = mean_work(group);
    p.relative_cost = p.work.cpu_s() / fidelity.cpu_s();
    p.stopped = group.runs.front()->stopped;
    if (group.is_stopped()) return p;
    const auto values = values_of(group.runs, quantity);
    p.value = mean(values);
    if (p.n > 1) p.scatter = standard_deviation(values);
    if (text != nullptr) p.error_text = std::abs(p.value - *text->number());
    if (group.runs.front() == group.finest.front()) return p;  // no error against itself
    const PairedDifference d = paired_difference(values_of(group.finest, quantity), values);
    p.error_fine = std::abs(d.mean);
    if (p.n > 1) p.error_fine_U = d.half_width;
    return p;
}

/// What hides errors: scatter of paired differences to the finest, or of the values themselves against the text's one
/// number. The windows' points are the same runs again and stay out of the pool.
PooledScatter scatter_of(const Groups& groups, const Quantity& quantity, Against against) {
    std::vector<std::vector<double>> pool;
    for (const Group& g : groups) {
        if (g.is_stopped() || is_window(g)) continue;
        auto values = values_of(g.runs, quantity);
        if (against == Against::finest) {
            if (g.runs.front() == g.finest.front()) continue;
            const auto fine = values_of(g.finest, quantity);
            std::ranges::transform(values, fine, values.begin(), std::minus<>{});
        }
        pool.push_back(std::move(values));
    }
    return pool_scatter(pool);
}

void find_front(Chart& chart) {
    std::vector<CostError> marks;
    for (const Point& p : chart.points) {
        const double floor = chart.floor(p.n), error = chart.error_of(p);
        marks.push_back(
            {p.relative_cost, std::isfinite(floor) && std::isfinite(error) ? std::max(error, floor) : error});
    }
    chart.front = pareto_front(marks, chart.floor(chart.n));
}

/// What a model without runs says, against the finest's mean. It has one value: no realisations, no scatter.
Point make_model_point(const ModelWithoutRuns& model, const Case& plain, const Quantity& quantity, const Chart& chart,
                       const Work& fidelity, const LedgerRow* text) {
    Point p;
    p.quantity = quantity.name;
    p.variant = model.variant, p.changes = model.changes;
    p.n = 1;
    p.work = model.work;
    p.relative_cost = p.work.cpu_s() / fidelity.cpu_s();
    const Values values = model.predict(plain);
    const auto at = values.find(quantity.name);
    if (at == values.end()) return p;
    p.value = at->second;
    p.error_fine = std::abs(p.value - chart.reference);
    if (text != nullptr) p.error_text = std::abs(p.value - *text->number());
    return p;
}

/// The condition of one set of charts, and what all its points share.
struct ConditionSet {
    Condition condition;
    const Groups& groups;
    Work fidelity;
    int chapter = 0;
};

Chart make_chart(const ConditionSet& all, const Quantity& quantity, const PointsRequest& request,
                 const LedgerRow* text) {
    Chart chart;
    chart.condition = all.condition;
    chart.quantity = quantity.name;
    chart.scatter = scatter_of(all.groups, quantity, Against::finest);
    const auto finest = std::ranges::find(all.groups, request.finest, &Group::variant);
    if (finest != all.groups.end()) {
        chart.n = finest->runs.size();
        chart.reference = mean(values_of(finest->runs, quantity));
    }
    for (const Group& group : all.groups) chart.points.push_back(make_point(group, quantity, all.fidelity, text));
    for (const ModelWithoutRuns& model : request.models)
        chart.points.push_back(
            make_model_point(model, all.groups.front().plain.front()->c, quantity, chart, all.fidelity, text));
    // A quantity that a run does not have: contact stress over another window.
    std::erase_if(chart.points, [](const Point& p) { return p.stopped.empty() && !std::isfinite(p.value); });
    for (Point& p : chart.points) p.chapter = all.chapter, p.condition = all.condition;
    find_front(chart);
    return chart;
}

void add_condition(const Condition& condition, const Groups& groups, const PointsRequest& request,
                   const References& references, PointSet& set) {
    const LedgerRow& discs = references.require("discs", condition);
    const Trial& finest = *groups.front().finest.front();
    const Work fidelity = fidelity_work(*discs.number(), *references.require("time_step_s", condition).number(),
                                        finest.simulated_s, finest.work.ns_per_disc_step);
    set.fidelity[condition.slip_percent] = fidelity;
    for (const Quantity& quantity : quantities) {
        if (!std::isfinite(finest.value(quantity.name))) continue;
        const LedgerRow* text = references.find(quantity.name, condition);
        Chart chart = make_chart({condition, groups, fidelity, discs.chapter}, quantity, request, text);
        set.points.insert(set.points.end(), chart.points.begin(), chart.points.end());
        set.charts.push_back(chart);
        if (text == nullptr) continue;
        chart.against = Against::text;
        chart.scatter = scatter_of(groups, quantity, Against::text);
        chart.reading_U = reading_uncertainty(text->value, text->units, condition.gravity);
        chart.reference = *text->number();
        find_front(chart);
        set.charts.push_back(std::move(chart));
    }
}

}  // namespace

std::span<const Quantity> point_quantities() { return quantities; }

double Chart::floor(std::size_t realisations) const {
    if (scatter.degrees_of_freedom < 1 || realisations == 0) return unknown;
    if (against == Against::finest) return scatter_floor(scatter, realisations);
    return prediction_uncertainty(scatter.deviation, scatter.degrees_of_freedom, realisations, reading_U);
}

PointSet measure_points(const PointsRequest& request, const Ledger& ledger) {
    Trials trials = read_trials(request);
    share_calibration(trials);
    const References references{read_csv(request.references_path), &ledger};
    PointSet set;
    for (const auto& [condition, groups] : group_trials(trials, request))
        add_condition(condition, groups, request, references, set);
    return set;
}

std::string points_to_csv(const std::vector<Point>& points) {
    std::string text =
        "chapter,wheel,gravity,load_N,slip_percent,quantity,variant,n,relative_cost,error_fine,error_text,scatter,"
        "error_fine_U,value,units,disc_steps,ns_per_disc_step,changes,stopped\n";
    for (const Point& p : points)
        text += csv_line(
            {std::to_string(p.chapter), p.condition.wheel, p.condition.gravity, format_number(p.condition.load_N),
             format_number(p.condition.slip_percent), p.quantity, p.variant, std::to_string(p.n),
             format_number(p.relative_cost), format_number(p.error_fine), format_number(p.error_text),
             format_number(p.scatter), format_number(p.error_fine_U), format_number(p.value),
             std::string(std::ranges::find(quantities, p.quantity, &Quantity::name)->unit),
             format_number(p.work.disc_steps), format_number(p.work.ns_per_disc_step), p.changes, p.stopped});
    return text;
}

}  // namespace ifedem

#include "check/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>

#include "check/csv.hpp"
#include "check/effects.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

void read_stiffness(const std::filesystem::path& directory, Campaign& campaign) {
    const CsvTable summary = read_csv((directory / "stiffness_summary.csv").string());
    for (const auto& row : summary.rows)
        campaign.stiffness.push_back({row.cells[summary.require("wheel")], number_of(summary, row, "stiffness_N_mm"),
                                      number_of(summary, row, "min_N_mm"), number_of(summary, row, "max_N_mm")});
    const auto points_path = directory / "stiffness.csv";
    if (!std::filesystem::exists(points_path)) return;
    const CsvTable points = read_csv(points_path.string());
    for (const auto& row : points.rows)
        campaign.stiffness_points.push_back({row.cells[points.require("wheel")], number_of(points, row, "phase_deg"),
                                             number_of(points, row, "deflection_m"), number_of(points, row, "load_N")});
}

void read_doubts(const std::filesystem::path& directory, Campaign& campaign) {
    const CsvTable table = read_csv((directory / "doubt.csv").string());
    for (const auto& row : table.rows) {
        const auto text = [&](const char* column) { return row.cells[table.require(column)]; };
        const auto number = [&](const char* column) { return number_or_infinity(table, row, column); };
        campaign.doubts.push_back({text("variation"), text("changes"), text("quantity"), text("unit"),
                                   count_of(table, row, "n"), number("difference"), number("half_width"),
                                   number("tolerance"), text("verdict"), number_of(table, row, "relative_cost"),
                                   text("note")});
    }
}

void require_distinct_measurements(const Campaign& campaign) {
    std::set<std::string> names;
    for (const auto& m : campaign.measurements)
        if (!names.insert(m.name).second)
            fail_input(fmt::format("The measurement {} stands twice. Leave one directory or one line out?", m.name));
}

/// The case without what may differ between realisations, and without what does not change results.
Case without_realisation(Case c) {
    c.name.clear();
    c.bed.seed = 0;
    c.wheel.lug_phase_deg = 0;
    c.record = {};
    return c;
}

void require_same_physics(const MeasuredRun& a, const MeasuredRun& b) {
    const Case left = without_realisation(a.run.c), right = without_realisation(b.run.c);
    const auto here = list_changes(right, left), there = list_changes(left, right);  // the same keys
    if (here.empty()) return;
    fail_input(
        fmt::format("{} and {} stand for one condition ({}) but differ: {} = {} against {}. Give only runs that "
                    "differ in seed or lug phase?",
                    a.run.directory, b.run.directory, to_text(a.condition), here.front().key, here.front().value,
                    there.front().value));
}

void require_realisations(const Campaign& campaign) {
    for (std::size_t k = 1; k < campaign.runs.size(); ++k)
        for (std::size_t j = k; j-- > 0 && campaign.runs[j].condition == campaign.runs[k].condition;) {
            const auto& a = campaign.runs[j];
            const auto& b = campaign.runs[k];
            require_same_physics(a, b);
            if (a.run.c.bed.seed == b.run.c.bed.seed && a.run.c.wheel.lug_phase_deg == b.run.c.wheel.lug_phase_deg)
                fail_input(fmt::format("{} and {} are the same realisation (seed and lug phase agree). Leave one out?",
                                       a.run.directory, b.run.directory));
        }
}

/// The text's window if the run reached its end; else the same share of what it was told to travel, at least one pitch.
MeasuredRun measure_run(Run run) {
    MeasuredRun m{std::move(run), {}, {}, {}};
    m.condition = condition_of(m.run.c);
    const double needed = averaging_window(m.run.c).to_m, distance = m.run.c.travel.distance_m;
    Window window = compared_window(m.run.c);
    if (distance < needed * (1 - 1e-12)) {  // a difference of places, rounded
        m.shortfall =
            fmt::format("{} travelled {:g} m of the {:g} m that the text's window needs", m.run.name, distance, needed);
        window.from_m = std::max(0.0, std::min(window.from_m, distance - lug_pair_pitch_m(m.run.c)));
    }
    try {
        m.metrics = measure(m.run, window);
    } catch (const Error& e) {
        m.shortfall = e.what();
        m.metrics = unknown_metrics();
    }
    return m;
}

void read_directory(const std::string& name, Campaign& campaign) {
    const std::filesystem::path directory(name);
    const bool is_run = std::filesystem::exists(directory / "case.toml");
    const bool is_stiffness = std::filesystem::exists(directory / "stiffness_summary.csv");
    const bool is_measured = std::filesystem::exists(directory / "measurements.csv");
    const bool is_doubt = std::filesystem::exists(directory / "doubt.csv");
    if (!is_run && !is_stiffness && !is_measured && !is_doubt)
        fail_input(
            fmt::format("{}: neither case.toml nor stiffness_summary.csv, measurements.csv or doubt.csv is there. Give "
                        "run directories?",
                        name));
    if (is_doubt) read_doubts(directory, campaign);
    if (is_measured) {
        const auto rows = read_measurements((directory / "measurements.csv").string());
        campaign.measurements.insert(campaign.measurements.end(), rows.begin(), rows.end());
    }
    if (std::filesystem::exists(directory / "effects.csv")) {
        const auto effects = read_effects((directory / "effects.csv").string());
        campaign.effects.insert(campaign.effects.end(), effects.begin(), effects.end());
    }
    if (is_stiffness) read_stiffness(directory, campaign);
    if (is_run) campaign.runs.push_back(measure_run(read_run(name)));
}

}  // namespace

Campaign read_campaign(const std::vector<std::string>& directories) {
    Campaign campaign;
    campaign.directories = directories;
    for (const auto& name : directories) {
        try {
            read_directory(name, campaign);
        } catch (const Error& e) {
            campaign.unusable.emplace_back(e.what());
        }
    }
    std::stable_sort(campaign.runs.begin(), campaign.runs.end(), [](const MeasuredRun& a, const MeasuredRun& b) {
        return std::tie(a.condition, a.run.name, a.run.directory) < std::tie(b.condition, b.run.name, b.run.directory);
    });
    require_realisations(campaign);
    require_distinct_measurements(campaign);
    return campaign;
}

const Measurement* find_measurement(const Campaign& campaign, const std::string& name) {
    for (const auto& m : campaign.measurements)
        if (m.name == name) return &m;
    return nullptr;
}

std::optional<double> uncertainty_of(const Measurement& m, double reading) {
    if (m.uncertainty) return std::hypot(*m.uncertainty, reading);
    if (m.n > 1) return prediction_uncertainty(m.scatter, static_cast<double>(m.n - 1), m.n, reading);
    return std::nullopt;
}

bool is_on(const Curve& curve, const Condition& condition) {
    return condition.wheel == curve.wheel && condition.gravity == curve.gravity &&
           std::abs(condition.load_N - curve.load_N) < 1e-9;
}

ValuesBySlip collect(const Campaign& campaign, const Curve& curve, const MetricInfo& metric,
                     const std::optional<Window>& window) {
    ValuesBySlip values;
    for (const auto& run : campaign.runs) {
        if (!is_on(curve, run.condition) || !run.shortfall.empty()) continue;
        const double value = (window ? measure(run.run, *window) : run.metrics).*metric.member;
        values[run.condition.slip_percent].push_back(value);
    }
    return values;
}

PooledScatter pool(const ValuesBySlip& values) {
    std::vector<std::vector<double>> groups;
    for (const auto& [slip, group] : values) groups.push_back(group);
    return pool_scatter(groups);
}

BorrowedScatter borrow_scatter(const Campaign& campaign, const Curve& curve, const MetricInfo& metric,
                               const std::optional<Window>& window) {
    constexpr double enough_freedom = 6;
    const PooledScatter own = pool(collect(campaign, curve, metric, window));
    if (own.degrees_of_freedom >= enough_freedom) return {own, false};
    std::set<Curve> curves;
    for (const auto& run : campaign.runs)
        if (run.condition.gravity == curve.gravity)
            curves.insert({run.condition.wheel, run.condition.gravity, run.condition.load_N});
    std::vector<std::vector<double>> groups;
    for (const auto& other : curves) {
        const double scale = metric.unit == "N" ? curve.load_N / other.load_N : 1;
        for (auto& [slip, group] : collect(campaign, other, metric, window)) {
            groups.push_back(group);
            for (double& v : groups.back()) v *= scale;
        }
    }
    const PooledScatter all = pool_scatter(groups);
    if (all.degrees_of_freedom > own.degrees_of_freedom) return {all, true};
    return {own, false};
}

}  // namespace ifedem

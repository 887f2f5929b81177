#include "app/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/children.hpp"
#include "app/run_set.hpp"
#include "app/sweep_report.hpp"
#include "check/csv.hpp"
#include "core/error.hpp"
#include "record/directory_lock.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

/// The case with one load and slip. Exactly what the children are told by --set, so that both resolve it alike.
std::vector<Override> settings_of(const SweepRequest& request, double load_N, double slip_percent) {
    std::vector<Override> settings = request.overrides;
    settings.push_back({"wheel.load_N", fmt::format("{}", load_N)});
    settings.push_back({"travel.slip_percent", fmt::format("{}", slip_percent)});
    return settings;
}

/// The runs that are wanted, and what the report says of each.
struct SweepPlan {
    std::vector<WantedRun> runs;
    std::vector<SweepPoint> points;
};

/// Each value once, where it stands first: two runs cannot share a directory.
std::vector<double> drop_repeated(const std::vector<double>& values) {
    std::vector<double> once;
    for (const double value : values)
        if (std::ranges::find(once, value) == once.end()) once.push_back(value);
    return once;
}

SweepPlan plan_sweep(const SweepRequest& request) {
    const Case own = read_case(request.case_path, request.overrides);
    const std::vector<double> loads =
        request.loads.empty() ? std::vector{own.wheel.load_N} : parse_values(request.loads, "--load");
    const std::vector<double> slips =
        request.slips.empty() ? std::vector{own.travel.slip_percent} : parse_values(request.slips, "--slip");
    SweepPlan plan;
    for (const double load : drop_repeated(loads)) {
        for (const double slip : drop_repeated(slips)) {
            SweepPoint point;
            point.load_N = load;
            point.slip_percent = slip;
            point.name = fmt::format("load-{}-slip-{}", load, slip);
            plan.runs.push_back(
                want_run(request.case_path, settings_of(request, load, slip), request.directory + "/" + point.name));
            point.c = plan.runs.back().c;
            (void)trim(sweep_window(point.c), lug_pair_pitch_m(point.c));  // refuses what cannot be measured
            plan.points.push_back(std::move(point));
        }
    }
    return plan;
}

}  // namespace

std::vector<double> parse_values(const std::string& text, const std::string& option) {
    const auto fail = [&] {
        fail_input(fmt::format("{} {} is no list of numbers (5,20,60) nor a range (from:to:step, 0:70:10). Correct it?",
                               option, text));
    };
    const bool range = text.find(':') != std::string::npos;
    std::vector<double> values;
    for (const std::string& part : split(text, range ? ':' : ',')) {
        const auto value = parse_number(part);
        if (!value) fail();
        values.push_back(*value);
    }
    if (!range) return values;
    constexpr double most = 1000;
    if (values.size() != 3 || !(values[2] > 0) || !(values[1] >= values[0]) ||
        (values[1] - values[0]) / values[2] > most)
        fail();
    const double from = values[0], to = values[1], step = values[2];
    values.clear();
    for (int k = 0; from + k * step <= to + 1e-9 * step; ++k)
        values.push_back(parse_number(fmt::format("{:.12g}", from + k * step)).value_or(from));  // 0.3, not 0.30…04
    return values;
}

int run_sweep(const SweepRequest& request) {
    auto [runs, points] = plan_sweep(request);
    fs::create_directories(request.directory);
    const DirectoryLock lock(request.directory, Busy::refuse);
    const std::vector<int> status = make_runs(runs, {request.stage_cache, request.jobs});
    if (signal_of_children() != 0) return report_signal();
    int worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].status = status[k];
        worst = std::max(worst, status[k]);
    }
    write_sweep_report(
        request.directory, points,
        fmt::format("ifedem sweep {} -o {}{}{}{}", request.case_path, request.directory,
                    request.loads.empty() ? "" : " --load " + request.loads,
                    request.slips.empty() ? "" : " --slip=" + request.slips, show_settings(request.overrides)));
    fmt::print("report: {}/index.html\n", request.directory);
    return worst;
}

}  // namespace ifedem

#include "app/sweep.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "app/children.hpp"
#include "app/run_info.hpp"
#include "app/sweep_report.hpp"
#include "check/csv.hpp"
#include "core/error.hpp"
#include "record/checkpoint.hpp"
#include "record/directory_lock.hpp"
#include "step/stages.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

/// The case with one load and slip. Exactly what the children are told by --set, so that both resolve it alike.
std::vector<Override> settings_of(const SweepRequest& request, double load_N, double slip_percent) {
    std::vector<Override> settings = request.overrides;
    settings.push_back({"wheel.load_N", fmt::format("{}", load_N)});
    settings.push_back({"travel.slip_percent", fmt::format("{}", slip_percent)});
    return settings;
}

std::vector<SweepPoint> list_points(const SweepRequest& request) {
    const Case own = read_case(request.case_path, request.overrides);
    const std::vector<double> loads =
        request.loads.empty() ? std::vector{own.wheel.load_N} : parse_values(request.loads, "--load");
    const std::vector<double> slips =
        request.slips.empty() ? std::vector{own.travel.slip_percent} : parse_values(request.slips, "--slip");
    std::vector<SweepPoint> points;
    for (const double load : loads) {
        for (const double slip : slips) {
            SweepPoint point;
            point.load_N = load;
            point.slip_percent = slip;
            point.c = read_case(request.case_path, settings_of(request, load, slip));
            point.name = fmt::format("load-{}-slip-{}", load, slip);
            points.push_back(std::move(point));
        }
    }
    return points;
}

Arguments arguments_of(const char* command, const SweepRequest& request, const SweepPoint& point) {
    Arguments arguments = {command, request.case_path, "--quiet", "--stages", request.stage_cache};
    for (const Override& setting : settings_of(request, point.load_N, point.slip_percent)) {
        arguments.emplace_back("--set");
        arguments.push_back(setting.key + "=" + setting.value);
    }
    return arguments;
}

std::string directory_of(const SweepRequest& request, const SweepPoint& point) {
    return request.directory + "/" + point.name;
}

bool is_same_case(const std::string& directory, const Case& c) {
    try {
        return to_toml(read_case(directory + "/case.toml")) == to_toml(c);
    } catch (const Error&) {
        return false;
    }
}

std::string value_of(const std::string& directory, const std::string& name) {
    for (const RunValue& value : read_values(directory + "/run.csv"))
        if (value.name == name) return value.value;
    return "";
}

bool is_complete(const std::string& directory, const Case& c) {
    return value_of(directory, "results_version") == fmt::format("{}", results_version) && is_same_case(directory, c);
}

bool can_resume(const std::string& directory, const Case& c) {
    if (!fs::exists(directory + "/checkpoint.h5") || !is_same_case(directory, c)) return false;
    try {
        return read_checkpoint(directory + "/checkpoint.h5").results_version == results_version;
    } catch (const Error&) {
        return false;  // damaged: the run begins anew
    }
}

/// Beds and sunk wheels that several runs share are made first, each once.
std::vector<std::vector<Arguments>> list_preparations(const SweepRequest& request,
                                                      const std::vector<SweepPoint>& points) {
    std::vector<Arguments> beds, sinkages;
    std::set<std::string> seen;
    for (const SweepPoint& point : points) {
        if (is_complete(directory_of(request, point), point.c)) continue;
        const bool new_bed = seen.insert(stage_hash(point.c, Stage::consolidation, results_version)).second;
        const bool new_sinkage = seen.insert(stage_hash(point.c, Stage::sinkage, results_version)).second;
        if (new_bed) {
            beds.push_back(arguments_of("prepare", request, point));
        } else if (new_sinkage) {
            sinkages.push_back(arguments_of("prepare", request, point));
        }
    }
    return {beds, sinkages};
}

std::vector<int> run_points(const SweepRequest& request, const std::vector<SweepPoint>& points) {
    std::vector<Arguments> calls;
    std::vector<std::size_t> which;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::string directory = directory_of(request, points[k]);
        if (is_complete(directory, points[k].c)) continue;
        if (can_resume(directory, points[k].c)) {
            calls.push_back({"resume", directory, "--quiet", "--stages", request.stage_cache});
        } else {
            calls.push_back(arguments_of("run", request, points[k]));
            calls.back().insert(calls.back().end(), {"-o", directory, "--force"});
        }
        which.push_back(k);
    }
    fmt::print(stderr, "{} runs, {} of them complete already\n", points.size(), points.size() - calls.size());
    const std::vector<int> ended = run_children(calls, request.jobs);
    std::vector<int> status(points.size(), 0);
    for (std::size_t k = 0; k < which.size(); ++k) status[which[k]] = ended[k];
    return status;
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
    std::vector<SweepPoint> points = list_points(request);
    fs::create_directories(request.directory);
    const DirectoryLock lock(request.directory, Busy::refuse);
    for (const std::vector<Arguments>& calls : list_preparations(request, points)) {
        if (!calls.empty()) fmt::print(stderr, "preparing {} beds or sunk wheels\n", calls.size());
        (void)run_children(calls, request.jobs);  // one that fails fails again, and is told of, as a run
        if (signal_of_children() != 0) return 128 + signal_of_children();
    }
    const std::vector<int> status = run_points(request, points);
    if (signal_of_children() != 0) {
        fmt::print(stderr, "stopped by signal {}; the same command goes on\n", signal_of_children());
        return 128 + signal_of_children();
    }
    int worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].status = status[k];
        worst = std::max(worst, status[k]);
    }
    write_sweep_report(request.directory, points,
                       fmt::format("ifedem sweep {} -o {} --load {} --slip {}", request.case_path, request.directory,
                                   request.loads.empty() ? "(the case’s)" : request.loads,
                                   request.slips.empty() ? "(the case’s)" : request.slips));
    fmt::print("report: {}/index.html\n", request.directory);
    return worst;
}

}  // namespace ifedem

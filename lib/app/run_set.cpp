#include "app/run_set.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "app/children.hpp"
#include "check/run.hpp"
#include "core/error.hpp"
#include "record/checkpoint.hpp"
#include "step/stages.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

Arguments arguments_of(const char* command, const WantedRun& run, const RunSetOptions& options) {
    Arguments arguments = {command, run.case_path, "--quiet", "--stages", options.stage_cache};
    for (const Override& setting : run.settings) {
        arguments.emplace_back("--set");
        arguments.push_back(setting.key + "=" + setting.value);
    }
    return arguments;
}

bool is_same_case(const std::string& directory, Case c) {
    try {
        const Case there = read_case(directory + "/case.toml");
        c.name = there.name;
        return list_changes(there, c).empty();
    } catch (const Error&) {
        return false;
    }
}

bool can_resume(const WantedRun& run) {
    if (!fs::exists(run.directory + "/checkpoint.h5") || !is_same_case(run.directory, run.c)) return false;
    try {
        return read_checkpoint(run.directory + "/checkpoint.h5").results_version == results_version;
    } catch (const Error&) {
        return false;  // damaged: the run begins anew
    }
}

/// Beds and sunk wheels that several runs share are made first, each once.
std::vector<std::vector<Arguments>> list_preparations(const std::vector<WantedRun>& runs,
                                                      const RunSetOptions& options) {
    std::vector<Arguments> beds, sinkages;
    std::set<std::string> seen;
    for (const WantedRun& run : runs) {
        if (holds_finished_run(run.directory, run.c)) continue;
        const bool new_bed = seen.insert(stage_hash(run.c, Stage::consolidation, results_version)).second;
        const bool new_sinkage = seen.insert(stage_hash(run.c, Stage::sinkage, results_version)).second;
        if (new_bed) {
            beds.push_back(arguments_of("prepare", run, options));
        } else if (new_sinkage) {
            sinkages.push_back(arguments_of("prepare", run, options));
        }
    }
    return {beds, sinkages};
}

std::vector<int> make_travels(const std::vector<WantedRun>& runs, const RunSetOptions& options) {
    std::vector<Arguments> calls;
    std::vector<std::size_t> which;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (holds_finished_run(runs[k].directory, runs[k].c)) continue;
        if (can_resume(runs[k])) {
            calls.push_back({"resume", runs[k].directory, "--quiet", "--stages", options.stage_cache});
        } else {
            calls.push_back(arguments_of("run", runs[k], options));
            calls.back().insert(calls.back().end(), {"-o", runs[k].directory, "--force"});
        }
        which.push_back(k);
    }
    fmt::print(stderr, "{} runs, {} of them complete already\n", runs.size(), runs.size() - calls.size());
    const std::vector<int> ended = run_children(calls, options.jobs);
    std::vector<int> status(runs.size(), 0);
    for (std::size_t k = 0; k < which.size(); ++k) status[which[k]] = ended[k];
    return status;
}

}  // namespace

bool holds_finished_run(const std::string& directory, const Case& c) {
    const std::string path = directory + "/run.csv";
    if (!fs::exists(path) || !is_same_case(directory, c)) return false;
    try {
        return find_value(read_values(path), "results_version") == fmt::format("{}", results_version);
    } catch (const Error&) {
        return false;
    }
}

std::string show_settings(const std::vector<Override>& settings) {
    std::string text;
    for (const Override& setting : settings) {
        const std::string argument = setting.key + "=" + setting.value;
        const bool plain =
            argument.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.=+-,") ==
            std::string::npos;
        text += plain ? " --set " + argument : " --set '" + argument + "'";
    }
    return text;
}

WantedRun want_run(const std::string& case_path, std::vector<Override> settings, std::string directory) {
    Case c = read_case(case_path, settings);
    return {case_path, std::move(settings), std::move(directory), std::move(c)};
}

std::vector<int> make_runs(const std::vector<WantedRun>& runs, const RunSetOptions& options) {
    for (const std::vector<Arguments>& calls : list_preparations(runs, options)) {
        if (!calls.empty()) fmt::print(stderr, "preparing {} beds or sunk wheels\n", calls.size());
        (void)run_children(calls, options.jobs);  // one that fails fails again, and is told of, as a run
        // NOLINTNEXTLINE(modernize-return-braced-init-list): braces would be two elements
        if (signal_of_children() != 0) return std::vector<int>(runs.size(), -1);
    }
    return make_travels(runs, options);
}

}  // namespace ifedem

#include "app/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/children.hpp"
#include "app/variants.hpp"
#include "check/csv.hpp"
#include "check/differences.hpp"
#include "check/least_share.hpp"
#include "core/error.hpp"
#include "model/case_changes.hpp"
#include "record/directory_lock.hpp"
#include "record/files.hpp"
#include "step/limits.hpp"
#include "step/stages.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

/// A coarser mesh saves no disc-steps, but a part of each step.
enum class Saves { disc_steps, elements };

/// Something there may be less of.
struct Reduction {
    std::string_view name;
    Saves saves;
    Case (*apply)(const Case& c, double share);
    bool (*is_possible)(const Case& c);
};

bool always(const Case&) { return true; }
Case with_fewer_steps(const Case& c, double share) { return with_time_step(c, 1 / share); }

constexpr Reduction all_reductions[] = {{"step", Saves::disc_steps, with_fewer_steps, always},
                                        {"depth", Saves::disc_steps, with_depth, has_discs_only},
                                        {"behind", Saves::disc_steps, with_soil_behind, has_discs_only},
                                        {"ahead", Saves::disc_steps, with_soil_ahead, has_discs_only},
                                        {"region", Saves::disc_steps, with_region, has_region},
                                        {"mesh", Saves::elements, with_mesh, can_refine_mesh}};

std::vector<Reduction> parse_reductions(const std::string& text, const Case& c) {
    std::vector<Reduction> reductions;
    for (const std::string& name : split(text, ',')) {
        const Reduction& found = find_named(all_reductions, name, text, "less");
        if (found.is_possible(c)) {
            reductions.push_back(found);
        } else {
            fmt::print(stderr,
                       "{}: left as it is (soil elements fix the bed and alone leave a region of discs, a file or a "
                       "plate fixes the mesh)\n",
                       name);
        }
    }
    return reductions;
}

DifferenceEvidence parse_evidence(const std::string& text) {
    if (text == "shown") return DifferenceEvidence::shown;
    if (text != "mean")
        fail_input(fmt::format("--evidence {} is no rule (there are shown and mean). Choose one of them?", text));
    return DifferenceEvidence::mean;
}

/// What is left of the case, and of what there is less: "step-0.5_depth-0.25".
struct Kept {
    Case c;
    std::string names;
};

struct Decision {
    Trial trial = Trial::refused;
    std::string text;
};

/// The search in progress.
struct Fit {
    const FitRequest& request;
    VariantRequest runs;
    std::vector<ComparedMetric> quantities;
    double tolerance = 0;
    DifferenceEvidence evidence = DifferenceEvidence::shown;
    Case original;
    Kept kept;
    std::vector<RunMetrics> original_metrics;
    std::string log;
    std::vector<Case> refused;

    [[nodiscard]] double cost_of(const Case& c) const { return count_disc_steps(c) / count_disc_steps(original); }
};

std::string header_of(const std::vector<ComparedMetric>& quantities) {
    std::string text = "trial,changes,n,disc_steps,relative_cost,decision";
    for (const ComparedMetric& q : quantities)
        text += fmt::format(",{0},{0}_difference,{0}_half_width,{0}_tolerance", q.name);
    return text + "\n";
}

/// A line of the log; `metrics` may be empty.
void log_trial(Fit& fit, const Variant& trial, const std::vector<RunMetrics>& metrics, const std::string& decision) {
    std::vector<std::string> cells = {trial.name,
                                      describe_settings(fit.original, trial.c),
                                      std::to_string(metrics.size()),
                                      format_number(count_disc_steps(trial.c)),
                                      format_number(fit.cost_of(trial.c)),
                                      decision};
    for (const ComparedMetric& q : fit.quantities) {
        if (metrics.empty()) {
            cells.insert(cells.end(), 4, "");
            continue;
        }
        const Difference d = fit.original_metrics.empty()  // the original itself: what other packings alone do
                                 ? expect_no_difference(metrics, q, fit.tolerance)
                                 : find_difference(fit.original_metrics, metrics, q, fit.tolerance);
        for (const double value : {d.after, d.paired.mean, d.paired.half_width, d.tolerance})
            cells.push_back(format_number(value));
    }
    fit.log += csv_line(cells);
    fmt::print("{:<24} cost {:.3f}  {}\n", trial.name, fit.cost_of(trial.c), decision);
    std::fflush(stdout);  // trials take long, and a log is no terminal
}

std::string without_extension(const std::string& output) { return output.substr(0, output.size() - 5); }

/// How the comment begins by which a file is known to be a fit's.
constexpr const char *least_model = "# The least model: ", *nothing_less = "# Nothing can be less: ";

void write_files(const Fit& fit) {
    const std::string& output = fit.request.output;
    fs::path base = fs::absolute(fit.request.case_path);
    if (const fs::path folder = fs::absolute(output).parent_path(); fs::path(fit.request.case_path).is_relative())
        base = base.lexically_proximate(folder);
    const FitRequest& r = fit.request;
    std::string text = fmt::format("{}{} within {} ({}) in {} realisations; trials: {}.csv\n",
                                   fit.kept.names.empty() ? nothing_less : least_model, r.quantities, r.tolerance,
                                   r.evidence, r.realisations, fs::path(without_extension(output)).filename().string());
    text += fmt::format("base = \"{}\"\n", base.lexically_normal().string());
    for (const Override& change : list_changes(read_case(fit.request.case_path), fit.kept.c))
        text += fmt::format("{} = {}\n", change.key, change.value);
    write_file_atomically(without_extension(output) + ".csv", fit.log);
    write_file_atomically(output, text);
}

/// What is wrong with a case before it is run; "" if nothing.
std::string find_obstacle(const Fit& fit, const Variant& trial) {
    try {
        (void)plan_variants(fit.runs, {trial});
    } catch (const Error& error) {
        return error.what();
    }
    const auto excess = find_certain_excess(trial.c);
    return excess ? explain_excess(*excess, trial.c.time_step_s) : "";
}

Decision decide(const Fit& fit, const std::vector<RunMetrics>& metrics) {
    std::string too_far, not_shown;
    for (const ComparedMetric& q : fit.quantities) {
        const Difference d = find_difference(fit.original_metrics, metrics, q, fit.tolerance);
        if (is_small(d, DifferenceEvidence::shown)) continue;
        (is_small(d, DifferenceEvidence::mean) ? not_shown : too_far) += " " + q.name;
    }
    if (!too_far.empty()) return {Trial::refused, "refused: mean beyond the tolerance:" + too_far};
    if (not_shown.empty()) return {Trial::kept, "kept"};
    if (fit.evidence == DifferenceEvidence::mean) return {Trial::kept, "kept by the mean, not shown:" + not_shown};
    return {Trial::refused, "refused: not shown to be within it:" + not_shown};
}

bool is_pointless(const Fit& fit, const Reduction& reduction, const Case& c) {
    constexpr double least_saving = 0.01;
    const auto is_this = [&c](const Case& known) { return list_changes(known, c).empty(); };
    if (is_this(fit.kept.c) || std::ranges::any_of(fit.refused, is_this)) return true;  // two shares, one whole number
    return reduction.saves == Saves::disc_steps && fit.cost_of(fit.kept.c) - fit.cost_of(c) < least_saving;
}

/// A health check, a step limit or a rule of cases says something about the trial; a full disk or a killed run does
/// not.
void refuse_accident(const Variant& trial, const MeasuredVariant& measured) {
    for (const ExitCode told : {ExitCode::done, ExitCode::bad_input, ExitCode::health})
        if (measured.status == static_cast<int>(told)) return;
    throw Error(static_cast<ExitCode>(measured.status),
                fmt::format("{}: {} (which says nothing about the trial). Mend the cause and give the command again?",
                            trial.name, measured.note));
}

/// Tries less of one thing on top of `before`, what was kept of the things before it.
Trial try_reduction(Fit& fit, const Reduction& reduction, const Kept& before, double share) {
    const std::string name = fmt::format("{}-{}", reduction.name, share);
    const Variant trial{before.names.empty() ? name : before.names + "_" + name, reduction.apply(before.c, share)};
    if (is_pointless(fit, reduction, trial.c)) return Trial::pointless;
    MeasuredVariant measured;
    measured.note = find_obstacle(fit, trial);
    if (measured.note.empty()) measured = measure_variants(fit.runs, {trial}).front();
    if (signal_of_children() != 0) return Trial::pointless;
    refuse_accident(trial, measured);
    const Decision decision = measured.metrics.empty() ? Decision{Trial::refused, "refused: " + measured.note}
                                                       : decide(fit, measured.metrics);
    if (decision.trial == Trial::kept)
        fit.kept = {trial.c, trial.name};
    else
        fit.refused.push_back(trial.c);
    log_trial(fit, trial, measured.metrics, decision.text);
    write_files(fit);
    return decision.trial;
}

/// Where packings alone scatter more than the tolerance, nothing can be shown; said before the work begins.
void warn_of_scatter(const Fit& fit) {
    for (const ComparedMetric& q : fit.quantities) {
        const Difference d = expect_no_difference(fit.original_metrics, q, fit.tolerance);
        if (is_small(d, DifferenceEvidence::shown)) continue;
        fmt::print(stderr,
                   "{}: two beds of one case differ by 0 ± {:.3g} {} in the mean of {} realisations, more than the "
                   "tolerance of {:.3g}: little can be shown there. Give about --n {:.0f}, a larger --tolerance, or "
                   "--evidence mean?\n",
                   q.name, d.paired.half_width, q.metric->unit, d.paired.n, d.tolerance, realisations_needed(d));
    }
}

void measure_original(Fit& fit) {
    const Variant original{"original", fit.original};
    const MeasuredVariant measured = measure_variants(fit.runs, {original}).front();
    if (signal_of_children() != 0) return;
    if (measured.status != 0)
        throw Error(static_cast<ExitCode>(measured.status),
                    fmt::format("the case itself does not run ({}; nothing can be compared with it). Run it alone?",
                                measured.note));
    log_trial(fit, original, measured.metrics, "the original");
    fit.original_metrics = measured.metrics;
    write_files(fit);
    warn_of_scatter(fit);
}

bool is_of_fit(const std::string& text) { return text.starts_with(least_model) || text.starts_with(nothing_less); }

void refuse_output(const FitRequest& request) {
    if (!request.output.ends_with(".toml") || fs::path(request.output).stem().empty())
        fail_input(
            fmt::format("-o {} is no name of a case (it must end in .toml). Write -o smaller.toml?", request.output));
    std::error_code ignored;
    if (fs::equivalent(request.output, request.case_path, ignored))
        fail_input(
            fmt::format("-o {} is the case itself (it would be overwritten). Choose another -o?", request.output));
    if (fs::exists(request.output) && !is_of_fit(read_text(request.output)))
        fail_input(fmt::format("-o {} exists already and is not a fit's (it would be overwritten). Choose another -o?",
                               request.output));
}

}  // namespace

int run_fit(const FitRequest& request) {
    refuse_output(request);
    const Case original = read_case(request.case_path, request.overrides);
    const std::vector<ComparedMetric> quantities = parse_quantities(request.quantities);
    Fit fit{request,
            {request.case_path, without_extension(request.output) + "-runs", original, request.realisations,
             request.options},
            quantities,
            parse_tolerance(request.tolerance),
            parse_evidence(request.evidence),
            original,
            {original, ""},
            {},
            header_of(quantities),
            {}};
    const std::vector<Reduction> reductions = parse_reductions(request.reductions, original);
    (void)plan_variants(fit.runs, {{"original", original}});  // says what is wrong before anything is written
    fs::create_directories(fit.runs.directory);
    const DirectoryLock lock(fit.runs.directory, Busy::refuse);
    measure_original(fit);
    for (const Reduction& reduction : reductions) {
        if (signal_of_children() != 0) break;
        const Kept before = fit.kept;
        (void)find_least_share([&](double share) { return try_reduction(fit, reduction, before, share); });
    }
    if (signal_of_children() != 0) return report_signal();
    fmt::print("kept: {}; cost {:.3f} of the original's disc-steps; case: {}, log: {}.csv\n",
               fit.kept.names.empty() ? "nothing" : fit.kept.names, fit.cost_of(fit.kept.c), request.output,
               without_extension(request.output));
    return 0;
}

}  // namespace ifedem

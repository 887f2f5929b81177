#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>

#include "app/calibrate.hpp"
#include "app/confined.hpp"
#include "app/doubt.hpp"
#include "app/find_run.hpp"
#include "app/fit.hpp"
#include "app/metrics_table.hpp"
#include "app/picture.hpp"
#include "app/points_sources.hpp"
#include "app/run_case.hpp"
#include "app/run_info.hpp"
#include "app/share.hpp"
#include "app/soil.hpp"
#include "app/stiffness.hpp"
#include "app/stress.hpp"
#include "app/surface.hpp"
#include "app/sweep.hpp"
#include "app/watch.hpp"
#include "check/check.hpp"
#include "check/effects.hpp"
#include "check/front_page.hpp"
#include "check/points.hpp"
#include "check/points_guide.hpp"
#include "check/report.hpp"
#include "core/error.hpp"
#include "record/checkpoint.hpp"
#include "record/compare.hpp"

namespace {

using namespace ifedem;

/// "key=value" of --set.
Override to_override(const std::string& text) {
    const auto at = text.find('=');
    if (at == std::string::npos)
        fail_input(fmt::format("--set {}: there is no '='. Write --set table.key=value?", text));
    return {text.substr(0, at), text.substr(at + 1)};
}

void add_sets(CLI::App& command, std::vector<Override>& overrides) {
    const auto keep = [&overrides](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) overrides.push_back(to_override(text));
    };
    command.add_option_function<std::vector<std::string>>("--set", keep, "override a key: table.key=value")->take_all();
}

constexpr const char* cache_help = "cache of finished stages (build/stages where the program is started)";

void allow_unstable(CLI::App& command, RunRequest& request) {
    command.add_flag_callback(
        "--allow-unstable", [&] { request.unstable_step = UnstableStep::allow; },
        "go on with a time step beyond a limit");
}

void add_run(CLI::App& app, RunRequest& request, int& code) {
    auto* run = app.add_subcommand("run", "simulate a case");
    run->add_option("case", request.case_path, "case file (TOML)")->required();
    run->add_option("-o,--output", request.directory, "run directory")->required();
    add_sets(*run, request.overrides);
    run->add_option("--threads", request.threads, "threads for one case")->check(CLI::Range(1, 256));
    run->add_option("--stages", request.stage_cache, cache_help);
    run->add_flag_callback(
        "--force", [&] { request.existing = Existing::replace; }, "replace an existing directory");
    run->add_flag_callback(
        "--quiet", [&] { request.show = Show::nothing; }, "no progress");
    allow_unstable(*run, request);
    run->add_option("--stop-at-step", request.stop_at_step,
                    "leave a checkpoint after this many steps of all stages together")
        ->check(CLI::Range(1.0, 1e15));
    run->add_flag("--profile", request.profile, "print the CPU time of each phase of the step (of the first thread)");
    run->callback([&] {
        if (request.directory.empty()) fail_input("-o is empty (there is nowhere to write to). Name a directory?");
        code = run_case(request);
    });
}

void add_stage(CLI::App& app, RunRequest& request, int& code) {
    auto* stage = app.add_subcommand("prepare", "simulate consolidation and free sinkage into the stage cache");
    stage->add_option("case", request.case_path, "case file (TOML)")->required();
    add_sets(*stage, request.overrides);
    stage->add_option("--threads", request.threads, "threads")->check(CLI::Range(1, 256));
    stage->add_option("--stages", request.stage_cache, cache_help);
    stage->add_flag_callback(
        "--quiet", [&] { request.show = Show::nothing; }, "no progress");
    request.last_stage = Stage::sinkage;
    stage->add_flag_callback(
        "--bed", [&] { request.last_stage = Stage::consolidation; }, "consolidation only: wheels and loads share it");
    allow_unstable(*stage, request);
    stage->callback([&] { code = run_case(request); });
}

void add_resume(CLI::App& app, RunRequest& request, int& code) {
    auto* resume = app.add_subcommand("resume", "go on with a run that was stopped");
    resume->add_option("directory", request.directory, "run directory")->required();
    resume->add_option("--threads", request.threads, "threads")->check(CLI::Range(1, 256));
    resume->add_option("--stages", request.stage_cache, cache_help);
    resume
        ->add_option("--stop-at-step", request.stop_at_step,
                     "leave a checkpoint after this many steps of all stages together")
        ->check(CLI::Range(1.0, 1e15));
    allow_unstable(*resume, request);
    resume->add_flag_callback(
        "--quiet", [&] { request.show = Show::nothing; }, "no progress");
    resume->callback([&] { code = resume_case(request); });
}

void add_sweep(CLI::App& app, SweepRequest& request, int& code) {
    auto* sweep = app.add_subcommand("sweep", "run a case for loads and slips: curves, pictures, CSV and a report");
    sweep->add_option("case", request.case_path, "case file (TOML)")->required();
    sweep->add_option("-o,--output", request.directory, "directory of the runs and the report")->required();
    sweep->add_option("--slip", request.slips, "slips in %: 0:70:10 or 0,20,60");
    sweep->add_option("--load", request.loads, "loads in N: 50,100");
    sweep->add_option("--jobs", request.jobs, "runs at the same time")->check(CLI::Range(1, 1024));
    add_sets(*sweep, request.overrides);
    sweep->add_option("--stages", request.stage_cache, cache_help);
    sweep->callback([&] { code = run_sweep(request); });
}

/// What doubt and fit have in common.
template <class Request>
void add_comparison(CLI::App& command, Request& request) {
    command.add_option("case", request.case_path, "case file (TOML)")->required();
    command.add_option("--quantities", request.quantities, "H,Pd,R,z or names of `ifedem metrics`");
    command.add_option("--tolerance", request.tolerance, "share of a quantity that does not matter: 5%");
    command.add_option("--n", request.realisations, "realisations (packing and lug phase) of each variant");
    command.add_option("--jobs", request.options.jobs, "runs at the same time")->check(CLI::Range(1, 1024));
    add_sets(command, request.overrides);
    command.add_option("--stages", request.options.stage_cache, cache_help);
}

void add_doubt(CLI::App& app, DoubtRequest& request, int& code) {
    auto* doubt =
        app.add_subcommand("doubt", "what moves with twice the depth, length and resolution, or half the step");
    add_comparison(*doubt, request);
    doubt->add_option("-o,--output", request.directory, "directory of the runs and doubt.csv")->required();
    doubt->add_option("--only", request.increases, "what may be more: depth,length,discs,region,mesh,step");
    doubt->callback([&] { code = run_doubt(request); });
}

void add_fit(CLI::App& app, FitRequest& request, int& code) {
    auto* fit = app.add_subcommand("fit", "the least model with the same quantities within a tolerance");
    add_comparison(*fit, request);
    fit->add_option("-o,--output", request.output, "the smaller case (.toml); its log and runs go beside it")
        ->required();
    fit->add_option("--evidence", request.evidence, "shown: |difference| + half-width within it; mean: |difference|");
    fit->add_option("--only", request.reductions, "what may be less, in order: step,depth,behind,ahead,region,mesh");
    fit->callback([&] { code = run_fit(request); });
}

void add_calibrate(CLI::App& app, CalibrateRequest& request) {
    auto* command = app.add_subcommand(
        "calibrate",
        "test a case's sand as a laboratory does: porosity, angle of repose, confined and biaxial compression, direct "
        "shear, plate sinkage; compare with [target]");
    command->add_option("case", request.case_path, "case file (TOML); its gravity, step, [soil] and [contact] count")
        ->required();
    command->add_option("-o,--output", request.directory, "directory of measurements.csv and the report")->required();
    command->add_option("--n", request.realisations, "realisations (packings)")->check(CLI::Range(1, 1000));
    command->add_option("--jobs", request.jobs, "tests at the same time")->check(CLI::Range(1, 1024));
    command
        ->add_option("--stress", request.stress_kPa,
                     "kPa: lateral in biaxial compression; direct shear under half, all and twice of it")
        ->check(CLI::Range(1e-6, 1e6));
    add_sets(*command, request.overrides);
    command->add_flag_callback(
        "--quick", [&] { request.effort = Effort::quick; }, "small samples: a look, not a measurement");
    command->add_flag_callback(
        "--knobs", [&] { request.knobs = Knobs::turn; },
        "also measure what alpha, mu, stiffness and the friction of consolidation do to each quantity (six times the "
        "work)");
    command->callback([&] { calibrate(request); });
}

struct CheckArguments {
    std::string claims, output;
    std::vector<std::string> runs;
    ReportRequest report;
};

void add_check_and_report(CLI::App& app, CheckArguments& a, int& code) {
    auto* check = app.add_subcommand("check", "judge runs by the claims of a chapter");
    check->add_option("claims", a.claims, "claims.csv")->required();
    check->add_option("runs", a.runs, "run directories")->required();
    check->add_option("-o,--output", a.output, "checks.csv")->required();
    check->callback([&] { code = run_check(a.claims, a.runs, a.output); });
    auto* metrics = app.add_subcommand("metrics", "window means of runs, a line each");
    metrics->add_option("runs", a.runs, "run directories")->required();
    metrics->add_option("-o,--output", a.output, "metrics.csv")->required();
    metrics->callback([&] { write_metrics(a.runs, a.output); });
    auto* report = app.add_subcommand("report", "write a chapter's report");
    report->add_option("claims", a.report.claims_path, "claims.csv")->required();
    report->add_option("runs", a.report.run_dirs, "run directories")->required();
    report->add_option("-o,--output", a.report.out_dir, "directory of the report")->required();
    report->add_option("--title", a.report.title, "title");
    report->add_option("--command", a.report.command, "the command that made the report");
    report->callback([&] { write_report(a.report); });
}

struct EffectsArguments {
    std::vector<std::string> defaults, variants;
    std::string output;
};

void add_effects(CLI::App& app, EffectsArguments& a) {
    auto* effects =
        app.add_subcommand("effects", "compare variants of a case with its default, realisation by realisation");
    effects->add_option("--defaults", a.defaults, "run directories of the default")->required();
    effects->add_option("--variants", a.variants, "run directories, each named WHAT-…")->required();
    effects->add_option("-o,--output", a.output, "directory for effects.csv and measurements.csv")->required();
    effects->callback([&] { write_effects(a.defaults, a.variants, a.output); });
}

struct PointsArguments {
    PointsRequest request;
    std::string soil;
    std::vector<std::string> plates;
    GuideRequest guide;
};

void add_points(CLI::App& app, PointsArguments& a) {
    PointsRequest& request = a.request;
    auto* points = app.add_subcommand("points", "chart cost against error of variants: points.csv, figures and a page");
    points->add_option("references", request.references_path, "references.csv: ledger rows to compare with")
        ->required();
    points->add_option("runs", request.run_dirs, "run directories, each named WHAT-…")->required();
    points->add_option("--finest", request.finest, "the variant that errors are measured against")->required();
    points->add_option("--plain", request.plain, "the variant that the others differ from");
    points->add_option("-o,--output", request.out_dir, "directory of points.csv and the page")->required();
    points->add_option("--title", request.title, "title");
    points->add_option("--command", request.command, "the command that made the page");
    points->add_option("--soil", a.soil, "directory of `ifedem soil`: the semi-empirical wheel too");
    points->add_option("--plates", a.plates, "the plate tests that it was made of: what they cost");
    points->callback([&] {
        a.request.measure_more = measure_stress_peaks;
        if (!a.soil.empty()) a.request.models.push_back(semi_empirical_wheel(a.soil, a.plates));
        write_points(a.request);
    });
    auto* guide = app.add_subcommand("points-guide", "one page over several charts: what each second buys");
    guide->add_option("points", a.guide.point_dirs, "directories of `ifedem points`")->required();
    guide->add_option("-o,--output", a.guide.out_dir, "directory of the page and of all points")->required();
    guide->add_option("--plain", a.guide.plain, "the variant that the others differ from");
    guide->add_option("--command", a.guide.command, "the command that made the page");
    guide->callback([&] {
        a.guide.templates = share_directory() + "/templates";
        write_points_guide(a.guide);
    });
}

void add_find(CLI::App& app, FindRequest& request) {
    auto* find = app.add_subcommand(
        "find", "disc-steps of a case (before travel, travel) and which directory holds a finished run of it, or -");
    find->add_option("case", request.case_path, "case file (TOML)")->required();
    add_sets(*find, request.overrides);
    find->add_option("--among", request.directories, "directories of runs");
    find->callback([&] { fmt::print("{}\n", find_run(request)); });
}

struct PictureArguments {
    std::string run, output;
    long frame = -1;
    bool sheet = false, animation = false, pressure = false;
};

void add_picture(CLI::App& app, PictureArguments& a) {
    auto* picture = app.add_subcommand("picture", "draw recorded frames");
    picture->add_option("run", a.run, "run directory")->required();
    picture->add_option("-o,--output", a.output, "directory for the pictures")->required();
    picture->add_option("--frame", a.frame, "number of the frame, from 0; -1 for the last")
        ->check(CLI::Range(-1L, std::numeric_limits<long>::max()));
    picture->add_flag("--sheet", a.sheet, "a contact sheet of nine frames instead");
    picture->add_flag("--animation", a.animation, "a GIF of up to thirty frames instead");
    picture->add_flag("--pressure", a.pressure, "sheet and animation: discs coloured by pressure, not by speed");
    picture->callback([&] {
        const DiscColour colour = a.pressure ? DiscColour::pressure : DiscColour::speed;
        std::filesystem::create_directories(a.output);
        if (a.sheet) draw_contact_sheet(a.run, a.output, colour);
        if (a.animation) draw_animation(a.run, a.output, colour);
        if (!a.sheet && !a.animation) draw_pictures(a.run, a.output, a.frame);
    });
}

/// Exit code 1: they differ.
int compare_checkpoints(const std::string& a, const std::string& b) {
    const Checkpoint first = read_checkpoint(a), second = read_checkpoint(b);
    const auto difference = find_difference(first.state, second.state);
    fmt::print("step {}: {}\n", first.state.progress.total_steps, difference.value_or("equal"));
    return difference ? 1 : 0;
}

struct CompareArguments {
    std::string first, second;
};

void add_compare(CLI::App& app, CompareArguments& a, int& code) {
    auto* compare = app.add_subcommand("compare", "the first difference between two checkpoints");
    compare->add_option("first", a.first, "checkpoint.h5")->required();
    compare->add_option("second", a.second, "checkpoint.h5")->required();
    compare->callback([&] { code = compare_checkpoints(a.first, a.second); });
}

void add_stiffness(CLI::App& app, StiffnessRequest& request) {
    auto* press = app.add_subcommand("stiffness", "radial stiffness of wheels on a rigid plane");
    press->add_option("cases", request.case_paths, "case files")->required();
    press->add_option("-o,--output", request.directory, "directory for stiffness.csv")->required();
    press->add_option("--load", request.load_N, "load of the secant, N (each case's own)");
    press->callback([&] { write_stiffness(request); });
}

void add_stress(CLI::App& app, StressRequest& request) {
    auto* contact = app.add_subcommand("stress", "contact stress of travels: measurements.csv and data of figures");
    contact->add_option("runs", request.run_directories, "run directories")->required();
    contact->add_option("-o,--output", request.directory, "directory for what comes out")->required();
    contact->add_option("--soil", request.soil_directory, "directory of `ifedem soil`: the semi-empirical wheel too");
    contact->callback([&] { write_stress(request); });
}

void add_soil(CLI::App& app, SoilRequest& request) {
    auto* plates = app.add_subcommand("soil", "soil parameters of the semi-empirical wheel from plate tests");
    plates->add_option("runs", request.run_directories, "runs of plates under several loads")->required();
    plates->add_option("-o,--output", request.directory, "directory for what comes out")->required();
    plates->callback([&] { write_soil(request); });
}

void add_confined(CLI::App& app, ConfinedRequest& request) {
    auto* confine = app.add_subcommand("confined", "confined compression of a block of discs and of an element");
    confine->add_option("case", request.case_path, "case file with soil elements")->required();
    confine->add_option("-o,--output", request.directory, "directory for confined.csv and measurements.csv")
        ->required();
    confine->callback([&] { write_confined(request); });
}

void add_surface(CLI::App& app, SurfaceRequest& request) {
    auto* profile = app.add_subcommand("surface", "the soil's surface at the end of a run");
    profile->add_option("run", request.run, "run directory")->required();
    profile->add_option("-o,--output", request.output, "CSV file")->required();
    profile->callback([&] { write_surface(request); });
}

struct LedgerArguments {
    std::string conclusions, page;
    std::vector<std::string> reports;
};

void add_ledger(CLI::App& app, LedgerArguments& a) {
    auto* ledger = app.add_subcommand("ledger", "every statement of the text on one page, from reports of chapters");
    ledger->add_option("conclusions", a.conclusions, "conclusions.csv: what the text concludes and from what")
        ->required();
    ledger->add_option("reports", a.reports, "directories chapterN with checks.csv")->required();
    ledger->add_option("-o,--output", a.page, "directory of index.html and README.md")->required();
    ledger->callback([&] { write_front_page(a.conclusions, a.reports, a.page); });
}

void add_watch(CLI::App& app, WatchRequest& request) {
    auto* follow = app.add_subcommand("watch", "overall progress of a set of runs");
    follow->add_option("runs", request.directories, "run directories")->required();
    follow->callback([&] { watch_runs(request); });
}

/// What the command line fills, by subcommand.
struct Requests {
    RunRequest run, stage, resume;
    SweepRequest sweep;
    DoubtRequest doubt;
    FitRequest fit;
    CalibrateRequest calibrate;
    CheckArguments check;
    PictureArguments picture;
    EffectsArguments effects;
    PointsArguments points;
    FindRequest find;
    CompareArguments compare;
    StiffnessRequest stiffness;
    StressRequest stress;
    SoilRequest soil;
    ConfinedRequest confined;
    SurfaceRequest surface;
    LedgerArguments ledger;
    WatchRequest watch;
};

void add_all(CLI::App& app, Requests& r, int& code) {
    add_run(app, r.run, code);
    add_stage(app, r.stage, code);
    add_resume(app, r.resume, code);
    add_sweep(app, r.sweep, code);
    add_doubt(app, r.doubt, code);
    add_fit(app, r.fit, code);
    add_calibrate(app, r.calibrate);
    add_check_and_report(app, r.check, code);
    add_picture(app, r.picture);
    add_effects(app, r.effects);
    add_points(app, r.points);
    add_find(app, r.find);
    app.add_subcommand("describe", "the manual of keys")->callback([] { fmt::print("{}", describe_keys()); });
    add_compare(app, r.compare, code);
    add_stiffness(app, r.stiffness);
    add_stress(app, r.stress);
    add_soil(app, r.soil);
    add_confined(app, r.confined);
    add_surface(app, r.surface);
    add_ledger(app, r.ledger);
    add_watch(app, r.watch);
}

int run_program(int argc, char** argv) {
    CLI::App app{"ifedem: finite-element wheels on discrete-element soil, in two dimensions"};
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("ifedem {} (results version {}, {})", program_version(),
                                                  results_version, compiler_name()));
    int code = 0;
    Requests requests;
    add_all(app, requests, code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        const int status = app.exit(e);
        return status == 0 ? 0 : static_cast<int>(ExitCode::bad_input);
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    // For gnuplot: figures are UTF-8 whatever language the user has, and without one it warns of each degree sign.
    ::setenv("LC_ALL", "C.UTF-8", 1);
    try {
        return run_program(argc, argv);
    } catch (const Error& e) {
        fmt::print(stderr, "{}\n", e.what());
        return static_cast<int>(e.code());
    } catch (const std::filesystem::filesystem_error& e) {
        fmt::print(stderr, "{}. Check the path, permissions and free space.\n", e.what());
        return static_cast<int>(ExitCode::io);
    } catch (const std::exception& e) {
        fmt::print(stderr, "unexpected: {}. Please report this with the command that you ran.\n", e.what());
        return static_cast<int>(ExitCode::io);
    }
}

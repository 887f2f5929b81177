#include "app/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/picture.hpp"
#include "app/progress_line.hpp"
#include "app/run_info.hpp"
#include "app/stress_files.hpp"
#include "core/clock.hpp"
#include "core/hash.hpp"
#include "dem/bed.hpp"
#include "dem/threads.hpp"
#include "record/checkpoint.hpp"
#include "record/directory_lock.hpp"
#include "record/files.hpp"
#include "record/results.hpp"
#include "record/soil_files.hpp"
#include "step/energy.hpp"
#include "step/fields.hpp"
#include "step/health.hpp"
#include "step/stages.hpp"
#include "step/step.hpp"
#include "traction/control.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

volatile std::sig_atomic_t signal_seen = 0;
extern "C" void note_signal(int number) { signal_seen = number; }

/// A wish in seconds as a whole number of steps, at least one; 0 stays 0 (never).
std::uint64_t steps_in(double seconds, double step_s) {
    if (seconds <= 0) return 0;
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(seconds / step_s)));
}

bool is_due(std::uint64_t step, std::uint64_t interval) { return interval > 0 && step % interval == 0; }

double time_s(const Scene& scene, const State& state) {
    return static_cast<double>(state.progress.step) * scene.dem.step_s;
}

SeriesRow take_series_row(const Scene& scene, State& state, const Workspace& work) {
    const SeriesSums s = state.series;
    state.series = {};
    const double n = s.steps;
    SeriesRow row;
    row.time_s = time_s(scene, state);
    row.stage = scene.stage;
    row.wheel_x_m = state.wheel.rim.position_m.x;
    row.sinkage_m = state.wheel.rim.position_m.y - state.touch_position_m.y;
    row.effective_radius_m = s.effective_radius_m / n;
    row.hub_speed_m_s = s.hub_speed_m_s / n;
    row.omega_rad_s = s.omega_clockwise_rad_s / n;
    const double rim_speed = row.effective_radius_m * row.omega_rad_s;
    row.slip = rim_speed != 0 ? 1.0 - row.hub_speed_m_s / rim_speed : 0.0;
    row.vertical_force_N = s.fy_N / n;
    row.torque_Nm = s.torque_Nm / n;
    row.drawbar_pull_N = s.drawbar_N / n;
    row.net_traction_N = -row.drawbar_pull_N;
    row.gross_tractive_effort_N = row.torque_Nm / row.effective_radius_m;
    row.motion_resistance_N = row.net_traction_N - row.gross_tractive_effort_N;
    row.fx_positive_N = s.fx_positive_N / n;
    row.fx_negative_N = s.fx_negative_N / n;
    row.commanded_omega_rad_s = travel_target(scene.c.travel, scene.c.wheel, row.time_s).omega_clockwise_rad_s;
    row.vertical_momentum_Ns = momentum_Ns(scene.wheel, state.wheel).y;
    row.ledger = state.energy;
    row.stored_J = measure_energy(scene, state, work).sum_J();
    return row;
}

Frame take_frame(const Scene& scene, const State& state, const Workspace& work) {
    const DiscFields fields = measure_fields(scene, state, work);
    return make_frame(state, time_s(scene, state), {fields.speed_m_s, fields.pressure_Pa});
}

double cpu_seconds() { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }
double first_thread_seconds() { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }
double wall_seconds() { return clock_seconds(CLOCK_MONOTONIC); }

/// A run in progress: what the loop and the end of a run share.
struct LiveRun {
    RunRequest request;
    DirectoryLock lock;
    Case c;
    State state;
    std::unique_ptr<Recorder> recorder;
    std::unique_ptr<ProgressLine> progress;
    std::uint64_t steps_made = 0;  ///< by this process
    Spent before;                  ///< by earlier processes, up to the checkpoint
    double cpu_begin_s = cpu_seconds(), first_thread_begin_s = first_thread_seconds(), wall_begin_s = wall_seconds();
    std::optional<Violation> violation;
    Profile profile;
};

Spent measure_spent(const LiveRun& run) {
    return {run.before.steps + run.steps_made, run.before.cpu_s + cpu_seconds() - run.cpu_begin_s,
            run.before.wall_s + wall_seconds() - run.wall_begin_s};
}

std::string checkpoint_path(const LiveRun& run) { return run.request.directory + "/checkpoint.h5"; }

std::string stage_directory(const LiveRun& run, Stage stage) {
    return run.request.stage_cache + "/" + stage_hash(run.c, stage, results_version);
}

void write_run_checkpoint(LiveRun& run) {
    if (run.recorder) run.recorder->flush();
    if (run.recorder) write_checkpoint(checkpoint_path(run), run.state, run.c, measure_spent(run));
}

/// Steps that this process has to make.
std::uint64_t remaining_total(const LiveRun& run) {
    std::uint64_t total = 0;
    for (const Stage s : {Stage::consolidation, Stage::sinkage, Stage::travel})
        if (s >= run.state.progress.stage && s <= run.request.last_stage) total += steps_of_stage(run.c, s);
    return total - std::min(total, run.state.progress.step);  // a resumed run is within its first stage
}

std::string progress_note(const State& state) {
    if (state.progress.stage == Stage::consolidation)
        return fmt::format("settling, v_rms {:.1f} mm/s", 1e3 * rms_speed_m_s(state.discs));
    return fmt::format("{}, x {:.3f} m, z {:.1f} mm", stage_name(state.progress.stage), state.wheel.rim.position_m.x,
                       1e3 * (state.wheel.rim.position_m.y - state.touch_position_m.y));
}

/// Hands the profile of a stage back to the run, however the stage ends.
struct KeepProfile {
    const Profile& from;
    Profile& to;
    ~KeepProfile() { to = from; }
};

/// Step limits at the beginning of a stage. False: the step is beyond one, and none asked for that.
bool accept_step(LiveRun& run, const Scene& scene, const HealthWatch& watch) {
    const double dt = scene.dem.step_s;
    if (run.request.show == Show::progress)
        fmt::print("step limits, {} (time_step_s as a share of each):\n{}", stage_name(scene.stage),
                   describe_limits(watch.limits, dt));
    const StepLimit* worst = find_worst(watch.limits, dt, Among::certain);
    if (worst == nullptr || run.request.unstable_step == UnstableStep::allow || run.state.progress.step > 0)
        return true;
    run.violation = refuse_step(run.state, *worst, watch, dt);
    return false;
}

/// The same for what the case alone says, before anything is written.
void refuse_unstable_case(const LiveRun& run) {
    if (run.request.unstable_step == UnstableStep::allow) return;
    if (const auto worst = find_certain_excess(run.c))
        fail_input(explain_excess(*worst, run.c.time_step_s) + " Run it all the same with --allow-unstable?");
}

/// How often a stage does what, in steps; 0: never.
struct Intervals {
    std::uint64_t series = 0, frame = 0, checkpoint = 0, energy = 0;
};

Intervals find_intervals(const Case& c) {
    const double dt = c.time_step_s;
    Intervals every{steps_in(c.record.series_interval_s, dt), steps_in(c.record.frame_interval_s, dt),
                    steps_in(c.record.checkpoint_interval_s, dt), 0};
    // The account needs velocities at half steps.
    if (c.integrator == Integrator::symplectic_euler) every.energy = steps_in(c.record.energy_interval_s, dt);
    return every;
}

void add_frame(LiveRun& run, const Scene& scene, const Workspace& work) {
    run.recorder->add_frame(take_frame(scene, run.state, work));
    if (scene.has_soil_elements())
        add_soil_frame(run.request.directory, run.state.soil, time_s(scene, run.state), scene.soil.columns);
}

/// At the beginning of the travel, or where it is taken up.
void begin_records(LiveRun& run, const Scene& scene, const Workspace& work) {
    const bool resumed = run.state.progress.step > 0;
    if (scene.has_soil_elements() && resumed)
        drop_soil_frames_after(run.request.directory, time_s(scene, run.state));
    else if (scene.has_soil_elements())
        start_soil_frames(run.request.directory);  // a run taken up before its travel may have left some
    if (!resumed) add_frame(run, scene, work);
}

/// What belongs to the travel's step just made, and to its last one in any case.
void record_step(LiveRun& run, const Scene& scene, const Workspace& work, const Intervals& every, std::uint64_t last) {
    const std::uint64_t at = run.state.progress.step;
    if (is_due(at, every.series) || at == last) run.recorder->add_series(take_series_row(scene, run.state, work));
    if (is_due(at, every.frame) || at == last) add_frame(run, scene, work);
    if (at == last && run.c.record.final_stress == FinalStress::write)
        write_file_atomically(run.request.directory + "/stress.csv", stress_csv(scene, run.state, work));
}

/// One step, with the energy account where a sample is due. False: a check has failed.
bool advance(LiveRun& run, const Scene& scene, Workspace& work, HealthWatch& watch, std::uint64_t energy_interval) {
    State& state = run.state;
    if (!is_due(state.progress.step + 1, energy_interval)) {
        step(scene, state, work);
        return true;
    }
    const double interval_s = static_cast<double>(energy_interval) * scene.dem.step_s;
    const EnergyFlow flow = step_and_measure(scene, state, work);
    add_to_ledger(state.energy, flow, interval_s);
    run.violation = check_budget(scene, state, work, flow, interval_s, watch);
    return !run.violation;
}

bool is_healthy(LiveRun& run, const Scene& scene, const Workspace& work, HealthWatch& watch) {
    run.violation = check_health(scene, run.state, work, watch);
    if (!run.violation) run.violation = check_rest(scene, run.state, work, watch);
    return !run.violation;
}

/// Steps through one stage. False: stopped by a signal or a health check.
bool run_stage(LiveRun& run, Stage stage) {
    const Scene scene = make_scene(run.c, stage);
    if (run.state.progress.stage != stage || run.state.progress.step == 0) begin_stage(scene, run.state);
    Workspace work = make_workspace(scene, run.state);
    work.profile = run.profile;
    const KeepProfile keep{work.profile, run.profile};
    HealthWatch watch = begin_watch(scene, run.state);
    if (!accept_step(run, scene, watch)) return false;
    const Progress& progress = run.state.progress;
    const std::uint64_t last = steps_of_stage(run.c, stage);
    const Intervals every = find_intervals(run.c);
    const bool recorded = stage == Stage::travel && run.recorder != nullptr;
    if (recorded) begin_records(run, scene, work);
    while (progress.step < last) {
        if (!advance(run, scene, work, watch, every.energy)) return false;
        ++run.steps_made;
        const bool at_end = progress.step == last;
        if (is_due(progress.step, health_interval) || at_end) {
            if (!is_healthy(run, scene, work, watch)) return false;
            if (run.progress) run.progress->show(run.steps_made, progress_note(run.state));
        }
        if (recorded) record_step(run, scene, work, every, last);
        if (is_due(progress.step, every.checkpoint) && !at_end) write_run_checkpoint(run);
        if (signal_seen != 0 || progress.total_steps == run.request.stop_at_step) {
            write_run_checkpoint(run);
            return false;
        }
    }
    return true;
}

/// The end of a stage, with what is worth knowing about it.
void write_stage(const LiveRun& run, Stage stage, const std::string& directory) {
    fs::create_directories(directory);
    const DirectoryLock lock(directory, Busy::wait);  // another run may end the same stage
    write_file_atomically(directory + "/stage.csv", to_csv(describe_stage(run.c, run.state, stage)));
    write_checkpoint(directory + "/checkpoint.h5", run.state, run.c);
}

/// Into the cache; one that cannot be written to costs time, not the run, unless the stage is all that was asked for.
void keep_stage(const LiveRun& run, Stage stage) {
    if (stage == Stage::travel) return;
    try {
        write_stage(run, stage, stage_directory(run, stage));
    } catch (const std::exception& error) {
        if (run.request.directory.empty()) throw;
        fmt::print(stderr, "note: {} The {} is not kept for other runs.\n", error.what(), stage_name(stage));
    }
}

/// What keep_stage() found worth knowing; nothing where that is lost or damaged.
std::vector<RunValue> read_stage_facts(const std::string& path) {
    if (!fs::exists(path)) return {};
    try {
        return read_values(path);
    } catch (const Error& error) {
        fmt::print(stderr, "note: {} run.csv lacks what it says.\n", error.what());
        return {};
    }
}

/// A damaged file of the cache costs time, not the run.
std::optional<State> read_stage(const std::string& path) {
    if (!fs::exists(path)) return std::nullopt;
    try {
        return read_checkpoint(path).state;
    } catch (const Error& error) {
        fmt::print(stderr, "note: {} The stage is simulated anew.\n", error.what());
        return std::nullopt;
    }
}

/// Starts from the furthest stage in the cache.
State find_beginning(const LiveRun& run, Stage& next) {
    for (const Stage s : {Stage::sinkage, Stage::consolidation}) {
        if (s > run.request.last_stage) continue;
        next = s == Stage::sinkage ? Stage::travel : Stage::sinkage;
        if (auto state = read_stage(stage_directory(run, s) + "/checkpoint.h5")) return std::move(*state);
    }
    next = Stage::consolidation;
    return make_initial_state(run.c);
}

/// Shares of the CPU time of the first thread, which does everything but blocks of discs; that of the others, which
/// includes waiting for it, apart.
void print_profile(const LiveRun& run, double cpu_s) {
    const double first_s = first_thread_seconds() - run.first_thread_begin_s;
    const auto print_line = [first_s](std::string_view name, double seconds) {
        fmt::print("profile: {:<18} {:8.2f} s {:5.1f} %\n", name, seconds, 100 * seconds / first_s);
    };
    double steps_s = 0;
    for (std::size_t p = 0; p < run.profile.seconds.size(); ++p) {
        print_line(phase_name[p], run.profile.seconds[p]);
        steps_s += run.profile.seconds[p];
    }
    print_line("records and checks", first_s - steps_s);
    if (run.request.threads > 1) print_line("other threads", cpu_s - first_s);
}

/// The pictures of a whole run. They can be drawn at any time, so that a lack of gnuplot or of space is not the run's.
void draw_last_frame(const std::string& directory) {
    try {
        draw_pictures(directory, directory, -1);
    } catch (const Error& error) {
        fmt::print(stderr, "note: {} The run is whole without its pictures; `ifedem picture {} -o {}` draws them.\n",
                   error.what(), directory, directory);
    }
}

int finish(LiveRun& run) {
    const Spent spent = measure_spent(run);
    const std::string hash = to_hex(hash_state(run.state));
    const auto particles = static_cast<double>(run.state.discs.disc.size());
    const double particle_steps = particles * static_cast<double>(spent.steps);
    const double ns = particle_steps > 0 ? 1e9 * spent.cpu_s / particle_steps : 0;
    if (run.recorder) {
        run.recorder->finish();
        std::vector<RunValue> values = describe_run(run.c, run.state, run.request.threads);
        values.push_back({"state_hash", hash, ""});
        values.push_back({"steps", fmt::format("{}", spent.steps), ""});
        values.push_back({"particles", fmt::format("{:.0f}", particles), ""});
        values.push_back({"cpu_s", fmt::format("{:.2f}", spent.cpu_s), "s"});
        values.push_back({"wall_s", fmt::format("{:.2f}", spent.wall_s), "s"});
        values.push_back({"ns_per_particle_step", fmt::format("{:.2f}", ns), "ns"});
        for (const Stage s : {Stage::consolidation, Stage::sinkage})
            for (const RunValue& v : read_stage_facts(stage_directory(run, s) + "/stage.csv"))
                values.push_back({std::string(stage_name(s)) + "_" + v.name, v.value, v.unit});
        write_contact_stress(run.request.directory, run.c, run.state.stress);
        if (has_soil_elements(run.state))
            write_file_atomically(run.request.directory + "/conversions.csv", conversions_csv(run.state.soil));
        // Last: a directory with this file counts as a finished run.
        write_file_atomically(run.request.directory + "/run.csv", to_csv(values));
        draw_last_frame(run.request.directory);
        std::error_code ignored;
        fs::remove(checkpoint_path(run), ignored);  // the run is whole: nothing is left to go on from
    }
    fmt::print("state-hash: {}\n", hash);
    fmt::print(
        "performance: steps={} particles={:.0f} cpu_s={:.2f} wall_s={:.2f} ns_per_particle_step={:.2f} "
        "peak_MB={:.1f}\n",
        spent.steps, particles, spent.cpu_s, spent.wall_s, ns, peak_memory_MB());
    if (run.profile.on) print_profile(run, spent.cpu_s - run.before.cpu_s);
    return static_cast<int>(ExitCode::done);
}

int go_through_stages(LiveRun& run, Stage first) {
    set_threads(run.request.threads);
    run.profile.on = run.request.profile;
    const std::string label = fs::path(run.request.directory.empty() ? run.c.name : run.request.directory).filename();
    run.progress = std::make_unique<ProgressLine>(label, remaining_total(run), run.request.show == Show::nothing);
    for (const Stage stage : {Stage::consolidation, Stage::sinkage, Stage::travel}) {
        if (stage < first || stage > run.request.last_stage) continue;
        if (run_stage(run, stage)) {
            keep_stage(run, stage);
            continue;
        }
        run.progress.reset();
        if (run.violation) {
            fmt::print(stderr, "{}: {}\n", label, to_text(*run.violation));
            return static_cast<int>(ExitCode::health);
        }
        const int signal = signal_seen;
        const std::string next = run.recorder ? fmt::format("`ifedem resume {}` goes on from step {}",
                                                            run.request.directory, run.state.progress.total_steps)
                                              : "of an unfinished stage nothing is kept";
        fmt::print(stderr, "{}: stopped {}; {}\n", label,
                   signal != 0 ? fmt::format("by signal {}", signal) : "as asked", next);
        if (signal != 0) return 128 + signal;
        fmt::print("state-hash: {}\n", to_hex(hash_state(run.state)));
        return static_cast<int>(ExitCode::done);
    }
    run.progress.reset();
    return finish(run);
}

void watch_signals() {
    signal_seen = 0;
    std::signal(SIGTERM, note_signal);
    std::signal(SIGINT, note_signal);
}

/// Nothing but perhaps the lock of a run that was stopped before it began.
bool is_unused(const fs::path& directory) {
    if (!fs::exists(directory)) return true;
    if (!fs::is_directory(directory)) return false;
    return std::ranges::all_of(fs::directory_iterator(directory), [](const fs::directory_entry& entry) {
        return entry.path().filename() == DirectoryLock::file_name;
    });
}

void refuse_directory(const RunRequest& request) {
    const std::string& dir = request.directory;
    if (is_unused(dir)) return;
    if (request.existing == Existing::refuse)
        fail_input(
            fmt::format("{} exists already (a run would overwrite it). Choose another -o, or add --force?", dir));
    if (!fs::exists(fs::path(dir) / "case.toml"))
        fail_input(fmt::format(
            "{} holds no run (it has no case.toml, so --force does not empty it). Choose another -o?", dir));
}

/// Takes everything but the lock and the case out of a run's directory; the case is what marks it as one.
void empty_directory(const fs::path& directory) {
    for (const auto& entry : fs::directory_iterator(directory)) {
        const fs::path name = entry.path().filename();
        if (name != DirectoryLock::file_name && name != "case.toml") fs::remove_all(entry.path());
    }
}

/// A run that begins behind the step that it is to stop at would never stop.
void refuse_early_stop(const LiveRun& run) {
    const std::uint64_t begin = run.state.progress.total_steps, stop = run.request.stop_at_step;
    if (stop != 0 && stop <= begin)
        fail_input(
            fmt::format("--stop-at-step {} has passed (the run begins at step {}, with what is kept of it or of "
                        "its stages). Give a later step?",
                        stop, begin));
}

int start_run(LiveRun& run) {
    Stage first = Stage::consolidation;
    run.state = find_beginning(run, first);
    refuse_early_stop(run);
    if (const std::string& dir = run.request.directory; !dir.empty()) {
        empty_directory(dir);
        run.recorder = std::make_unique<Recorder>(dir, run.c, make_wheel_mesh(run.c.wheel));
    }
    run.state.progress.stage = first;
    run.state.progress.step = 0;
    return go_through_stages(run, first);
}

/// A run is what its case.toml says. One that cannot be read says nothing; the checkpoint has the case too.
void refuse_changed_case(const std::string& path, const Case& begun_with) {
    std::vector<Override> changes;
    try {
        changes = list_changes(begun_with, read_case(path));
    } catch (const Error&) {
        return;
    }
    if (!changes.empty())
        fail_input(fmt::format(
            "{}: {} is not what the run was begun with (the checkpoint would go on as before). Undo the change, or run "
            "the case into another directory?",
            path, changes.front().key));
}

/// What a stopped run left. False: it is damaged, which costs time, not the run.
bool take_up(LiveRun& run) {
    try {
        Checkpoint checkpoint = read_checkpoint(checkpoint_path(run));
        if (checkpoint.results_version != results_version)
            fail_input(fmt::format(
                "{} was written by results version {} (this program has {}; it would not give the same bits). "
                "Run the case anew?",
                checkpoint_path(run), checkpoint.results_version, results_version));
        refuse_changed_case(run.request.directory + "/case.toml", checkpoint.c);
        run.c = checkpoint.c;
        run.state = std::move(checkpoint.state);
        refuse_early_stop(run);
        fs::remove(run.request.directory + "/run.csv");  // of a run that was stopped while its pictures were drawn
        run.recorder =
            std::make_unique<Recorder>(run.request.directory, run.c, make_wheel_mesh(run.c.wheel), run.state.progress);
        run.before = checkpoint.spent;
        return true;
    } catch (const DamagedFile& damage) {
        fmt::print(stderr, "note: {} The run begins anew.\n", damage.what());
        return false;
    }
}

}  // namespace

int run_case(const RunRequest& request) {
    watch_signals();
    LiveRun run;
    run.request = request;
    run.c = read_case(request.case_path, request.overrides);
    refuse_unstable_case(run);
    if (const std::string& dir = request.directory; !dir.empty()) {
        refuse_directory(request);
        fs::create_directories(dir);
        run.lock = DirectoryLock(dir, Busy::refuse);
        refuse_directory(request);  // another run may have come in between
    }
    return start_run(run);
}

int resume_case(const RunRequest& request) {
    watch_signals();
    LiveRun run;
    run.request = request;
    const std::string& dir = request.directory;
    if (!fs::exists(fs::path(dir) / "case.toml"))
        fail_input(fmt::format("{} holds no run (there is no case.toml in it). Check the path, or run the case?", dir));
    run.lock = DirectoryLock(dir, Busy::refuse);
    const bool stopped = fs::exists(checkpoint_path(run));
    if (!stopped && fs::exists(dir + "/run.csv")) {
        fmt::print("{} is complete\n", dir);
        return static_cast<int>(ExitCode::done);
    }
    if (stopped && take_up(run)) return go_through_stages(run, run.state.progress.stage);
    run.c = read_case(dir + "/case.toml");
    return start_run(run);
}

}  // namespace ifedem

// What a DEM step costs on a dense bed, at rest or avalanching; README.md says what is measured and how.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check/csv.hpp"
#include "core/bitmath.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "dem/threads.hpp"
#include "dem/vector_width.hpp"
#include "record/checkpoint.hpp"
#include "step/health.hpp"
#include "step/step.hpp"

namespace {

using namespace ifedem;
namespace fs = std::filesystem;

/// The least that arithmetic allows for a particle-step of a dense bed: 2 sqrt + 1 div + about 52 flops a pair on
/// AVX-512. A measured figure of one machine: the share tells how far the step is from it, not what any machine can do.
constexpr double arithmetic_bound_ns = 5.4;
/// Pulls the bed sideways as strongly as a slope of 35° would: more than its friction holds.
constexpr double tilt = 0.7;
constexpr double rest_s = 0.5;  ///< with friction, after the frictionless consolidation: a deep bed still sloshes then
constexpr double avalanche_s = 0.05;  ///< of tilted gravity before the first measured step
/// The peers' dashpot is 2500 1/s × m_eff, ours 2ζ√(k m_eff). At this ζ the mean over the touching pairs of bed20k is
/// the same (k = 1e5 N/m); in a single pair theirs is 0.85 to 1.28 times ours.
constexpr double peers_damping_ratio = 0.188;
constexpr double peers_step_s = 1e-5;
constexpr double peers_rolling_cap = 0.1;

struct Request {
    std::string bed = "20k", law = "rolling", csv, cache = "build/bench";
    bool flow = false, as_peers = false;
    double length_m = 2.0, step_s = 0;
    std::uint64_t steps = 250, warm = 250, blocks = 9;
    int threads = 1;
};

// ---------------------------------------------------------------------------------------------------------------- beds

struct Bed {
    Case c;
    State state;
};

/// No wheel, so the stage is consolidation, but with the friction of the later stages.
Scene make_bench_scene(Case c, const Request& r) {
    c.contact.consolidation_friction_soil = c.contact.friction_soil;
    c.contact.consolidation_friction_wall = c.contact.friction_wall;
    if (r.as_peers) {
        c.time_step_s = peers_step_s;
        c.contact.damping_ratio = peers_damping_ratio;
        c.contact.contact_end = ContactEnd::attraction;  // their dashpots may pull
    }
    if (r.step_s > 0) c.time_step_s = r.step_s;
    if (r.law != "rolling") c.contact.rolling_factor = 0;
    Scene scene = make_scene(c, Stage::consolidation);
    if (r.as_peers) scene.dem.soil.damping_ratio_of_ratios = scene.dem.wall.damping_ratio_of_ratios = 0;
    if (r.law == "spring") scene.dem.rolling_springs = true, scene.dem.soil.rolling_cap = peers_rolling_cap;
    if (r.flow) scene.dem.gravity_m_s2 = {tilt * c.gravity_m_s2, -c.gravity_m_s2};
    return scene;
}

void advance(const Scene& scene, State& state, std::uint64_t steps) {
    Workspace work = make_workspace(scene, state);
    for (std::uint64_t n = 0; n < steps; ++n) step(scene, state, work);
}

/// The checkpoint `path` if it is of this case, length and results version; else made anew and kept there.
template <class Make>
State keep(const std::string& path, const Case& c, std::uint64_t total_steps, const Make& make) {
    try {
        Checkpoint old = read_checkpoint(path);
        if (old.results_version == results_version && to_toml(old.c) == to_toml(c) &&
            old.state.progress.total_steps == total_steps)
            return std::move(old.state);
    } catch (const Error&) {  // missing, or another version's
    }
    fmt::print(stderr, "making {}\n", path);
    State state = make();
    fs::create_directories(fs::path(path).parent_path());
    write_checkpoint(path, state, c);
    return state;
}

std::uint64_t to_steps(const Case& c, double duration_s) {
    return static_cast<std::uint64_t>(std::llround(duration_s / c.time_step_s));
}

/// Chapter 3's soil, consolidated and at rest; for flow then avalanching.
Bed make_bed(const Request& r, std::int64_t disc_count, double length_m) {
    Bed bed;
    bed.c.name = r.bed;
    bed.c.bed.disc_count = disc_count;
    bed.c.bed.length_m = length_m;
    const std::uint64_t settling = steps_of_stage(bed.c, Stage::consolidation), resting = to_steps(bed.c, rest_s),
                        flowing = to_steps(bed.c, avalanche_s);
    const auto settled = [&] {
        return keep(fmt::format("{}/{}-settled.checkpoint", r.cache, r.bed), bed.c, settling + resting, [&] {
            State state = make_initial_state(bed.c);
            advance(make_scene(bed.c, Stage::consolidation), state, settling);
            advance(make_bench_scene(bed.c, {}), state, resting);
            return state;
        });
    };
    if (!r.flow) {
        bed.state = settled();
        return bed;
    }
    Request avalanche;
    avalanche.flow = true;
    bed.state = keep(fmt::format("{}/{}-flow.checkpoint", r.cache, r.bed), bed.c, settling + resting + flowing, [&] {
        State state = settled();
        advance(make_bench_scene(bed.c, avalanche), state, flowing);
        return state;
    });
    return bed;
}

/// Discs from x,y,r[,vx,vy,omega]; lines that begin with # are comments.
Bed read_bed(const Request& r) {
    std::string text = read_text(r.bed);
    while (text.starts_with('#')) text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
    const CsvTable table = parse_csv(text, r.bed);
    const std::size_t x = table.require("x"), y = table.require("y"), radius = table.require("r");
    const auto vx = table.find("vx"), vy = table.find("vy"), omega = table.find("omega");
    Bed bed;
    bed.c.name = r.bed;
    bed.c.bed.length_m = r.length_m;
    bed.c.soil.radii_m.clear();
    for (const CsvRow& row : table.rows) {
        const auto number = [&](std::optional<std::size_t> column) {
            if (!column) return 0.0;
            const auto value = parse_number(row.cells[*column]);
            if (!value) fail_input(fmt::format("{}: '{}' is not a number. Correct it.", r.bed, row.cells[*column]));
            return *value;
        };
        Disc d;
        d.x_m = number(x), d.y_m = number(y), d.radius_m = number(radius);
        d.vx_m_s = number(vx), d.vy_m_s = number(vy), d.omega_rad_s = number(omega);
        d.inverse_mass_1_kg = 1.0 / (pi * d.radius_m * d.radius_m * bed.c.soil.thickness_m * bed.c.soil.density_kg_m3);
        bed.state.discs.id.push_back(static_cast<std::uint32_t>(bed.state.discs.disc.size()));
        bed.state.discs.disc.push_back(d);
        bed.c.soil.radii_m.push_back(d.radius_m);  // the library asks for the extremes only
    }
    if (table.rows.empty()) fail_input(fmt::format("{} holds no discs. Give a bed.", r.bed));
    bed.c.bed.disc_count = static_cast<std::int64_t>(table.rows.size());
    return bed;
}

Bed find_bed(const Request& r) {
    if (r.bed == "20k") return make_bed(r, 20000, 2.0);
    if (r.bed == "46k") return make_bed(r, 46280, 2.4);  // chapter 5's bin of 2.4 m × 0.4 m
    return read_bed(r);
}

// --------------------------------------------------------------------------------------------------------- measurement

/// Heap in use; large arrays are mapped apart from it.
std::size_t heap_bytes() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

double count_contacts(const State& state, const DemWorkspace& work) {
    const auto& disc = state.discs.disc;
    std::size_t touching = 0;
    for (std::size_t n = 0; n < work.i.size(); ++n) {
        const Disc &a = disc[work.i[n]], &b = disc[work.j[n]];
        if (norm({b.x_m - a.x_m, b.y_m - a.y_m}) < a.radius_m + b.radius_m) ++touching;
    }
    return static_cast<double>(touching);
}

struct Measured {
    std::vector<double> cpu_s, wall_s;  ///< a block of steps each
    double list_share = 0, listed_pairs = 0, contacts = 0;
    std::uint64_t refreshes = 0, rebuilds = 0;  ///< a block
    std::size_t bytes = 0;                      ///< of state and workspace
    State end;
};

/// The last block: its clocks and counts cost time, so it gives no times but shares.
void account_block(const Scene& scene, State& state, Workspace& work, std::uint64_t steps, Measured& m) {
    work.profile.on = true;
    m.contacts = 0.5 * count_contacts(state, work.dem);
    for (std::uint64_t n = 0; n < steps; ++n) step(scene, state, work);
    m.contacts += 0.5 * count_contacts(state, work.dem);
    m.listed_pairs = static_cast<double>(work.dem.i.size());
    double whole_s = 0;
    for (const double s : work.profile.seconds) whole_s += s;
    const auto phase_s = [&](Phase p) { return work.profile.seconds[static_cast<std::size_t>(p)]; };
    m.list_share = (phase_s(Phase::lists) + phase_s(Phase::watch)) / whole_s;
    m.refreshes = work.dem.refreshes, m.rebuilds = work.dem.rebuilds;
    if (const auto v = check_health(scene, state, work)) fail_input("the bed fails its health check: " + to_text(*v));
}

/// Every block makes the same steps from the same state: blocks differ by what the machine does meanwhile, alone.
Measured measure(const Scene& scene, State begin, const Request& r) {
    advance(scene, begin, r.warm);
    Measured m;
    for (std::uint64_t k = 0; k <= r.blocks; ++k) {
        const std::size_t before = heap_bytes();
        State state = begin;
        Workspace work = make_workspace(scene, state);
        if (k == r.blocks) {
            account_block(scene, state, work, r.steps, m);
            m.bytes = heap_bytes() - before;
            m.end = std::move(state);
            break;
        }
        const double cpu = clock_seconds(CLOCK_PROCESS_CPUTIME_ID), wall = clock_seconds(CLOCK_MONOTONIC);
        for (std::uint64_t n = 0; n < r.steps; ++n) step(scene, state, work);
        m.cpu_s.push_back(clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
        m.wall_s.push_back(clock_seconds(CLOCK_MONOTONIC) - wall);
    }
    return m;
}

// -------------------------------------------------------------------------------------------------------------- report

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return 0.5 * (v[(v.size() - 1) / 2] + v[v.size() / 2]);
}

/// Of the whole bed: what is compared between codes. Rotation is left out, since not all of them report it alike.
struct Motion {
    double height_m = 0, vx_m_s = 0, kinetic_J = 0;
};
Motion measure_motion(const State& state) {
    Motion sum;
    double mass_kg = 0;
    for (const Disc& d : state.discs.disc) {
        const double m = 1.0 / d.inverse_mass_1_kg;
        mass_kg += m;
        sum.height_m += m * d.y_m, sum.vx_m_s += m * d.vx_m_s;
        sum.kinetic_J += 0.5 * m * (d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s);
    }
    return {sum.height_m / mass_kg, sum.vx_m_s / mass_kg, sum.kinetic_J};
}

std::string compiler_name() {
#if defined(__clang__)
    return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

using Columns = std::vector<std::pair<std::string, std::string>>;

Columns describe(const Request& r, const Scene& scene, const Measured& m) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto discs = static_cast<double>(m.end.discs.disc.size()), steps = static_cast<double>(r.steps);
    const double to_ns = 1e9 / (discs * steps), ns = to_ns * median(m.cpu_s);
    const auto [least, most] = std::minmax_element(m.cpu_s.begin(), m.cpu_s.end());
    const double measured_steps = steps * static_cast<double>(r.blocks);
    const Motion motion = measure_motion(m.end);
    const auto number = [](double v) { return fmt::format("{:.5g}", v); };
    const auto count = [](double v) { return fmt::format("{:.0f}", v); };
    return {{"bed", fs::path(r.bed).stem().string()},
            {"state", r.flow ? "flow" : "settled"},
            {"law", r.law},
            {"step_s", number(scene.dem.step_s)},
            {"threads", fmt::format("{}", r.threads)},
            {"vector_width", fmt::format("{}", vector_width())},
            {"compiler", compiler_name()},
            {"discs", count(discs)},
            {"blocks", fmt::format("{}", r.blocks)},
            {"steps_a_block", fmt::format("{}", r.steps)},
            {"particle_steps", count(discs * measured_steps)},
            {"contact_steps", count(m.contacts * measured_steps)},
            {"cpu_ns_particle_step", number(ns)},
            {"cpu_ns_least", number(to_ns * *least)},
            {"cpu_ns_most", number(to_ns * *most)},
            {"wall_ns_particle_step", number(to_ns * median(m.wall_s))},
            {"cpu_ns_contact_step", number(ns * discs / m.contacts)},
            {"share_of_arithmetic_bound", number(arithmetic_bound_ns / ns)},
            {"list_share", number(m.list_share)},
            {"refreshes_a_block", fmt::format("{}", m.refreshes)},
            {"rebuilds_a_block", fmt::format("{}", m.rebuilds)},
            {"listed_pairs_a_disc", number(m.listed_pairs / discs)},
            {"contacts_a_disc", number(2 * m.contacts / discs)},
            {"bytes_a_disc", count(static_cast<double>(m.bytes) / discs)},
            {"peak_MB", number(static_cast<double>(usage.ru_maxrss) / 1024)},
            {"mean_height_m", fmt::format("{:.7g}", motion.height_m)},
            {"mean_vx_m_s", number(motion.vx_m_s)},
            {"kinetic_J", number(motion.kinetic_J)},
            {"state_hash", to_hex(hash_state(m.end))}};
}

/// Adds a line to the file, which must have the same columns if it is there.
void append_csv(const std::string& path, const Columns& columns) {
    std::vector<std::string> names, values;
    for (const auto& [name, value] : columns) names.push_back(name), values.push_back(value);
    const std::string old = fs::exists(path) ? read_text(path) : csv_line(names);
    if (!old.starts_with(csv_line(names)))
        fail_input(fmt::format("{} has other columns (another version wrote it). Remove it.", path));
    write_text(path, old + csv_line(values));
}

void run(const Request& r) {
    set_threads(r.threads);
    Bed bed = find_bed(r);
    const Scene scene = make_bench_scene(bed.c, r);
    const Measured m = measure(scene, std::move(bed.state), r);
    const Columns columns = describe(r, scene, m);
    for (const auto& [name, value] : columns) fmt::print("{:<26} {}\n", name, value);
    if (!r.csv.empty()) append_csv(r.csv, columns);
}

int run_program(int argc, char** argv) {
    CLI::App app{"step_bench: what a DEM step costs on a dense bed"};
    Request r;
    app.add_option("--bed", r.bed, "20k (2.0 m bin), 46k (2.4 m bin), or a file with columns x,y,r[,vx,vy,omega]");
    app.add_option("--length", r.length_m, "length of the bin of a bed from a file, m");
    bool settled = false;
    auto* flow = app.add_flag("--flow", r.flow, "gravity tilted by 35°: the bed avalanches");
    app.add_flag("--settled", settled, "the bed at rest (default)")->excludes(flow);
    app.add_option("--law", r.law, "rolling resistance: rolling (Eq 2.18), none, spring (the peers')")
        ->check(CLI::IsMember({"rolling", "none", "spring"}));
    app.add_flag("--as-peers", r.as_peers, "step and dashpots of the comparison with other codes");
    app.add_option("--dt", r.step_s, "time step, s (default: the case's)")->check(CLI::PositiveNumber);
    app.add_option("--steps", r.steps, "steps a block")->check(CLI::PositiveNumber);
    app.add_option("--blocks", r.blocks, "timed blocks")->check(CLI::PositiveNumber);
    app.add_option("--warm", r.warm, "steps before the first block");
    app.add_option("--threads", r.threads, "threads")->check(CLI::Range(1, 256));
    app.add_option("--csv", r.csv, "table to add a line to");
    app.add_option("--cache", r.cache, "directory for the beds made here");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : static_cast<int>(ExitCode::bad_input);
    }
    run(r);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_program(argc, argv);
    } catch (const Error& e) {
        fmt::print(stderr, "{}\n", e.what());
        return static_cast<int>(e.code());
    } catch (const std::exception& e) {
        fmt::print(stderr, "unexpected: {}\n", e.what());
        return static_cast<int>(ExitCode::io);
    }
}

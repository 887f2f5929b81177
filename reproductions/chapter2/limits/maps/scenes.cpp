#include "core/clock.hpp"
#include "maps.hpp"

namespace ifedem::maps {
namespace {

/// The short case of chapter 3, all three stages watched.
Case short_case() {
    Case c;
    c.bed.length_m = 0.6, c.bed.disc_count = 2400;  // 83 mm deep
    c.travel.start_x_m = 0.22, c.travel.distance_m = 0.05, c.travel.acceleration_time_s = 0.2;
    c.stages.consolidation_s = 0.4, c.stages.sinkage_s = 0.2;
    return c;
}

struct Result {
    std::string stage = "-", cause = "none";
    double effort_N = 0, pull_N = 0, sinkage_mm = 0, bottom_mm = 0;
};

Result run(const Case& c, State* bed) {
    Result r;
    State state = bed != nullptr ? *bed : make_initial_state(c);
    for (const Stage stage : {Stage::consolidation, Stage::sinkage, Stage::travel}) {
        if (bed != nullptr && stage == Stage::consolidation) continue;
        const scene::Outcome o = scene::watch_stage(c, stage, state, false);
        if (!o.found) continue;
        r.stage = stage == Stage::consolidation ? "consolidation" : stage == Stage::sinkage ? "sinkage" : "travel";
        r.cause = cause_name(o.found->cause);
        return r;
    }
    const SeriesSums& s = state.series;
    r.effort_N = s.torque_Nm / s.effective_radius_m;
    r.pull_N = -s.drawbar_N / s.steps;
    r.sinkage_mm = 1e3 * (state.wheel.rim.position_m.y - state.touch_position_m.y);
    double bottom = 1;
    for (const Vec2 p : state.wheel.position_m) bottom = std::min(bottom, p.y);
    r.bottom_mm = 1e3 * bottom;
    return r;
}

void map_outcomes(Output& out) {
    const bool quick = out.effort == Effort::quick;
    struct Row {
        const char* name;
        void (*change)(Case&);
    };
    const Row rows[] = {
        {"as it is (slip 60 %)", [](Case&) {}},
        {"slip 70 %", [](Case& c) { c.travel.slip_percent = 70; }},
        {"slip 90 %", [](Case& c) { c.travel.slip_percent = 90; }},
        {"slip -5 %", [](Case& c) { c.travel.slip_percent = -5; }},
        {"no load", [](Case& c) { c.wheel.load_N = 0; }},
        {"bin 0.45 m short", [](Case& c) { c.bed.length_m = 0.45, c.bed.disc_count = 1800; }},
        {"bin 40 mm deep", [](Case& c) { c.bed.disc_count = 1160; }},
        {"bin 20 mm deep", [](Case& c) { c.bed.disc_count = 580; }},
        {"bin 8 mm deep", [](Case& c) { c.bed.disc_count = 230; }},
        {"poured 0.05 s before", [](Case& c) { c.stages.consolidation_s = 0.05; }},
        {"poured 0.12 s before", [](Case& c) { c.stages.consolidation_s = 0.12; }},
    };
    std::string text = "scene,stage,cause,gross_tractive_effort_N,net_traction_N,sinkage_mm,lowest_point_mm\n";
    for (const Row& row : rows) {
        Case c = short_case();
        if (quick) c.bed.disc_count = 1200, c.stages.sinkage_s = 0.1, c.travel.distance_m = 0.02;
        row.change(c);
        const Result r = run(c, nullptr);
        text += fmt::format("{},{},{},{:.2f},{:.2f},{:.2f},{:.2f}\n", row.name, r.stage, r.cause, r.effort_N, r.pull_N,
                            r.sinkage_mm, r.bottom_mm);
        if (quick) break;
    }
    out.write("scenes.csv", text);
}

/// The text's fully elastic wheel with its explicit loops: which step does it bear, and does gravity matter?
void map_low_gravity(Output& out) {
    const bool quick = out.effort == Effort::quick;
    Case bed_case = scene::small_case();
    std::string text = "planet,scheme,step_s,limit_elements_s,limit_drawbar_s,limit_torque_s,stage,cause,step\n";
    for (const double gravity : {9.81, 3.71}) {
        Case c = bed_case;
        c.gravity_m_s2 = gravity, c.wheel.load_N = gravity > 5 ? 170 : 64.4;
        const State bed = scene::settle(c);
        c.wheel.body = WheelBody::elastic, c.stages.sinkage_s = 0.04, c.travel.distance_m = 0.005;
        for (const ControlScheme scheme : {ControlScheme::explicit_, ControlScheme::semi_implicit}) {
            for (const double dt : quick ? std::vector<double>{1e-5} : std::vector<double>{5e-6, 1e-5, 2e-5}) {
                c.control.scheme = scheme, c.time_step_s = dt;
                double limit[3] = {0, 0, 0};
                for (const StepLimit& l : find_case_limits(make_scene(c, Stage::sinkage))) {
                    if (l.name == "the whole wheel") limit[0] = l.step_s;
                    if (l.group == LimitGroup::drawbar_loop) limit[1] = l.step_s;
                    if (l.group == LimitGroup::torque_loop) limit[2] = l.step_s;
                }
                State state = bed;
                std::string stage = "-", cause = "none";
                std::uint64_t at = 0;
                for (const Stage s : {Stage::sinkage, Stage::travel}) {
                    const scene::Outcome o = scene::watch_stage(c, s, state, false);
                    if (!o.found) continue;
                    stage = s == Stage::sinkage ? "sinkage" : "travel", cause = cause_name(o.found->cause),
                    at = o.steps;
                    break;
                }
                text += fmt::format("{},{},{:.3g},{:.4g},{:.4g},{:.4g},{},{},{}\n", gravity > 5 ? "Earth" : "Mars",
                                    scheme == ControlScheme::explicit_ ? "explicit" : "semi-implicit", dt, limit[0],
                                    limit[1], limit[2], stage, cause, at);
                if (scheme == ControlScheme::explicit_ && gravity < 5 && dt == 1e-5)
                    out.measured("mars_1e-5_fails", cause == "none" ? 0 : 1, "-",
                                 "fully elastic wheel, explicit loops, 1e-5 s on Mars");
                if (scheme == ControlScheme::explicit_ && gravity > 5 && dt == 1e-5)
                    out.measured("earth_1e-5_fails", cause == "none" ? 0 : 1, "-", "the same on Earth");
            }
        }
    }
    out.write("low_gravity.csv", text);
}

/// Speeds of a settling bed against time: Earth, Mars, and Mars with time over √(9.81/3.71) and over 9.81/3.71.
void map_consolidation(Output& out) {
    std::string text = "time_s,earth_m_s,mars_m_s,moon_m_s\n";
    constexpr double gravity[3] = {9.81, 3.71, 1.62};
    std::vector<std::vector<double>> speed(3);
    constexpr double interval = 0.004;
    const int count = out.effort == Effort::quick ? 100 : 500;
    double support[3] = {0, 0, 0};  // when v_rms has fallen below 5 % of its greatest
    for (int k = 0; k < 3; ++k) {
        Case c = short_case();
        c.bed.disc_count = 600, c.bed.length_m = 0.2;
        c.gravity_m_s2 = gravity[k];
        State state = make_initial_state(c);
        const Scene scene = make_scene(c, Stage::consolidation);
        begin_stage(scene, state);
        Workspace work = make_workspace(scene, state);
        const int steps = static_cast<int>(std::lround(interval / c.time_step_s));
        double greatest = 0;
        for (int n = 0; n < count; ++n) {
            for (int s = 0; s < steps; ++s) step(scene, state, work);
            speed[static_cast<std::size_t>(k)].push_back(rms_speed_m_s(state.discs));
            greatest = std::max(greatest, speed[static_cast<std::size_t>(k)].back());
            if (support[k] == 0 && speed[static_cast<std::size_t>(k)].back() < 0.05 * greatest)
                support[k] = (n + 1) * interval;
        }
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
        text += fmt::format("{:.3f},{:.5g},{:.5g},{:.5g}\n", interval * static_cast<double>(n + 1), speed[0][n],
                            speed[1][n], speed[2][n]);
    out.write("consolidation.csv", text);
    out.measured("settling_ratio_mars_earth", support[1] / support[0], "-",
                 "time until v_rms falls to 5 % of its peak, Mars over Earth");
    out.measured("settling_ratio_moon_earth", support[2] / support[0], "-", "the same, Moon over Earth");
}

}  // namespace

void map_scenes(Output& out) {
    map_low_gravity(out);
    map_consolidation(out);
    map_outcomes(out);
}

/// CPU time of the checks over that of the steps between them.
void map_cost(Output& out) {
    const auto cpu = [] { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); };
    Case c = short_case();
    State state = scene::settle(c);
    const Scene scene = make_scene(c, Stage::sinkage);
    begin_stage(scene, state);
    Workspace work = make_workspace(scene, state);
    const double begin = cpu();
    HealthWatch watch = begin_watch(scene, state);
    const double limits = cpu() - begin;
    double checks = 0, steps = 0;
    for (int n = 0; n < 40; ++n) {
        const double a = cpu();
        for (std::uint64_t k = 0; k < health_interval; ++k) step(scene, state, work);
        const double b = cpu();
        for (int k = 0; k < 10; ++k) static_cast<void>(check_health(scene, state, work, watch));
        checks += 0.1 * (cpu() - b), steps += b - a;
    }
    out.measured("check_share", checks / steps, "-", "CPU time of the checks over that of 50 steps; short case");
    out.measured("limits_share", limits / (steps / 2000 * 37500), "-",
                 "limits at the beginning of a stage over the short case's steps");
}

}  // namespace ifedem::maps

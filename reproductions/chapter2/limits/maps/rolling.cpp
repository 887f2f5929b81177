#include "maps.hpp"

namespace ifedem::maps {
namespace {

/// A disc that spins on the floor under its weight, µ = 0: the moment M of Eq 2.18 stops it after ω I/M. What is left
/// of its speed in the second half of four such times, over the speed at the beginning; and M Δt/I, which is what the
/// sign turns it to and fro by.
struct Spin {
    double left = 0, kick = 0;
};
Spin residual_spin(RollingScheme scheme, double step_s) {
    Case c;
    c.bed.disc_count = 1, c.bed.length_m = 0.2, c.time_step_s = step_s;
    c.contact.rolling_scheme = scheme, c.contact.consolidation_friction_wall = 0, c.contact.damping_ratio = 0.5;
    const Scene scene = make_scene(c, Stage::consolidation);
    State state = make_initial_state(c);
    Disc& d = state.discs.disc[0];
    const double weight = c.gravity_m_s2 / d.inverse_mass_1_kg, overlap = weight / c.contact.normal_stiffness_N_m;
    d.y_m = d.radius_m - overlap;
    const double moment = 2 * std::sqrt(overlap * (2 * d.radius_m - overlap)) * weight;
    const double inertia = 0.5 * d.radius_m * d.radius_m / d.inverse_mass_1_kg;
    constexpr double spin = 1;
    d.omega_rad_s = spin;
    const double stop_s = spin * inertia / moment;
    Workspace work = make_workspace(scene, state);
    const auto steps = static_cast<int>(std::max(20.0, 4 * stop_s / step_s));
    double sum = 0;
    int counted = 0;
    for (int n = 1; n <= steps; ++n) {
        step(scene, state, work);
        if (n > steps / 2) sum += std::fabs(state.discs.disc[0].omega_rad_s), ++counted;
    }
    return {sum / counted / spin, moment * step_s / inertia / spin};
}

/// Mean gross tractive effort and sinkage over the second half of a short travel.
struct Answer {
    double pull_N = 0, sinkage_m = 0;
    bool failed = false;
    Cause cause = Cause::energy_drift;
};
Answer travel(const Case& c, const State& sunk) {
    State state = sunk;
    const Scene scene = make_scene(c, Stage::travel);
    begin_stage(scene, state);
    Workspace work = make_workspace(scene, state);
    const std::uint64_t steps = steps_of_stage(c, Stage::travel);
    Answer a;
    for (std::uint64_t n = 1; n <= steps; ++n) {
        step(scene, state, work);
        if (n % health_interval == 0)
            if (const auto v = check_health(scene, state, work)) {
                a.failed = true, a.cause = v->cause;
                return a;
            }
        if (n == steps / 2) state.series = {};
    }
    const SeriesSums& s = state.series;
    a.pull_N = s.torque_Nm / s.effective_radius_m;
    a.sinkage_m = state.wheel.rim.position_m.y - state.touch_position_m.y;
    return a;
}

}  // namespace

void map_rolling(Output& out) {
    const bool quick = out.effort == Effort::quick;
    std::string text = "step_s,sign,limit,half_kick\n";
    double worst = 0;
    for (double dt = 1e-6; dt < 2.1e-4; dt *= quick ? 4 : 1.5) {
        const Spin sign = residual_spin(RollingScheme::sign, dt), limit = residual_spin(RollingScheme::limit, dt);
        text +=
            fmt::format("{:.4g},{:.5g},{:.5g},{:.5g}\n", dt, sign.left, std::max(1e-9, limit.left), 0.5 * sign.kick);
        worst = std::max(worst, limit.left);
    }
    out.write("rolling_disc.csv", text);
    out.measured("rolling_limit_spin_left", worst, "-", "spin that the limit leaves of a braked disc, any step");
    std::string answers = "step_s,scheme,seed,gross_tractive_effort_N,sinkage_mm\n";
    double spread[2] = {0, 0};
    for (const RollingScheme scheme : {RollingScheme::limit, RollingScheme::sign}) {
        double first = 0;
        for (const double dt : quick ? std::vector<double>{4e-5} : std::vector<double>{1.5e-5, 3e-5, 5e-5, 8e-5}) {
            double mean = 0;
            const int seeds = quick ? 1 : 2;
            for (int seed = 1; seed <= seeds; ++seed) {
                Case c = scene::small_case();
                c.bed.disc_count = 1200, c.bed.length_m = 0.5, c.bed.seed = seed, c.wheel.body = WheelBody::rigid;
                c.stages.consolidation_s = 0.4, c.stages.sinkage_s = 0.15, c.travel.distance_m = 0.05;
                c.travel.acceleration_time_s = 0.1, c.travel.speed_m_s = 0.2;
                State state = scene::settle(c);  // at the default step: the same bed for all
                c.time_step_s = dt, c.contact.rolling_scheme = scheme;
                const Scene sinkage = make_scene(c, Stage::sinkage);
                begin_stage(sinkage, state);
                Workspace work = make_workspace(sinkage, state);
                for (std::uint64_t n = 0; n < steps_of_stage(c, Stage::sinkage); ++n) step(sinkage, state, work);
                const Answer a = travel(c, state);
                const double effort = a.failed ? 0 : a.pull_N;
                answers +=
                    fmt::format("{:.4g},{},{},{:.3f},{:.2f}\n", dt, scheme == RollingScheme::limit ? "limit" : "sign",
                                seed, effort, 1e3 * a.sinkage_m);
                mean += effort / seeds;
            }
            if (first == 0) first = mean;
            spread[scheme == RollingScheme::limit ? 0 : 1] = mean / first;
        }
        answers += "\n\n";
    }
    out.write("rolling_travel.csv", answers);
    out.measured("rolling_limit_coarse_over_fine", spread[0], "-",
                 "H at 8e-5 s over H at 1.5e-5 s; two small beds; limit");
    out.measured("rolling_sign_coarse_over_fine", spread[1], "-", "the same with the raw sign");
}

}  // namespace ifedem::maps

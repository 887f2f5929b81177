#pragma once
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "step/energy.hpp"
#include "step/health.hpp"
#include "step/step.hpp"

namespace ifedem::scene {

/// The B3 wheel of chapter 3 over a bin of 700 discs, half a metre long, sampled every millisecond.
inline Case small_case() {
    Case c;
    c.bed.disc_count = 700;
    c.bed.length_m = 0.5;
    c.travel.start_x_m = 0.2;
    c.travel.distance_m = 0.05;
    c.travel.acceleration_time_s = 0.05;
    c.stages.consolidation_s = 1;
    c.stages.sinkage_s = 0.1;
    c.record.energy_interval_s = 1e-3;
    return c;
}

/// A state as a stage's beginning finds it.
inline State settle(const Case& c) {
    omp_set_num_threads(1);
    State state = make_initial_state(c);
    const Scene scene = make_scene(c, Stage::consolidation);
    begin_stage(scene, state);
    Workspace work = make_workspace(scene, state);
    for (std::uint64_t n = 0; n < steps_of_stage(c, Stage::consolidation); ++n) step(scene, state, work);
    return state;
}

/// What a watched stage came to.
struct Outcome {
    std::uint64_t steps = 0;         ///< made
    std::uint64_t planned = 0;       ///< of the stage
    std::uint64_t first_seen = 0;    ///< the first step at which a check of every step would have seen it
    std::optional<Violation> found;  ///< by the checks that a run makes
};

/// Goes through a stage as `run` does. `tamper(state, step)` acts between steps. With `every_step` the checks are made
/// after each step as well, only to know when the failure could be seen first.
inline Outcome watch_stage(const Case& c, Stage stage, State& state, bool every_step,
                           const std::function<void(State&, std::uint64_t)>& tamper = nullptr) {
    omp_set_num_threads(1);
    const Scene scene = make_scene(c, stage);
    begin_stage(scene, state);
    Workspace work = make_workspace(scene, state);
    HealthWatch watch = begin_watch(scene, state);
    const double dt = scene.dem.step_s;
    const auto samples = static_cast<std::uint64_t>(std::max(1LL, std::llround(c.record.energy_interval_s / dt)));
    Outcome o;
    o.planned = steps_of_stage(c, stage);
    while (o.steps < o.planned) {
        if (tamper) tamper(state, state.progress.step);
        ++o.steps;
        const bool sampled = c.integrator == Integrator::symplectic_euler && o.steps % samples == 0;
        if (sampled) {
            const double interval_s = static_cast<double>(samples) * dt;
            const EnergyFlow flow = step_and_measure(scene, state, work);
            add_to_ledger(state.energy, flow, interval_s);
            if ((o.found = check_budget(scene, state, work, flow, interval_s, watch))) break;
        } else {
            step(scene, state, work);
        }
        if (every_step && o.first_seen == 0 && check_health(scene, state, work, watch)) o.first_seen = o.steps;
        if (o.steps % health_interval == 0 || o.steps == o.planned) {
            o.found = check_health(scene, state, work, watch);
            if (!o.found) o.found = check_rest(scene, state, work, watch);
            if (o.found) break;
        }
    }
    return o;
}

}  // namespace ifedem::scene

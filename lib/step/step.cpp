#include "step/step.hpp"

#include <algorithm>

#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/integrate_discs.hpp"
#include "step/integrate_wheel.hpp"

namespace ifedem {
namespace {

void add_disc_forces(const Scene& scene, State& state, Workspace& work, double spring_step_s, Lap& lap) {
    add_pair_forces(scene.dem, state, work.dem, spring_step_s);
    lap(Phase::pairs);
    add_wall_forces(scene.dem, state, work.dem, spring_step_s);
    lap(Phase::walls);
    if (scene.has_wheel()) add_wheel_contacts(scene.dem, scene.wheel, state, work.dem, work.wheel, spring_step_s);
    lap(Phase::wheel_contact);
}

}  // namespace

void step(const Scene& scene, State& state, Workspace& work) {
    const double dt = scene.dem.step_s;
    const bool twice = scene.c.integrator == Integrator::modified_euler_two;
    Lap lap(work.profile);

    update_lists(scene.dem, state, work.dem);
    lap(Phase::lists);
    add_disc_forces(scene, state, work, twice ? 0.0 : dt, lap);
    if (scene.has_wheel()) {
        add_wheel_forces(scene, state, work.wheel);
        lap(Phase::wheel_force);
        integrate_wheel(scene, state, work.wheel);  // control included: the loops act on what they integrate
        lap(Phase::wheel_motion);
    }
    integrate_discs(scene, state, work.dem);
    lap(Phase::discs);
    if (twice) {
        add_disc_forces(scene, state, work, dt, lap);
        correct_discs(scene, state, work.dem);
        lap(Phase::discs);
    }
    if (scene.c.integrator != Integrator::symplectic_euler ||
        std::find(work.dem.block_moved.begin(), work.dem.block_moved.end(), 1) != work.dem.block_moved.end())
        watch_movement(state, work.dem);
    lap(Phase::watch);
    ++state.progress.step;
    ++state.progress.total_steps;
}

}  // namespace ifedem

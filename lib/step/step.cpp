#include "step/step.hpp"

#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/integrate_discs.hpp"
#include "step/integrate_wheel.hpp"

namespace ifedem {
namespace {

void add_disc_forces(const Scene& scene, State& state, Workspace& work, double spring_step_s) {
    add_pair_forces(scene.dem, state, work.dem, spring_step_s);
    add_wall_forces(scene.dem, state, work.dem, spring_step_s);
    if (scene.has_wheel())
        add_wheel_contacts(scene.dem, scene.wheel, state, work.dem, work.wheel, spring_step_s);
}

}  // namespace

void step(const Scene& scene, State& state, Workspace& work) {
    const double dt = scene.dem.step_s;
    const bool twice = scene.c.integrator == Integrator::modified_euler_two;

    update_lists(scene.dem, state, work.dem);
    add_disc_forces(scene, state, work, twice ? 0.0 : dt);
    if (scene.has_wheel()) {
        add_wheel_forces(scene, state, work.wheel);
        integrate_wheel(scene, state, work.wheel);  // control included: the loops act on what they integrate
    }
    integrate_discs(scene, state, work.dem);
    if (twice) {
        add_disc_forces(scene, state, work, dt);
        correct_discs(scene, state, work.dem);
    }
    watch_movement(state, work.dem);
    ++state.progress.step;
    ++state.progress.total_steps;
}

}  // namespace ifedem

#include "step/step.hpp"

#include <algorithm>

#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "dem/skins.hpp"
#include "step/convert.hpp"
#include "step/integrate_discs.hpp"
#include "step/integrate_soil.hpp"
#include "step/integrate_wheel.hpp"
#include "traction/contact_stress.hpp"

namespace ifedem {
namespace {

/// Elements and control under the contact forces of this step.
void advance_wheel(const Scene& scene, State& state, WheelWorkspace& work, Lap& lap) {
    add_wheel_forces(scene, state, work);
    lap(Phase::wheel_force);
    const auto block = enter_stress_block(scene.c.record, state);
    if (block) add_contacts_to_stress(scene.c.record, scene.wheel, work, *block, state);
    integrate_wheel(scene, state, work);  // control included: the loops act on what they integrate
    if (block) add_control_to_stress(scene.wheel, *block, state);
    lap(Phase::wheel_motion);
}

/// Chapter 3's wheel of 312 elements takes 21 µs where a block of discs takes 13 µs. Only threads share work by it.
double cost_in_blocks(const WheelModel& wheel) {
    constexpr double elements_a_block = 190;
    return wheel.free_node.empty() ? 0 : static_cast<double>(wheel.elements.element.size()) / elements_a_block;
}

}  // namespace

void step(const Scene& scene, State& state, Workspace& work) {
    const double dt = scene.dem.step_s;
    const bool twice = scene.c.integrator == Integrator::modified_euler_two;
    const double spring_step_s = twice ? 0.0 : dt;
    Lap lap(work.profile);

    convert_at_boundary(scene, state, work);
    lap(Phase::conversion);
    update_lists(scene.dem, state, work.dem);
    lap(Phase::lists);
    Alongside wheel;
    if (scene.has_wheel()) {
        add_wheel_contacts(scene.dem, scene.wheel, state, work.dem, work.wheel, spring_step_s);
        lap(Phase::wheel_contact);
        wheel = {[&] { advance_wheel(scene, state, work.wheel, lap); }, cost_in_blocks(scene.wheel)};
    }
    if (scene.has_soil_elements()) {
        if (!scene.has_wheel()) work.dem.wheel_force.clear();
        add_soil_contacts(scene.dem, scene.soil, state, work.dem, work.soil, spring_step_s);
        add_soil_forces(scene.soil, state.soil, work.soil);
        integrate_soil(scene, state, work.soil);
        lap(Phase::soil_elements);
    }
    add_forces(
        scene.dem, state, work.dem, spring_step_s,
        [&](Block& block, std::span<DiscForce> force) { integrate_discs(scene, state, work.dem, block, force); },
        wheel);
    lap(Phase::discs);
    if (twice) {
        if (scene.has_wheel()) add_wheel_contacts(scene.dem, scene.wheel, state, work.dem, work.wheel, dt);
        lap(Phase::wheel_contact);
        if (scene.has_soil_elements()) {
            if (!scene.has_wheel()) work.dem.wheel_force.clear();
            add_soil_contacts(scene.dem, scene.soil, state, work.dem, work.soil, dt);
            lap(Phase::soil_elements);
        }
        add_forces(scene.dem, state, work.dem, dt,
                   [&](Block& block, std::span<DiscForce> force) { correct_discs(scene, state, block, force); });
        lap(Phase::discs);
    }
    if (std::any_of(work.dem.block.begin(), work.dem.block.end(), [](const Block& b) { return b.moved; }))
        ask_for_lists(state, work.dem);
    lap(Phase::watch);
    ++state.progress.step;
    ++state.progress.total_steps;
}

}  // namespace ifedem

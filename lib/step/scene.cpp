#include "step/scene.hpp"

#include <cmath>

#include "coupling/conversion.hpp"
#include "dem/bed.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/soil_pattern.hpp"

namespace ifedem {
namespace {

/// Lowers the wheel from above until it is a hair from touching: each drop is the least gap, so it can never pass
/// through.
Vec2 find_first_touch(const Scene& scene, const State& state) {
    const auto& discs = state.discs.disc;
    const double reach = scene.wheel.outer_radius_m + scene.dem.largest_radius_m;
    double top = 0;
    for (const Disc& d : discs)
        if (std::fabs(d.x_m - scene.c.travel.start_x_m) < reach) top = max_of(top, d.y_m + d.radius_m);
    Vec2 hub{scene.c.travel.start_x_m, top + scene.wheel.outer_radius_m + 1e-3};
    constexpr double hair_m = 1e-7;
    for (int tries = 0; tries < 1000; ++tries) {
        const WheelState wheel = place_wheel(scene.wheel, hub);
        double gap = 1e300;
        for (const Disc& d : discs) {
            const Vec2 centre{d.x_m, d.y_m};
            // Only a disc nearer to the rim circle than the best so far can lower the gap.
            if (norm(centre - hub) - d.radius_m - scene.wheel.outer_radius_m >= gap) continue;
            gap = min_of(gap, distance_to_wheel_m(scene.wheel, wheel, centre) - d.radius_m);
        }
        if (gap <= hair_m) break;
        hub.y -= gap - 0.5 * hair_m;
    }
    return hub;
}

/// Elements and discs of a case with soil elements: patterns in the blocks of discs, or a bed on top of the elements.
void fill_soil(const Case& c, State& state) {
    const Scene scene = make_scene(c, Stage::consolidation);
    const SoilModel& model = scene.soil;
    state.soil = place_soil(model);
    if (c.elements.disc_columns == 0) {
        for (Disc& d : state.discs.disc) d.y_m += static_cast<double>(c.elements.rows) * c.elements.block_height_m;
        return;
    }
    state.soil.pattern = prepare_pattern(c);
    state.discs = {};
    for (std::uint32_t b = 0; b < state.soil.kind.size(); ++b) {
        if (state.soil.kind[b] != BlockKind::discs) continue;
        for (const Disc& d : plan_to_discs(model, scene.dem, state.soil, b).add) {
            state.discs.id.push_back(static_cast<std::uint32_t>(state.discs.disc.size()));
            state.discs.disc.push_back(d);
        }
    }
    if (c.integrator != Integrator::symplectic_euler) state.discs.acceleration.resize(state.discs.disc.size());
}

}  // namespace

Scene make_scene(const Case& c, Stage stage) {
    Scene scene;
    scene.c = c;
    scene.stage = stage;
    const bool settling = stage == Stage::consolidation;
    scene.dem = make_dem_constants(c, settling ? c.contact.consolidation_friction_soil : c.contact.friction_soil,
                                   settling ? c.contact.consolidation_friction_wall : c.contact.friction_wall);
    if (scene.has_wheel()) scene.wheel = make_wheel_model(c.wheel);
    if (c.elements.columns > 0)
        scene.soil = make_soil_model(c, scene.dem,
                                     settling ? c.contact.consolidation_friction_wall : c.contact.friction_elements);
    return scene;
}

Workspace make_workspace(const Scene& scene, State& state) {
    Workspace work;
    attach_workspace(scene.dem, state, work.dem);
    if (scene.has_soil_elements()) attach_soil_workspace(scene.soil, state.soil, work.soil);
    return work;
}

std::uint64_t steps_of_stage(const Case& c, Stage stage) {
    double duration = 0;
    if (stage == Stage::consolidation) duration = c.stages.consolidation_s;
    if (stage == Stage::sinkage) duration = c.stages.sinkage_s;
    if (stage == Stage::travel) {
        const double rest = c.travel.distance_m - ramp_way_m(c.travel);
        duration = c.travel.acceleration_time_s + max_of(0.0, rest) / travel_speed_m_s(c.travel);
    }
    return static_cast<std::uint64_t>(std::llround(duration / c.time_step_s));
}

State make_initial_state(const Case& c) {
    State state;
    state.discs = generate_bed(c);
    if (c.elements.columns > 0) fill_soil(c, state);
    return state;
}

void begin_stage(const Scene& scene, State& state) {
    state.progress.stage = scene.stage;
    state.progress.step = 0;
    state.energy = {};
    state.series = {};
    state.stress = {};
    state.soil.conversions.clear();
    if (scene.stage == Stage::sinkage) {
        if (scene.c.bed.levelled_count > 0) level_surface(state, static_cast<std::size_t>(scene.c.bed.levelled_count));
        state.touch_position_m = find_first_touch(scene, state);
        state.wheel = place_wheel(scene.wheel, state.touch_position_m);
    }
    if (scene.has_wheel()) {
        state.control = {};
        state.control.drawbar.target = state.wheel.rim.position_m.x;
        state.control.torque.target = -state.wheel.rim.angle_rad;
    }
}

}  // namespace ifedem

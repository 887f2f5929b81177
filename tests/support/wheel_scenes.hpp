// A bed and a wheel small enough for seconds, through all three stages.
#pragma once
#include "coupling/wheel_model.hpp"
#include "dem/bed.hpp"
#include "support/dem_scenes.hpp"

namespace ifedem::scene {

inline Case make_small_case(std::int64_t discs, double length_m) {
    Case c;
    c.bed.disc_count = discs;
    c.bed.length_m = length_m;
    c.contact.consolidation_friction_soil = c.contact.friction_soil;  // everything that can take energy does
    c.contact.consolidation_friction_wall = c.contact.friction_wall;
    return c;
}

inline Case make_wheel_case(WheelBody body) {
    Case c = make_small_case(900, 0.42);
    c.wheel.body = body;
    c.wheel.load_N = 60;
    c.travel.start_x_m = 0.18;
    c.travel.speed_m_s = 0.2, c.travel.acceleration_time_s = 0.02;
    c.stages.consolidation_s = 0.2, c.stages.sinkage_s = 0.1;
    return c;
}

inline void enter(World& w, const Case& c, Stage stage) {
    w.scene = make_scene(c, stage);
    begin_stage(w.scene, w.state);
    w.work = make_workspace(w.scene, w.state);
}

inline World run_until_travel(Case c) {
    World w = begin(c);
    advance(w, static_cast<std::int64_t>(steps_of_stage(c, Stage::consolidation)));
    // The elastic rim's elements want a shorter step, and less of it has to do.
    if (c.wheel.body == WheelBody::elastic) c.time_step_s = 1.4e-5, c.stages.sinkage_s = 0.06;
    enter(w, c, Stage::sinkage);
    advance(w, static_cast<std::int64_t>(steps_of_stage(c, Stage::sinkage)));
    enter(w, c, Stage::travel);
    advance(w, 1500);
    return w;
}

}  // namespace ifedem::scene

// A wheel that drives over blocks of soil, and the same drive stopped and resumed.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/hash.hpp"
#include "record/checkpoint.hpp"
#include "step/health.hpp"
#include "support/scratch.hpp"
#include "support/soil_scenes.hpp"

namespace ifedem::scene {

inline Case make_drive() {
    Case c;
    c.elements.columns = 10, c.elements.rows = 2;
    c.elements.block_length_m = 0.12, c.elements.block_height_m = 0.08;
    c.elements.first_disc_column = 1, c.elements.disc_columns = 4;
    c.elements.pattern_discs = 440, c.elements.pattern_s = 0.05;
    c.elements.conversion_interval_steps = 500;
    c.bed.length_m = 1.2;
    c.wheel.load_N = 60;
    c.travel.start_x_m = 0.36, c.travel.distance_m = 0.2, c.travel.speed_m_s = 0.4, c.travel.acceleration_time_s = 0.1;
    c.stages.consolidation_s = 0.1, c.stages.sinkage_s = 0.1;
    c.record.energy_interval_s = 0;
    return c;
}

/// The wheel in its place, before its first step of travel.
inline World begin_travel(const Case& c) {
    World w = begin(c);
    advance(w, static_cast<std::int64_t>(steps_of_stage(c, Stage::consolidation)));
    for (const Stage stage : {Stage::sinkage, Stage::travel}) {
        w.scene = make_scene(c, stage);
        begin_stage(w.scene, w.state);
        w.work = make_workspace(w.scene, w.state);
        if (stage == Stage::sinkage) advance(w, static_cast<std::int64_t>(steps_of_stage(c, stage)));
    }
    return w;
}

/// The whole travel; a test fails where its health does.
inline void drive_through(World& w, const Case& c) {
    const auto steps = static_cast<std::int64_t>(steps_of_stage(c, Stage::travel));
    for (std::int64_t n = 0; n < steps; n += 50) {
        advance(w, std::min<std::int64_t>(50, steps - n));
        const auto fault = check_health(w.scene, w.state, w.work);
        ASSERT_FALSE(fault.has_value()) << to_text(*fault);
    }
}

/// A travel that goes on from a state.
inline World take_up(const Case& c, State state) {
    World w;
    w.state = std::move(state);
    w.scene = make_scene(c, Stage::travel);
    w.work = make_workspace(w.scene, w.state);
    return w;
}

/// Expects the bits of `end`, which an uninterrupted drive from `start` has, after a stop at a step and a resume, with
/// two threads.
inline void expect_same_end_after_a_stop(const Case& c, const State& start, std::int64_t stop, const State& end) {
    omp_set_num_threads(2);
    World part = take_up(c, start);
    advance(part, stop);
    const Scratch scratch;
    write_checkpoint(scratch.file("checkpoint.h5"), part.state, c);
    World rest = take_up(c, read_checkpoint(scratch.file("checkpoint.h5")).state);
    advance(rest, static_cast<std::int64_t>(steps_of_stage(c, Stage::travel)) - stop);
    omp_set_num_threads(1);
    EXPECT_EQ(to_hex(hash_state(rest.state)), to_hex(hash_state(end))) << "stopped at step " << stop;
}

}  // namespace ifedem::scene

#include "record/frame.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/error.hpp"

namespace ifedem {

Frame make_frame(const State& state, double time_s, const FrameFields& fields) {
    const std::size_t count = state.discs.disc.size();
    if (state.discs.id.size() != count || fields.disc_speed_m_s.size() != count ||
        fields.disc_pressure_Pa.size() != count) {
        fail_input("a frame has fields of another length than its discs (" + std::to_string(count) +
                   " discs). Give one value a disc?");
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Ids are unique, so the order is the same whatever the algorithm.
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return state.discs.id[a] < state.discs.id[b]; });

    Frame frame;
    frame.time_s = time_s;
    frame.progress = state.progress;
    for (const std::size_t k : order) {
        const Disc& disc = state.discs.disc[k];
        frame.disc_id.push_back(state.discs.id[k]);
        frame.disc_position_m.push_back({disc.x_m, disc.y_m});
        frame.disc_radius_m.push_back(static_cast<float>(disc.radius_m));
        frame.disc_speed_m_s.push_back(fields.disc_speed_m_s[k]);
        frame.disc_pressure_Pa.push_back(fields.disc_pressure_Pa[k]);
    }
    frame.wheel_position_m = state.wheel.position_m;
    frame.hub_position_m = state.wheel.rim.position_m;
    frame.hub_angle_rad = state.wheel.rim.angle_rad;
    return frame;
}

const char* stage_name(Stage stage) {
    switch (stage) {
        case Stage::consolidation:
            return "consolidation";
        case Stage::sinkage:
            return "sinkage";
        case Stage::travel:
            return "travel";
        case Stage::finished:
            return "finished";
    }
    return "unknown";
}

}  // namespace ifedem

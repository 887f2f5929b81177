#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec2.hpp"
#include "model/state.hpp"

namespace ifedem {

/// What a frame shows besides the state.
struct FrameFields {
    std::vector<float> disc_speed_m_s;    ///< list order, as State::discs
    std::vector<float> disc_pressure_Pa;  ///< mean contact stress of each disc (Eq 5.10), compression > 0
};

/// One picture of a run. Discs stand in the order of their ids, so that the same row is the same disc in every frame.
struct Frame {
    double time_s = 0;  ///< from the beginning of the stage
    Progress progress;
    std::vector<std::uint32_t> disc_id;
    std::vector<Vec2> disc_position_m;
    std::vector<float> disc_radius_m;
    std::vector<float> disc_speed_m_s;
    std::vector<float> disc_pressure_Pa;
    std::vector<Vec2> wheel_position_m;  ///< nodes of the mesh; empty while there is no wheel
    Vec2 hub_position_m;
    double hub_angle_rad = 0;  ///< counter-clockwise
};

/// Throws Error(bad_input) if the fields are not as long as the list of discs.
[[nodiscard]] Frame make_frame(const State& state, double time_s, const FrameFields& fields);

/// How long a column of results.h5 is in one frame.
enum class Extent { one, discs, nodes };

/// Calls f(name, unit, extent, member) for every column of results.h5, in a fixed order: the file is made, written and
/// read by loops over it.
template <class Frame_, class F>
void for_each_column(Frame_& frame, F&& f) {
    f("frames/time_s", "s", Extent::one, frame.time_s);
    f("frames/stage", "1", Extent::one, frame.progress.stage);
    f("frames/step", "1", Extent::one, frame.progress.step);
    f("frames/total_steps", "1", Extent::one, frame.progress.total_steps);
    f("discs/id", "1", Extent::discs, frame.disc_id);
    f("discs/position_m", "m", Extent::discs, frame.disc_position_m);
    f("discs/radius_m", "m", Extent::discs, frame.disc_radius_m);
    f("discs/speed_m_s", "m/s", Extent::discs, frame.disc_speed_m_s);
    f("discs/pressure_Pa", "Pa", Extent::discs, frame.disc_pressure_Pa);
    f("wheel/position_m", "m", Extent::nodes, frame.wheel_position_m);
    f("wheel/hub_position_m", "m", Extent::one, frame.hub_position_m);
    f("wheel/hub_angle_rad", "rad", Extent::one, frame.hub_angle_rad);
}

/// The word for a stage in series.csv.
[[nodiscard]] const char* stage_name(Stage stage);

}  // namespace ifedem

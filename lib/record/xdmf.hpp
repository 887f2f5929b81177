#pragma once
#include <span>
#include <string>

#include "record/frame_file.hpp"

namespace ifedem {

/// The text of discs.xdmf: points with radius, speed, pressure and id, one grid a frame; data in results.h5 beside it.
/// Time is that of the whole run, total steps times the step.
[[nodiscard]] std::string make_disc_xdmf(std::span<const FrameInfo> frames, const FrameRoom& room, double time_step_s);

/// The text of wheel.xdmf: quadrilaterals with part numbers, in the frames that have a wheel.
[[nodiscard]] std::string make_wheel_xdmf(std::span<const FrameInfo> frames, const FrameRoom& room, std::size_t quads,
                                          double time_step_s);

}  // namespace ifedem

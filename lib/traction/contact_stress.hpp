#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "coupling/wheel_contact.hpp"
#include "coupling/wheel_model.hpp"
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

// Contact stress by averaging (section 4.2.2): the lower half of the wheel is divided into virtual segments that are
// fixed in angle and travel with the hub; the forces of contacts are summed on them over the steps of a window
// (Eqs 4.1, 4.2) and divided by their area. θ > 0 clockwise from the direction of travel, bottom dead centre at π/2;
// the sums are of forces on the wheel.

/// The block of the averaging window that the hub is in, or nothing: outside the window, or no stress asked for.
/// Makes room for the sums when the hub first enters.
[[nodiscard]] std::optional<std::size_t> enter_stress_block(const RecordCase& record, State& state);

/// Adds this step's contacts to the block's segments, and the wheel's momentum before the step, with a minus, to its
/// balance. Called while the wheel still stands where the contacts were computed.
void add_contacts_to_stress(const RecordCase& record, const WheelModel& model, const WheelWorkspace& work,
                            std::size_t block, State& state);

/// Adds P, T, r_e and the momentum after the step: called when the wheel has been advanced.
void add_control_to_stress(const WheelModel& model, std::size_t block, State& state);

/// Angle in [0, 2π) of a point seen from the hub.
[[nodiscard]] double contact_angle_rad(Vec2 from_hub_m);

/// Means over the window, or over one of its blocks, of what acts on a segment.
struct MeanSegment {
    double angle_rad = 0;  ///< of its centre, (k − 1/2) π/n
    SegmentSum mean;       ///< sums / steps
};
/// The segments of the lower half, then that for the upper half (with angle 3π/2). Empty if there is no step.
[[nodiscard]] std::vector<MeanSegment> mean_segments(const StressState& stress, std::optional<std::size_t> block = {});

/// Sum of blocks.
[[nodiscard]] StressBlock sum_blocks(const StressState& stress, std::optional<std::size_t> block = {});

/// Every sum of `s`, those too that a mean does not show.
void add(SegmentSum& to, const SegmentSum& s);

}  // namespace ifedem

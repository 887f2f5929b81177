#pragma once
#include <array>
#include <optional>
#include <span>

#include "coupling/conversion.hpp"

namespace ifedem {

// The adaptive region, which is not in the text: the soil decides which blocks are discs. An element in front becomes
// discs before the tread comes near it, since tyre and elements do not meet, or when it would leave the elastic range:
// when the friction that its stress needs is what the same discs bear in biaxial compression. The last block of discs
// becomes an element when the tread has left it and it is at rest. The tyre's edges, which the text looks at, are far
// wider than its contact: 0.535 m against 0.2 m.

/// sin φ of the friction that a plane stress (σ_x, σ_y, τ_xy; compression < 0) mobilises: radius over centre of Mohr's
/// circle. Infinite where the mean is no compression, which sand does not bear.
[[nodiscard]] double mobilised_sine(const std::array<double, 3>& stress_Pa);

/// Does the stress at the middle of an element's block need more friction than elements.friction_angle_deg?
[[nodiscard]] bool leaves_elastic_range(const SoilModel& model, const SoilState& soil, std::uint32_t block);

/// Is a point of the tread within four largest radii of a block's surface, above or beside? Between two looks, 500
/// steps, a tread at 0.1 m/s moves less than one.
[[nodiscard]] bool is_tread_near(const SoilModel& model, const DemConstants& k, const State& state, std::uint32_t block,
                                 std::span<const Vec2> tread_m);

/// Would the kinetic energy of a block's discs lift them by less than a thousandth of the largest radius?
[[nodiscard]] bool is_at_rest(const SoilModel& model, const DemConstants& k, const State& state, std::uint32_t block);

/// The next block of the top row to convert by these rules; one block of discs always stays.
[[nodiscard]] std::optional<DueConversion> find_due_adaptive(const SoilModel& model, const DemConstants& k,
                                                             const State& state, std::span<const Vec2> tread_m);

}  // namespace ifedem

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "coupling/soil_elements.hpp"
#include "dem/dem_constants.hpp"
#include "model/state.hpp"

namespace ifedem {

// The discs of a block in the place of an element (section 5.1.2), and the stress that goes over at a conversion
// (elements.stress_handover, beyond the text).

/// A block's corners, counter-clockwise from the lower left.
struct BlockCorners {
    std::array<Vec2, 4> position_m{}, velocity_m_s{};
};

/// Where they are now.
[[nodiscard]] BlockCorners find_corners(const SoilModel& model, const SoilState& soil, std::uint32_t block);

/// Discs of the pattern, flattened by `squash` of their height, in the element's present shape.
[[nodiscard]] std::vector<Disc> place_pattern(const SoilModel& model, const SoilState& soil,
                                              const BlockCorners& corners, double squash);

/// Stress (σ_x, σ_y, τ_xy; compression < 0) at the middle of a block that is an element.
[[nodiscard]] std::array<double, 3> element_stress_Pa(const SoilModel& model, const SoilState& soil,
                                                      std::uint32_t block);

/// Mean stress (σ_x, σ_y, τ_xy; compression < 0) of discs over a volume, Eq 5.10 summed: Σ r F / V over the springs of
/// their contacts with each other and, as far as a disc's own side, with discs that are not among them. Contacts with
/// elements, walls and attached discs are left out: of σ_y of a block of height h, about r/h for each border that is an
/// element, 1 % in chapter 5.
[[nodiscard]] std::array<double, 3> mean_stress_Pa(const DemConstants& k, const State& state,
                                                   const std::vector<std::uint32_t>& positions, double volume_m3);

/// Stress-free shape of an element that stands in `now` under the stress `s`: X = (I + ε)⁻¹ x about the middle.
[[nodiscard]] ElementShape relax(const Material& material, const std::array<Vec2, 4>& now,
                                 const std::array<double, 3>& s);

/// σ_y < 0 that the discs of an element shall have: its own, or a tenth of what its weight gives it where it has less
/// or pulls. Discs cannot pull, and between the sides of a block they keep some stress however far they are lifted (of
/// chapter 5's block: 4 kPa as prepared, 160 Pa after 0.6 % of its height, 11 Pa after 3 %), so that 0 is never met.
[[nodiscard]] double wanted_stress_Pa(const SoilModel& model, const SoilState& soil, std::uint32_t block);

/// How far the pattern must be flattened for its mean σ_y to be `wanted`, by bisection within ±3 %: less or more is
/// not handed over.
[[nodiscard]] double find_squash(const SoilModel& model, const DemConstants& k, const SoilState& soil,
                                 const BlockCorners& corners, double wanted_Pa);

/// Makes the discs as heavy together as `mass_kg`, in proportion to their own masses.
void share_mass(double mass_kg, std::vector<Disc>& discs);

}  // namespace ifedem

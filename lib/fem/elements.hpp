#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fem/mesh.hpp"

namespace ifedem {

/// Of a wheel's part, or of the soil's elements.
using Material = MaterialCase;

[[nodiscard]] inline double quad_area_m2(const std::array<Vec2, 4>& p) { return 0.5 * cross(p[2] - p[0], p[3] - p[1]); }

/// What one corotational element needs in a step, computed once from the reference mesh.
struct Element {
    std::array<std::uint32_t, 4> node{};
    std::array<Vec2, 4> reference_m{};       ///< node positions relative to the element's mean
    std::array<Vec2, 4> gradient_1_m{};      ///< shape-function gradients at the centroid
    std::array<double, 64> stiffness_N_m{};  ///< Kᵉ of Eq 2.5, rows (x0 y0 x1 y1 …), 2 × 2 Gauss
};

/// Elements with lumped nodal mass and damping (c·m of Eq 2.3), in mesh order.
struct ElementSet {
    std::vector<Element> element;
    std::vector<double> element_mass_kg;
    std::vector<double> mass_kg;       ///< per node: Σ mᵉ/4
    std::vector<double> damping_kg_s;  ///< per node: Σ c mᵉ/4
};

/// WR, WI, WS and WL of a wheel, in the order of Part.
[[nodiscard]] std::array<Material, 4> wheel_materials(const WheelCase& wheel);
/// Their widths: Table 4-1 has a rim of 10 mm in a tyre of 170 mm.
[[nodiscard]] std::array<double, 4> wheel_widths_m(const WheelCase& wheel);

/// `material` and `thickness_m` are indexed by Part; those of parts without elements are not looked at.  Throws
/// Error(bad_input) for an element with a non-positive Jacobian.
[[nodiscard]] ElementSet make_elements(const Mesh& mesh, const std::array<Material, 4>& material,
                                       const std::array<double, 4>& thickness_m, PlaneState plane);
/// The same with one thickness for all parts.
[[nodiscard]] ElementSet make_elements(const Mesh& mesh, const std::array<Material, 4>& material, double thickness_m,
                                       PlaneState plane);

/// Stress at the centroid of one quad of these corners, counter-clockwise, whose stress-free shape is `reference_m`.
[[nodiscard]] std::array<double, 3> quad_stress_Pa(const Material& material, PlaneState plane,
                                                   const std::array<Vec2, 4>& reference_m,
                                                   const std::array<Vec2, 4>& corner_m);

/// Adds the internal force −∂U/∂x to `force_N` (one Vec2 a node), U = Σ ½ dᵀ Kᵉ d with d = Rᵀx − X and R the rotation
/// of the centroid gradient. The derivative of R is kept, so that each element's forces balance in force and moment and
/// the work done equals the change of U.
void add_internal_force(const ElementSet& set, std::span<const Vec2> position_m, std::span<Vec2> force_N);

[[nodiscard]] double strain_energy_J(const ElementSet& set, std::span<const Vec2> position_m);

/// Largest stable step of the central difference, 2/ω_max, with ω_max² bounded by the largest element eigenvalue
/// (exact 8 × 8 eigenproblem of Kᵉ and lumped mass), and the element that sets it. Safe, without damping and contacts;
/// the mesh as a whole often bears twice as much, because narrow elements borrow mass from wide neighbours.
struct StableStep {
    double step_s = 0;
    std::uint32_t element = 0;
};
[[nodiscard]] StableStep stable_step(const ElementSet& set);
/// The same over one part of the mesh only; infinite if the part has no elements.
[[nodiscard]] StableStep stable_step(const ElementSet& set, const Mesh& mesh, Part part);

/// First element whose Jacobian is not positive at a corner in the current configuration.
[[nodiscard]] std::optional<std::uint32_t> find_inverted(const ElementSet& set, std::span<const Vec2> position_m);

/// Cauchy stress estimate at the centroid (σx, σy, τxy) in Pa, rotated to global axes.
[[nodiscard]] std::array<double, 3> centroid_stress_Pa(const Element& element, const Material& material,
                                                       PlaneState plane, std::span<const Vec2> position_m);

}  // namespace ifedem

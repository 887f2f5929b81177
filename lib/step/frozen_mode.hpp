#pragma once
#include <cstdint>

#include "step/scene.hpp"

namespace ifedem {

/// What may move while everything else is held.
enum class Movable { discs, wheel, everything };

/// The vibration of a scene, its contacts neither opening nor sliding, that bears the smallest step.
struct FrozenMode {
    double omega_rad_s = 0;  ///< √(uᵀKu / uᵀMu); 0: nothing there is elastic
    /// uᵀCu / (2 ω uᵀMu): more than a pair's ζ, since a dashpot's share grows with ω
    double damping_ratio = 0;
    double highest_rad_s = 0;            ///< ω_max of K alone
    std::uint32_t loudest_disc = 0;      ///< id of the disc that moves most
    std::uint32_t loudest_contacts = 0;  ///< its number of contacts; 0: a part of the wheel is louder
};

/// The step v⁺ = v − Δt M⁻¹ (K x + C v), x⁺ = x + Δt v⁺ is stable while 4 M − 2 Δt C − Δt² K is positive definite, for
/// any symmetric K and C. The mode that fails first is found by power iteration on M⁻¹ (K + 2C/Δt), with Δt from the
/// mode's own K and C until it stays: 2 (√(1+ζ²) − ζ) / ω. Without dashpots this is 2/ω_max.
///
/// Moving: discs (x, y, ω), free nodes of the wheel and its rigid part; walls are held, and soil elements, of which a
/// node has a quarter of a block's mass. K: normal and, where friction lets them hold, tangential springs of all
/// contacts, the elements' Kᵉ in their present rotation (the stress in them is left out: it is small against Kᵉ), and
/// K_p of explicit control loops. C: the dashpots, the nodes' damping, K_d of explicit loops. The Rayleigh quotient
/// rises from below; it is taken where 20 iterations change it by less than 1e-5.
[[nodiscard]] FrozenMode find_failing_mode(const Scene& scene, const State& state, Movable movable);

}  // namespace ifedem

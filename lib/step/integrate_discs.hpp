#pragma once
#include <span>

#include "step/scene.hpp"

namespace ifedem {

// The three integrators of the discs.
//
// Symplectic Euler (default): v += a Δt, x += v Δt; v stands half a step behind x, and the dashpots see that lagged
// velocity.
//
// Modified Euler, Eqs 2.9–2.12: a(t+Δt) depends on x(t+Δt) and, through the dashpots, on v(t+Δt), so both must be
// predicted:
//   x* = x + v Δt + ½ a Δt²,  v* = v + a Δt,   then   v(t+Δt) = v + ½ (a + a*) Δt,  x(t+Δt) = x + ½ (v + v(t+Δt)) Δt.
// One evaluation: a is the a* of the step before. Between steps the state holds the predicted values, since they are
// what the forces need; the correction is x += ¼ (a* − a) Δt², v += ½ (a* − a) Δt. Two evaluations: a is evaluated anew
// from the corrected values; the tangential springs advance in the second one only.

/// The discs of a block under their forces, of which it leaves zeros: the whole step, or for two evaluations the
/// prediction. Notes in the block whether a disc has left its inner skin.
void integrate_discs(const Scene& scene, State& state, const DemWorkspace& work, Block& block,
                     std::span<DiscForce> force);

/// Two evaluations: after the second forces, the correction.
void correct_discs(const Scene& scene, State& state, Block& block, std::span<DiscForce> force);

/// Angular velocity after a step whose other moments alone would give `omega_free`, with rolling resistance (Eq 2.18):
/// as a limit it can stop but never reverse the rotation.
[[nodiscard]] double apply_rolling(RollingScheme rolling, double omega_free_rad_s, double omega_now_rad_s,
                                   double largest_change_rad_s);

}  // namespace ifedem

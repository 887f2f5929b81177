#pragma once
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

/// After the forces of `work`: the whole step, or for two evaluations the prediction.
void integrate_discs(const Scene& scene, State& state, DemWorkspace& work);

/// Two evaluations: after the second forces, the correction.
void correct_discs(const Scene& scene, State& state, const DemWorkspace& work);

}  // namespace ifedem

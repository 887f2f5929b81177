#pragma once
#include "model/case.hpp"

namespace ifedem {

/// Largest ω Δt at which the integrator keeps x'' = −ω² x − 2 ζ ω x' from growing.
///
/// Symplectic Euler (and the central difference with a lagged dashpot, Eq 2.8): 2 (√(1+ζ²) − ζ), exact. Modified Euler
/// (Eqs 2.9–2.12): where the spectral radius of its amplification matrix passes 1 + 10⁻⁶, found by scan and bisection
/// (without damping the form with two evaluations grows at every step, by some (ω Δt)⁴/8; 10⁻⁶ is a factor e in a
/// million steps).
[[nodiscard]] double largest_stable_phase(Integrator integrator, double damping_ratio);

/// Largest |eigenvalue| of one step of x'' = −ω² x − 2 ζ ω x' at phase ω Δt.
[[nodiscard]] double amplification(Integrator integrator, double phase, double damping_ratio);

}  // namespace ifedem

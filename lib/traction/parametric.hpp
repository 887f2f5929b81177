#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace ifedem {

// Tractive performance as integrals of contact stress (section 4.2.3). θ > 0 clockwise from the direction of travel,
// bottom dead centre at π/2; σ > 0 in compression, τ > 0 forward at bottom dead centre.

/// Contact stress between entry and exit; 0 elsewhere.
struct StressField {
    std::function<double(double)> normal_Pa;
    std::function<double(double)> tangential_Pa;
    double entry_rad = 0;
    double exit_rad = 0;
    std::vector<double> kinks_rad;  ///< where a slope jumps: Gauss–Kronrod rules lose their accuracy, and their bound
};

/// What the stress acts on.
struct ContactArc {
    double width_m = 0;
    double radius_m = 0;  ///< undeflected
};

/// A number with the quadrature's bound of its error.
struct Integral {
    double value = 0;
    double error = 0;
};

/// What part of the stress counts as what.
enum class Sharing {
    printed,    ///< Eqs 4.4, 4.5: all of τ to H, all of σ to R
    as_written  ///< section 4.2.3, last paragraph: τ < 0 to R, σ beyond bottom dead centre to H. P_d is the same
};

/// Sign of τ cosθ behind bottom dead centre in W.
enum class VerticalForm {
    balanced,  ///< W = br ∫ (σ sinθ + τ cosθ): the vertical component of the force
    printed    ///< Eq 4.3, whose rear part has − τ cosθ although cosθ < 0 there
};

/// H, R, P_d and W of a stress field. R < 0 against travel: the −R of Eq 4.5.
struct TractiveIntegrals {
    Integral gross_tractive_effort_N;
    Integral motion_resistance_N;
    Integral net_traction_N;
    Integral load_N;
};

/// By GSL's adaptive Gauss–Kronrod rule, to 1e-10 of the largest of the four. Throws Error(bad_input) for an arc
/// without length, width or radius, or if a stress cannot be integrated.
[[nodiscard]] TractiveIntegrals integrate_stress(const StressField& field, const ContactArc& arc,
                                                 Sharing sharing = Sharing::as_written,
                                                 VerticalForm vertical = VerticalForm::balanced);

/// ∫ f dθ over the field's contact, split at bottom dead centre and at the kinks.
[[nodiscard]] Integral integrate_over(const StressField& field, const std::function<double(double)>& f);

/// Cubic spline through points; 0 outside them. Needs three points or more, x ascending.
[[nodiscard]] std::function<double(double)> make_spline(std::span<const double> x, std::span<const double> y);

}  // namespace ifedem

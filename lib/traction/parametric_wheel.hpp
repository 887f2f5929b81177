#pragma once
#include "traction/parametric.hpp"

namespace ifedem {

// The semi-empirical rigid wheel of Wong & Reece (1967), J. Terramechanics 4:81–98: the cheap end of the scale.

/// Pressure under a plate at sinkage z, p = k z^n; k holds whatever the model says of the width (Bekker: k_c/b + k_φ).
struct PressureSinkage {
    double modulus_Pa_mn = 0;  ///< k, in Pa/mⁿ
    double exponent = 0;       ///< n
};

/// Shear stress at shear displacement j, τ = (c + σ tan φ)(1 − e^(−j/K)) (Janosi & Hanamoto 1961).
struct ShearStrength {
    double cohesion_Pa = 0;
    double friction = 0;        ///< tan φ
    double displacement_m = 0;  ///< K; 0: full strength at once
};

/// τ under the normal stress σ at j ≥ 0.
[[nodiscard]] double shear_stress_Pa(const ShearStrength& shear, double normal_Pa, double displacement_m);

/// Angles are measured from bottom dead centre, forwards > 0, as that paper does.
struct ParametricWheel {
    ContactArc arc;
    PressureSinkage pressure;
    ShearStrength shear;
    double c1 = 0, c2 = 0;  ///< place of the greatest pressure: θ_m = (c1 + c2 i) θ_1
    double rear_rad = 0;    ///< θ_2 ≤ 0: where contact ends
};

/// σ and τ of the wheel at slip i and entry angle θ_1, as a field in the convention of parametric.hpp:
///   front: σ = k (r (cosθ − cosθ_1))ⁿ for θ_m ≤ θ ≤ θ_1
///   rear:  σ = k (r (cos θ* − cosθ_1))ⁿ with θ* = θ_1 − (θ − θ_2)/(θ_m − θ_2) (θ_1 − θ_m)
///   j = r [(θ_1 − θ) − (1 − i)(sinθ_1 − sinθ)]; where j < 0, τ < 0.
[[nodiscard]] StressField wheel_stress(const ParametricWheel& wheel, double slip, double entry_rad);

struct ParametricResult {
    double entry_rad = 0;            ///< θ_1
    double greatest_normal_rad = 0;  ///< θ_m
    double sinkage_m = 0;            ///< r (1 − cosθ_1)
    TractiveIntegrals traction;
    double torque_Nm = 0;  ///< b r² ∫ τ dθ
};

/// θ_1 from the load by Brent's method (GSL), then all else. Throws Error(bad_input) if no angle up to 90° carries the
/// load, if a nanometre of sinkage carries more, or if the search comes to no end.
[[nodiscard]] ParametricResult solve_wheel(const ParametricWheel& wheel, double slip, double load_N,
                                           Sharing sharing = Sharing::as_written);

}  // namespace ifedem

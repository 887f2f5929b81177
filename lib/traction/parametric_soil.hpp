#pragma once
#include <span>
#include <vector>

#include "traction/parametric_wheel.hpp"

namespace ifedem {

// Soil parameters of the semi-empirical wheel from plate tests on the same discs.

/// p = k zⁿ through sinkages and pressures, by least squares of log p over log z. Throws Error(bad_input) for fewer
/// than two points, any that is not above 0, or sinkages that are all equal.
[[nodiscard]] PressureSinkage fit_pressure_sinkage(std::span<const double> sinkage_m,
                                                   std::span<const double> pressure_Pa);

/// A plate dragged under constant pressure.
struct ShearTest {
    double normal_Pa = 0;
    std::vector<double> displacement_m;  ///< ascending from 0
    std::vector<double> shear_Pa;
};

/// Strength: mean over the second half of the displacement. K: ∫ (1 − τ/strength) dj over the first half, which is K
/// for Janosi & Hanamoto's curve and blind to the noise of single grains; with a shear that is there at once it is 0.
struct ShearCurve {
    double strength_Pa = 0;
    double displacement_m = 0;
};
[[nodiscard]] ShearCurve read_shear_curve(const ShearTest& test);

/// c and tan φ by the straight line through the strengths (c = 0 and the line through the origin where it would be
/// negative: dry sand does not repel), K the mean of the tests. Throws Error(bad_input) for fewer than two tests, or
/// pressures that are all equal.
[[nodiscard]] ShearStrength fit_shear_strength(std::span<const ShearTest> tests);

}  // namespace ifedem

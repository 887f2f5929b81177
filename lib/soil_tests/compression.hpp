#pragma once
#include <cstdint>
#include <vector>

#include "soil_tests/sample.hpp"

namespace ifedem {

// Biaxial and confined compression of a square of sand between smooth walls, without gravity.

/// The shortest mean that a point of a test's curve is: with longer steps there would be none.
inline constexpr double point_of_a_curve_s = 5e-3;

/// Prepared as the bed is: with the friction of consolidation.
struct SandCell {
    Sample sample;
    double thickness_m = 0;
    double friction = 0;  ///< of the tests; walls have none

    [[nodiscard]] double width_m() const;
    [[nodiscard]] double height_m() const;
    [[nodiscard]] double axial_Pa() const;    ///< mean of bottom and top in the last step
    [[nodiscard]] double lateral_Pa() const;  ///< mean of left and right
};

struct SampleSize {
    std::int64_t discs = 0;
    double consolidation_s = 0;
};

[[nodiscard]] SandCell make_cell(const Case& sand, std::int64_t discs);

/// Isotropic stress by all four walls, without friction.
void consolidate(SandCell& cell, double stress_Pa, double duration_s);

/// How far a wall goes towards the sample in this step so that its stress becomes `wanted_Pa`: a fifth of the way that
/// the springs of its contacts ask for; at 0.05 m/s where hardly anything touches it.
[[nodiscard]] double servo_m(const DemConstants& dem, double thickness_m, double stress_Pa, double wanted_Pa);

/// A biaxial test: bottom and top approach at a constant rate, the sides keep their stress.
struct BiaxialCurve {
    std::vector<double> strain, ratio, volumetric;  ///< axial strain; σ1/σ3; volume lost over the first
    double lateral_Pa = 0;
};
/// On a consolidated cell, at a tenth of strain a second; a point is a mean over 0.05 % of strain.
[[nodiscard]] BiaxialCurve shear(SandCell& cell, double lateral_Pa, double largest_strain);

/// Angles from running means over 0.5 % of strain, at the end over the last fifth; the modulus E50 from the first
/// crossing of half the peak deviator.
struct Strength {
    double peak_deg = 0, end_deg = 0, dilatancy_deg = 0, secant_Pa = 0;
};
[[nodiscard]] Strength read_strength(const BiaxialCurve& curve);

/// asin((σ1/σ3 − 1)/(σ1/σ3 + 1)).
[[nodiscard]] double friction_angle_deg(double stress_ratio);

struct Compression {
    std::vector<double> strain, stress_Pa;
    double start_Pa = 0;
    double lattice_Pa = 0;  ///< (√3/4)(3 K_n + K_s)/t: the triangular lattice of the same springs
    [[nodiscard]] double secant_Pa() const { return (stress_Pa.back() - start_Pa) / strain.back(); }
};
/// Confined compression from `start_Pa` to 3 %: the sides stand, bottom and top approach.
[[nodiscard]] Compression compress(const Case& sand, const SampleSize& size, double start_Pa);

}  // namespace ifedem

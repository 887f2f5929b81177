#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "traction/contact_stress.hpp"
#include "traction/parametric.hpp"

namespace ifedem {

/// How a contact force is taken apart. Radial: at the contact's own angle, which keeps the vector. Surface: by the
/// deformed surface's own normal, as a contact law has it, put on the nominal circle, which turns the vector.
enum class Decomposition { radial, surface };

/// Stress against angle, at the centres of the segments.
struct StressCurve {
    std::vector<double> angle_rad;
    std::vector<double> normal_Pa;
    std::vector<double> tangential_Pa;
};

/// Forces over the area b r Δθ of their segments.
[[nodiscard]] StressCurve make_stress_curve(std::span<const MeanSegment> segments, const ContactArc& arc,
                                            Decomposition decomposition);

/// Weighted mean over neighbours, weights 1 − (Δθ/half_width)² (Epanechnikov), renormalised at the ends.
[[nodiscard]] std::vector<double> smooth(std::span<const double> values, double spacing_rad, double half_width_rad);

/// Shares of the greatest normal stress at which contact is taken to begin and to end.
inline constexpr std::array<double, 3> entry_shares = {0.01, 0.02, 0.05};

/// What section 4.3 reads off the curves. Peaks are those of the smoothed curves, parabola through the three points
/// around them.
struct CurveFeatures {
    std::array<double, 3> entry_rad{}, exit_rad{};  ///< for each of entry_shares
    double greatest_normal_Pa = 0, greatest_normal_rad = 0;
    double greatest_tangential_Pa = 0, greatest_tangential_rad = 0;
    double least_tangential_Pa = 0;
    /// θ'_M/θ'_1 from bottom dead centre, with the entry by 2 % (section 4.3.3).
    [[nodiscard]] double relative_peak() const;
};
[[nodiscard]] CurveFeatures find_features(const StressCurve& curve, double half_width_rad);

/// The curve as splines through the centres of the segments.
[[nodiscard]] StressField make_field(const StressCurve& curve);

/// Features of curves made of blocks drawn with replacement: realisations first, then as many blocks of each as it has.
/// What `replicates` of them scatter by is the uncertainty of the features.
[[nodiscard]] std::vector<CurveFeatures> bootstrap_features(std::span<const StressState> realisations,
                                                            const ContactArc& arc, Decomposition decomposition,
                                                            double half_width_rad, std::size_t replicates,
                                                            Random& random);

}  // namespace ifedem

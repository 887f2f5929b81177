#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "app/surface_profile.hpp"
#include "check/run.hpp"
#include "model/case.hpp"
#include "model/state.hpp"
#include "traction/contact_stress_curve.hpp"

namespace ifedem {

/// One travel: window means of both ways to the tractive performance, and how far they are apart.
struct StressRun {
    std::string name;
    Case c;
    StressState stress;
    SurfaceMeasure surface;
    std::vector<RunValue> values;
    CurveFeatures features;  ///< of the radial decomposition
    // By the controllers: H = T/r_e, P_d = −P, R = P_d − H.
    double gross_tractive_effort_N = 0, net_traction_N = 0, motion_resistance_N = 0;
    // By the integrals over the radial decomposition, as section 4.2.3 says it was done, and as Eqs 4.4, 4.5 print it.
    double integral_H_N = 0, integral_P_N = 0, integral_R_N = 0, printed_H_N = 0, printed_R_N = 0;
    double load_N = 0, load_printed_N = 0;                  ///< Eq 4.3: balanced, printed
    double load_surface_N = 0, load_surface_printed_N = 0;  ///< the same from the surface decomposition
    // Identities, as shares: each would be 0.
    double horizontal = 0;    ///< (∫ − (P_d + inertia)) / W
    double vertical = 0;      ///< (∫ − (W + inertia)) / W
    double torque = 0;        ///< (Σ r τ b r Δθ − (T − inertia)) / T
    double difference_H = 0;  ///< (H − inertia − H_printed − Σ F_t (r/r_e − sinθ)) / W
    double vectors =
        0;  ///< |Σ F less Σ of its parts turned back at the segments' angles| / W: at most half a segment's angle
    double splines = 0;     ///< (spline integrals − sums of segments) / W, the largest of H, P_d, W
    double quadrature = 0;  ///< largest bound of an integral's error / W
};
[[nodiscard]] StressRun analyse_run(const std::string& name, const Case& c, StressState stress,
                                    const SurfaceMeasure& surface, std::vector<RunValue> values);

/// Realisations of one slip.
struct SlipGroup {
    double slip_percent = 0;
    std::vector<StressRun> run;
    StressCurve radial, surface;  ///< means over the realisations
    CurveFeatures features;       ///< of the radial curve
    std::vector<CurveFeatures> replicate;
};
[[nodiscard]] SlipGroup analyse_slip(double slip_percent, std::vector<StressRun> runs);

/// Mean diameter of the discs as an angle on the tread: half the width of the smoothing kernel.
[[nodiscard]] double kernel_half_width_rad(const Case& c);

[[nodiscard]] double mean_of(const SlipGroup& group, double StressRun::*member);

/// 2.5 % and 97.5 % of what the replicates give.
struct Interval {
    double low = 0, high = 0;
};
[[nodiscard]] Interval interval_of(std::vector<double> values);
template <class F>
[[nodiscard]] Interval interval_of(const SlipGroup& group, F&& value) {
    std::vector<double> values;
    for (const CurveFeatures& f : group.replicate) values.push_back(value(f));
    return interval_of(std::move(values));
}

}  // namespace ifedem

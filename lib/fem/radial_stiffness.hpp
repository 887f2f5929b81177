#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "fem/equilibrium.hpp"
#include "model/case.hpp"

namespace ifedem {

struct LoadDeflection {
    double deflection_m = 0;  ///< approach of hub and plane since the first touch
    double load_N = 0;
};

/// The wheel, turned by `phase_deg` and held at its hub against rotation, pressed without inertia on a rigid plane.
/// One row per deflection; these must not decrease. Throws Error(bad_input) for a rigid wheel or when no equilibrium is
/// found. An elastic rim is held at its hub node and, against rotation only, at its uppermost rim node in x.
[[nodiscard]] std::vector<LoadDeflection> press_on_plane(const WheelCase& wheel, std::span<const double> deflection_m,
                                                         double phase_deg,
                                                         PlaneFriction friction = PlaneFriction::none);

/// The pitch of the lug pairs; of a smooth tread a twelfth of a turn, as its mesh has the columns of twelve pairs.
[[nodiscard]] double lug_pitch_deg(const WheelCase& wheel);

/// Secant radial stiffness K_c = W/δ (Eq 3.9, section 3.2.2) over the phases of one lug pitch.
struct RadialStiffness {
    double mean_N_m = 0;
    double smallest_N_m = 0;
    double largest_N_m = 0;
    std::vector<double> phase_N_m;  ///< at phase k of n: turned by k/n of the pitch of lug pairs
};
[[nodiscard]] RadialStiffness find_radial_stiffness(const WheelCase& wheel, double load_N, std::int64_t phases = 8,
                                                    PlaneFriction friction = PlaneFriction::none);

}  // namespace ifedem

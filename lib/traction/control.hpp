#pragma once
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// One degree of freedom under a PID loop, as central difference advances it:
/// m (v⁺ − v)/Δt + c (v⁺ + v)/2 = F + u.
struct ControlledMass {
    double mass = 0;      ///< kg, or kg m²
    double damping = 0;   ///< kg/s: absolute damping (Eq 2.8); 0 if none
    double position = 0;  ///< m, or rad, at the beginning of the step
    double velocity = 0;  ///< half a step earlier
    double force = 0;     ///< everything but the controller
};

/// Velocity half a step later under Eqs 3.2 and 3.3. `target` is the wanted position at the end of the step.
///
/// Explicit: u from the error at the beginning of the step, as the text has it; stable only for Δt < 2 m / K_d.
/// Semi-implicit: u from the error at the end of the step, which is linear in v⁺, so it is solved for; no limit.
/// Prescribed: the target is reached at the end of every step, whatever u that takes (the motion of section 2.4, before
/// there were loops). Updates the loop's memory and its output u.
[[nodiscard]] double advance_controlled(ControlScheme scheme, const GainsCase& gains, const ControlledMass& body,
                                        double target, double step_s, PidState& pid);

/// Speeds that travel asks for: a linear ramp over the acceleration time, then constant (section 3.2.2).
struct TravelTarget {
    double speed_m_s = 0;
    double omega_clockwise_rad_s = 0;
};
[[nodiscard]] TravelTarget travel_target(const TravelCase& travel, const WheelCase& wheel, double time_s);

/// ω = V / (r (1 − i)) with the unloaded radius that the case names (Eq 3.8 with r_e unknown beforehand), or r ω as the
/// case gives it (section 4.2.4: the tyre turns at a constant speed and V follows from the slip). A plate does not
/// turn.
[[nodiscard]] double commanded_omega_rad_s(const TravelCase& travel, const WheelCase& wheel);

}  // namespace ifedem

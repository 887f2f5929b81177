#pragma once
#include <optional>
#include <string>
#include <vector>

#include "step/scene.hpp"

namespace ifedem {

/// What a step that is too large breaks.
enum class LimitGroup { contacts, elements, drawbar_loop, torque_loop, coupling, everything };

/// Beyond a `certain` limit the scene is unstable; below a `safe` one it is stable, and beyond it may still be.
enum class LimitKind { certain, safe };

/// One limit of the time step; infinite where nothing limits.
struct StepLimit {
    std::string name;  ///< "an isolated pair of the smallest discs"
    LimitGroup group = LimitGroup::contacts;
    LimitKind kind = LimitKind::certain;
    double step_s = 0;
    double undamped_step_s = 0;  ///< the same without dashpots
};

/// What follows from the case alone:
/// - contacts: an isolated pair of the smallest discs, normal 2/√(2K_n/m) and rolling against each other 2/√(6K_s/m)
///   (certain); the smallest discs in a triangular lattice, the densest that there is (safe);
/// - elements: 2/ω of the stiffest free element of each part and of the soil (safe) and of the whole wheel at rest
/// (certain);
/// - control, explicit only: K_p Δt² + 2 K_d Δt < 4 m (certain; 2m/K_d for the derivative alone);
/// - coupling: the smallest disc on a node of the tread whose neighbours are held (certain); a disc that goes two radii
///   in a step passes the surface unseen (certain).
/// All with the dashpots' ζ of the mode (largest_stable_phase()).
[[nodiscard]] std::vector<StepLimit> find_case_limits(const Scene& scene);

/// What follows from the contacts that are closed now: the highest mode of the bed, and of bed and wheel together
/// (certain as long as these contacts stay). Empty where there is no contact.
[[nodiscard]] std::vector<StepLimit> find_frozen_limits(const Scene& scene, const State& state);

/// What the control loops act on: the rigid part, or hub node and rim surface.
struct ControlledInertia {
    double mass_kg = 0, inertia_kg_m2 = 0;
};
[[nodiscard]] ControlledInertia controlled_inertia(const WheelModel& wheel);

/// The limit that the step exceeds most, if any, those of parts alone before those of parts together; Among::certain
/// passes over safe ones.
enum class Among { certain, all };
[[nodiscard]] const StepLimit* find_worst(const std::vector<StepLimit>& limits, double step_s, Among among);

/// The worst certain limit that the case's own time_step_s exceeds in any stage, by what follows from the case alone.
[[nodiscard]] std::optional<StepLimit> find_certain_excess(const Case& c);

/// "0.157 of 2.556e-04 s  contacts, certain: an isolated pair of the smallest discs", a line each.
[[nodiscard]] std::string describe_limits(const std::vector<StepLimit>& limits, double step_s);

/// "time_step_s = 0.0005 is 1.96 times the largest stable step of contacts (0.000256 s; the springs do it: an isolated
/// pair of the smallest discs). Lower time_step_s, …?"
[[nodiscard]] std::string explain_excess(const StepLimit& limit, double step_s);

}  // namespace ifedem

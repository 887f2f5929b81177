#pragma once
#include <vector>

#include "coupling/surface_contact.hpp"
#include "coupling/wheel_model.hpp"

namespace ifedem {

using WheelContact = SurfaceContact;

struct WheelWorkspace : SurfaceWorkspace {
    BodyForce damping_on_body;  ///< on the rigid part
    std::vector<Vec2> force_N;  ///< per node: everything
};

/// Contact forces between discs and the wheel's boundary: for the discs in dem.wheel_force (cleared first), for the
/// wheel's nodes in work.contact_force_N. See add_surface_contacts().
void add_wheel_contacts(const DemConstants& k, const WheelModel& model, State& state, DemWorkspace& dem,
                        WheelWorkspace& work, double spring_step_s);

/// Signed distance from a point to the boundary polygon of the wheel, > 0 outside, by brute force (placement, tests).
[[nodiscard]] double distance_to_wheel_m(const WheelModel& model, const WheelState& wheel, Vec2 point_m);

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <vector>

#include "coupling/surface_contact.hpp"
#include "fem/elements.hpp"
#include "fem/mesh.hpp"
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// The wheel as the step needs it; constant during a run.
struct WheelModel {
    WheelMesh mesh;
    Surface surface;  ///< mesh.boundary as segments
    ElementSet elements;
    WheelBody body = WheelBody::rigid_rim;
    DampingFrame damping_frame = DampingFrame::rigid_motion;
    std::vector<std::uint32_t> free_node;  ///< nodes with their own equation of motion (Eq 2.3)
    double body_mass_kg = 0;               ///< the rigid part with the nodes that move with it; 0 for an elastic rim
    double body_inertia_kg_m2 = 0;         ///< about the hub
    double body_damping_1_s = 0;           ///< c of the rigid part
    double load_N = 0;                     ///< W, downwards at the hub; the wheel's own weight is part of it
    double outer_radius_m = 0;             ///< of the lug tips
};

[[nodiscard]] WheelModel make_wheel_model(const WheelCase& wheel);

/// The wheel at rest with its hub at `hub_m`.
[[nodiscard]] WheelState place_wheel(const WheelModel& model, Vec2 hub_m);

/// Linear momentum of the whole wheel.
[[nodiscard]] Vec2 momentum_Ns(const WheelModel& model, const WheelState& wheel);

/// Centre of rotation: hub node or rim centre.
[[nodiscard]] inline Vec2 hub_position(const WheelState& wheel) { return wheel.rim.position_m; }

/// r_e: the least distance from the hub to a node of the contact surface, m (section 3.2.1).
[[nodiscard]] double effective_radius_m(const WheelModel& model, const WheelState& wheel);

/// Force and moment about the hub on the wheel's rigid part.
struct BodyForce {
    Vec2 force_N;
    double moment_Nm = 0;
};

/// Forces −c m (v − v_frame) of Eq 2.3 on the free nodes; those on the rigid part are returned. In the frame of the
/// wheel's own rigid motion they sum to no force and no moment; in the absolute frame the integrator takes them
/// implicitly as Eq 2.8 has it, and nothing is added here.
[[nodiscard]] BodyForce add_damping_forces(const WheelModel& model, const WheelState& wheel,
                                           std::vector<Vec2>& force_N);

/// Velocity of the frame that damping refers to: mean of c m v and of its moment over the free nodes and
/// the rigid part.
struct RigidMotion {
    Vec2 centre_m;
    Vec2 velocity_m_s;
    double omega_rad_s = 0;
};
[[nodiscard]] RigidMotion damping_frame(const WheelModel& model, const WheelState& wheel);

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <vector>

#include "coupling/surface_contact.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Where an attached disc is: Eq 5.6 (on a segment) and 5.8 (on a node).
[[nodiscard]] Vec2 attached_position_m(const SoilState& soil, std::uint32_t number);
[[nodiscard]] Vec2 attached_velocity_m_s(const SoilState& soil, std::uint32_t number);

struct AttachedWorkspace {
    std::vector<SurfaceCandidate> candidate;  ///< disc and attached disc that may touch; sorted by both
    std::vector<Vec2> searched_m;             ///< nodes of the grid at the last search
    std::uint64_t list_at_search = 0;
    bool search = true;
    std::vector<SurfaceContact> contact;  ///< this step's, in order
    std::vector<BoundaryContact> next;    ///< scratch
    std::vector<WheelForce> on_discs;     ///< of this step, sorted by position
};

/// Contacts of free discs with attached ones, by the law between discs with the free disc's mass as the reduced one.
/// The reaction is shared out to the nodes by Eqs 5.4, 5.5 and 5.7 and added to `node_force_N`. Attached discs do not
/// touch each other, nor the elements: they are part of them.
void add_attached_contacts(const ContactConstants& contact, double damping_ratio, const SoilState& soil,
                           const DiscsNearby& nearby, double spring_step_s, std::vector<BoundaryContact>& springs,
                           AttachedWorkspace& work, std::vector<Vec2>& node_force_N);

}  // namespace ifedem

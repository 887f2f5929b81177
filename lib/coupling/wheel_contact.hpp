#pragma once
#include <cstdint>
#include <vector>

#include "coupling/wheel_model.hpp"
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "dem/forces.hpp"

namespace ifedem {

/// A disc and a boundary segment that may touch before the next search.
struct WheelCandidate {
    std::uint32_t position = 0;
    std::uint32_t segment = 0;
};

/// A boundary segment in the current configuration.
struct Segment {
    Vec2 from_m, along_m;  ///< start, end − start
    Vec2 normal;           ///< outward unit normal
    double inverse_length2 = 0;
};

/// One contact of a step: on which disc and where on the wheel, with what it needs for stress and energy.
struct WheelContact {
    std::uint32_t position = 0;      ///< list position of the disc
    std::uint32_t from = 0, to = 0;  ///< nodes of the segment
    double share = 0;                ///< along it
    Vec2 outward;                    ///< normal of the surface there, towards the disc
    double old_spring_m = 0;
    BoundaryForce on_disc;  ///< the wheel takes the opposite force at the disc's foot on the segment
};

struct WheelWorkspace {
    std::vector<WheelCandidate> candidate;  ///< sorted by position, segment
    std::vector<Vec2> searched_m;           ///< boundary nodes at the last search
    std::uint64_t refreshes_at_search = 0;
    bool search = true;
    std::vector<Segment> segment;
    std::vector<Vec2> contact_force_N;  ///< per node: reaction of the soil
    BodyForce damping_on_body;          ///< on the rigid part
    std::vector<Vec2> force_N;          ///< per node: everything
    std::vector<WheelContact> contact;  ///< this step's contacts, in order
    std::vector<BoundaryContact> next;  ///< scratch: next step's springs
    double largest_overlap_share = 0;   ///< overlap / radius of this step's deepest contact
    std::uint32_t deepest_disc = 0;     ///< id
};

/// How far a boundary node may go before the search is repeated. It does not change results: candidates that do not
/// touch add nothing.
inline constexpr double wheel_skin_m = 1e-3;

/// Contact forces between discs and the wheel's boundary (section 2.5): for the discs in dem.wheel_force and, shared by
/// the segment's shape functions, in work.contact_force_N (both cleared first). Advances the tangential springs.
///
/// A disc touches a segment where its centre projects onto it, or the corner that the segment starts from where it
/// projects beyond both neighbours of a convex corner: one contact a corner, owned by one segment, and the force is
/// continuous from segment over corner to segment. At a concave joint flatter than 45° only the deeper contact counts
/// (both would double the stiffness of a nearly straight tread); at a sharper one, such as a lug's root, both do. The
/// spring of a contact that slides on to the neighbouring segment goes with it.
void add_wheel_contacts(const DemConstants& k, const WheelModel& model, State& state, DemWorkspace& dem,
                        WheelWorkspace& work, double spring_step_s);

/// Signed distance from a point to the boundary polygon of the wheel, > 0 outside, by brute force (placement, tests).
[[nodiscard]] double distance_to_wheel_m(const WheelModel& model, const WheelState& wheel, Vec2 point_m);

}  // namespace ifedem

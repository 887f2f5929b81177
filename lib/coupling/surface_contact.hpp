#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "dem/forces.hpp"

namespace ifedem {

/// A straight segment of a body's boundary between two of its nodes, the body on its left, and its neighbours.
struct SurfaceEdge {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t from = 0, to = 0;
    std::uint32_t before = none, after = none;  ///< segments that end and start at its ends
};

/// The boundary of a meshed body as discs meet it: the wheel's closed loop, or the skyline of the soil's elements.
using Surface = std::vector<SurfaceEdge>;

/// The closed loop through `node`, counter-clockwise; segment k runs from node[k] to the next.
[[nodiscard]] Surface make_loop(const std::vector<std::uint32_t>& node);

/// A disc and a boundary segment that may touch before the next search.
struct SurfaceCandidate {
    std::uint32_t position = 0;
    std::uint32_t segment = 0;
};

/// A boundary segment in the current configuration.
struct Segment {
    Vec2 from_m, along_m;  ///< start, end − start
    Vec2 normal;           ///< outward unit normal
    double inverse_length2 = 0;
};

/// One contact of a step: on which disc and where on the body, with what it needs for stress and energy.
struct SurfaceContact {
    std::uint32_t position = 0;      ///< list position of the disc
    std::uint32_t from = 0, to = 0;  ///< nodes of the segment
    double share = 0;                ///< along it
    Vec2 outward;                    ///< normal of the surface there, towards the disc
    double old_spring_m = 0;
    BoundaryForce on_disc;  ///< the body takes the opposite force at the disc's foot on the segment
};

struct SurfaceWorkspace {
    std::vector<SurfaceCandidate> candidate;  ///< sorted by position, segment
    std::vector<Vec2> searched_m;             ///< starts of the segments and the last one's end, at the last search
    std::uint64_t list_at_search = 0;
    bool search = true;
    std::vector<Segment> segment;
    std::vector<Vec2> contact_force_N;    ///< per node: reaction of the discs
    std::vector<SurfaceContact> contact;  ///< this step's contacts, in order
    std::vector<BoundaryContact> next;    ///< scratch: next step's springs
    double largest_overlap_share = 0;     ///< overlap / radius of this step's deepest contact
    std::uint32_t deepest_disc = 0;       ///< id
};

/// How far a boundary node may go before the search is repeated. It does not change results: candidates that do not
/// touch add nothing.
inline constexpr double surface_skin_m = 1e-3;

/// The discs that a surface meets, and the list that bounds how far each may go until the next search.
struct DiscsNearby {
    const DiscState& discs;
    const std::vector<Reference>& reference;  ///< of the list that the search is repeated with
    std::uint64_t list_number = 0;            ///< of that list
    const std::vector<std::uint32_t>& position_of_id;
    double largest_radius_m = 0;
};

/// A body's boundary as it moves.
struct MovingSurface {
    const Surface& edge;
    std::span<const Vec2> position_m, velocity_m_s;  ///< of the body's nodes
};

/// Contact forces between discs and a body's boundary (section 2.5): on the discs appended to `on_discs` in order of
/// position and, shared by the segment's shape functions, in work.contact_force_N (cleared first). Advances the
/// tangential springs.
///
/// A disc touches a segment where its centre projects onto it, or the corner that the segment starts from where it
/// projects beyond both neighbours of a convex corner: one contact a corner, owned by one segment, and the force is
/// continuous from segment over corner to segment. At a concave joint flatter than 45° only the deeper contact counts
/// (both would double the stiffness of a nearly straight tread); at a sharper one, such as a lug's root, both do. The
/// spring of a contact that slides on to the neighbouring segment goes with it.
void add_surface_contacts(const ContactConstants& contact, double damping_ratio, const MovingSurface& surface,
                          const DiscsNearby& nearby, double spring_step_s, std::vector<BoundaryContact>& springs,
                          SurfaceWorkspace& work, std::vector<WheelForce>& on_discs);

/// Where the segments are now.
void place_segments(const MovingSurface& surface, std::vector<Segment>& segments);

/// Where along a segment a point projects: 0 at its start, 1 at its end.
[[nodiscard]] inline double share_along(const Segment& s, Vec2 point) {
    return dot(point - s.from_m, s.along_m) * s.inverse_length2;
}

}  // namespace ifedem

#include "coupling/surface_contact.hpp"

#include <algorithm>
#include <cmath>

namespace ifedem {
namespace {

constexpr double cos_45_degrees = 0.70710678118654752;

/// What a disc meets on one segment.
struct Touch {
    std::uint32_t segment = 0;
    double share = 0;  ///< along the segment; 0 at the corner it starts from
    double distance_m = 0;
    Vec2 outward;  ///< unit, from the body to the disc
};

bool find_touch(const Surface& edge, const std::vector<Segment>& segments, std::uint32_t k, const Disc& d,
                Touch& touch) {
    const Segment& s = segments[k];
    const Vec2 centre{d.x_m, d.y_m};
    const double share = share_along(s, centre);
    if (share > 1) return false;
    const Vec2 p = centre - s.from_m;
    if (share >= 0) {
        const double side = dot(p, s.normal);
        if (side >= d.radius_m || side < -d.radius_m) return false;
        touch = {k, share, side, s.normal};
        return true;
    }
    if (edge[k].before == SurfaceEdge::none) return false;
    const Segment& before = segments[edge[k].before];
    if (share_along(before, centre) <= 1 || dot(p, before.normal + s.normal) <= 0) return false;
    const double distance = norm(p);
    if (distance >= d.radius_m || distance <= 0) return false;
    touch = {k, 0.0, distance, (1.0 / distance) * p};
    return true;
}

bool are_neighbours(const Surface& edge, std::uint32_t a, std::uint32_t b) {
    return edge[a].after == b || edge[b].after == a;
}

/// Drops the shallower of two contacts at a nearly straight concave joint.
void resolve_joints(const Surface& edge, const std::vector<Segment>& segments, std::vector<Touch>& touches) {
    for (std::size_t a = 0; a < touches.size(); ++a) {
        for (std::size_t b = a + 1; b < touches.size();) {
            const Vec2 na = segments[touches[a].segment].normal, nb = segments[touches[b].segment].normal;
            const bool same_joint = are_neighbours(edge, touches[a].segment, touches[b].segment);
            if (!same_joint || dot(na, nb) < cos_45_degrees) {
                ++b;
                continue;
            }
            if (touches[b].distance_m < touches[a].distance_m) touches[a] = touches[b];
            touches.erase(touches.begin() + static_cast<std::ptrdiff_t>(b));
        }
    }
}

/// The old spring of this contact: that of the same segment, else of a neighbouring one that the disc has just left.
double inherited_spring(const Surface& edge, std::span<const BoundaryContact> old, std::uint32_t segment,
                        const std::vector<Touch>& touches) {
    for (const BoundaryContact& o : old)
        if (o.surface == segment) return o.tangential_m;
    for (const BoundaryContact& o : old) {
        if (!are_neighbours(edge, o.surface, segment)) continue;
        const bool still_there =
            std::any_of(touches.begin(), touches.end(), [&](const Touch& t) { return t.segment == o.surface; });
        if (!still_there) return o.tangential_m;
    }
    return 0.0;
}

/// A segment's box with room for what may come near until the next search: four comparisons turn most discs away.
struct Box {
    Vec2 low, high;
    [[nodiscard]] bool holds(Vec2 p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
};

Vec2 end_of(const Segment& s) { return s.from_m + s.along_m; }

Box make_box(const Segment& s, double room_m) {
    const Vec2 to = end_of(s);
    return {{min_of(s.from_m.x, to.x) - room_m, min_of(s.from_m.y, to.y) - room_m},
            {max_of(s.from_m.x, to.x) + room_m, max_of(s.from_m.y, to.y) + room_m}};
}

Box join(const std::vector<Box>& boxes) {
    Box all = boxes.front();
    for (const Box& b : boxes) {
        all.low = {min_of(all.low.x, b.low.x), min_of(all.low.y, b.low.y)};
        all.high = {max_of(all.high.x, b.high.x), max_of(all.high.y, b.high.y)};
    }
    return all;
}

void search_candidates(const DiscsNearby& nearby, SurfaceWorkspace& work) {
    work.candidate.clear();
    work.searched_m.clear();
    std::vector<Box> box;
    for (const Segment& s : work.segment) {
        work.searched_m.push_back(s.from_m);
        box.push_back(make_box(s, nearby.largest_radius_m + surface_skin_m + 2 * largest_skin_m));
    }
    work.list_at_search = nearby.list_number;
    work.search = false;
    if (box.empty()) return;
    work.searched_m.push_back(end_of(work.segment.back()));
    const Box all = join(box);
    const auto& disc = nearby.discs.disc;
    for (std::uint32_t p = 0; p < disc.size(); ++p) {
        const Vec2 centre{disc[p].x_m, disc[p].y_m};
        if (!all.holds(centre)) continue;
        // Until the next list the disc stays within its skin of where it stood when this one was made.
        const double near = disc[p].radius_m + surface_skin_m + 2 * nearby.reference[p].skin_m;
        for (std::uint32_t s = 0; s < work.segment.size(); ++s) {
            if (!box[s].holds(centre)) continue;
            const Segment& g = work.segment[s];
            const double share = min_of(1.0, max_of(0.0, share_along(g, centre)));
            const Vec2 away = centre - (g.from_m + share * g.along_m);
            if (dot(away, away) <= near * near) work.candidate.push_back({p, s});
        }
    }
}

/// With each list, since it says how far discs may go; and when a boundary node has moved by the surface's skin.
bool must_search(const DiscsNearby& nearby, const SurfaceWorkspace& work) {
    if (work.search || work.segment.empty() || work.searched_m.size() != work.segment.size() + 1) return true;
    if (nearby.list_number != work.list_at_search) return true;
    const auto has_moved = [](Vec2 now, Vec2 then) {
        const Vec2 moved = now - then;
        return !(dot(moved, moved) <= surface_skin_m * surface_skin_m);
    };
    for (std::size_t n = 0; n < work.segment.size(); ++n)
        if (has_moved(work.segment[n].from_m, work.searched_m[n])) return true;
    return has_moved(end_of(work.segment.back()), work.searched_m.back());
}

}  // namespace

Surface make_loop(const std::vector<std::uint32_t>& node) {
    Surface loop;
    const auto count = static_cast<std::uint32_t>(node.size());
    for (std::uint32_t k = 0; k < count; ++k)
        loop.push_back({node[k], node[(k + 1) % count], (k + count - 1) % count, (k + 1) % count});
    return loop;
}

void place_segments(const MovingSurface& surface, std::vector<Segment>& segments) {
    segments.resize(surface.edge.size());
    for (std::size_t k = 0; k < segments.size(); ++k) {
        Segment& s = segments[k];
        s.from_m = surface.position_m[surface.edge[k].from];
        s.along_m = surface.position_m[surface.edge[k].to] - s.from_m;
        const double length2 = dot(s.along_m, s.along_m);
        s.inverse_length2 = 1.0 / length2;
        const double inverse_length = 1.0 / std::sqrt(length2);
        s.normal = {s.along_m.y * inverse_length, -s.along_m.x * inverse_length};
    }
}

void add_surface_contacts(const ContactConstants& contact, double damping_ratio, const MovingSurface& surface,
                          const DiscsNearby& nearby, double spring_step_s, std::vector<BoundaryContact>& springs,
                          SurfaceWorkspace& work, std::vector<WheelForce>& on_discs) {
    place_segments(surface, work.segment);
    if (must_search(nearby, work)) search_candidates(nearby, work);
    work.contact_force_N.assign(surface.position_m.size(), Vec2{});
    work.contact.clear();
    work.next.clear();
    work.largest_overlap_share = 0;

    const auto apply = [&](std::uint32_t position, const Touch& touch, double spring) {
        const Disc& d = nearby.discs.disc[position];
        const std::uint32_t id = nearby.discs.id[position];
        const std::uint32_t a = surface.edge[touch.segment].from, b = surface.edge[touch.segment].to;
        const Vec2 surface_velocity =
            (1.0 - touch.share) * surface.velocity_m_s[a] + touch.share * surface.velocity_m_s[b];
        const BoundaryForce f = boundary_force(contact, damping_ratio, d, Vec2{0, 0} - touch.outward, touch.distance_m,
                                               0.0, surface_velocity, spring, spring_step_s);
        on_discs.push_back({position, f.on_disc()});
        work.contact_force_N[a] -= (1.0 - touch.share) * f.force_N;
        work.contact_force_N[b] -= touch.share * f.force_N;
        work.next.push_back({id, touch.segment, f.tangential_spring_m});
        work.contact.push_back({position, a, b, touch.share, touch.outward, spring, f});
        if (f.overlap_m > work.largest_overlap_share * d.radius_m) {
            work.largest_overlap_share = f.overlap_m / d.radius_m;
            work.deepest_disc = id;
        }
    };

    std::vector<Touch> touches;
    std::size_t old_first = 0;
    for (std::size_t n = 0; n < work.candidate.size();) {
        const std::uint32_t position = work.candidate[n].position;
        touches.clear();
        for (; n < work.candidate.size() && work.candidate[n].position == position; ++n) {
            Touch touch;
            if (find_touch(surface.edge, work.segment, work.candidate[n].segment, nearby.discs.disc[position], touch))
                touches.push_back(touch);
        }
        if (touches.empty()) continue;
        resolve_joints(surface.edge, work.segment, touches);
        while (old_first < springs.size() && nearby.position_of_id[springs[old_first].disc] < position) ++old_first;
        std::size_t old_last = old_first;
        while (old_last < springs.size() && springs[old_last].disc == nearby.discs.id[position]) ++old_last;
        const std::span<const BoundaryContact> old(springs.data() + old_first, old_last - old_first);
        for (const Touch& touch : touches)
            apply(position, touch, inherited_spring(surface.edge, old, touch.segment, touches));
        old_first = old_last;
    }
    springs.swap(work.next);
}

}  // namespace ifedem

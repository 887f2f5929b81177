#include "coupling/wheel_contact.hpp"

#include <algorithm>
#include <cmath>

namespace ifedem {
namespace {

constexpr double cos_45_degrees = 0.70710678118654752;

void update_segments(const WheelModel& model, const WheelState& wheel, std::vector<Segment>& segments) {
    const auto& loop = model.mesh.boundary;
    segments.resize(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k) {
        Segment& s = segments[k];
        s.from_m = wheel.position_m[loop[k]];
        s.along_m = wheel.position_m[loop[k + 1 == loop.size() ? 0 : k + 1]] - s.from_m;
        const double length2 = dot(s.along_m, s.along_m);
        s.inverse_length2 = 1.0 / length2;
        const double inverse_length = 1.0 / std::sqrt(length2);
        s.normal = {s.along_m.y * inverse_length, -s.along_m.x * inverse_length};
    }
}

double share_along(const Segment& s, Vec2 point) { return dot(point - s.from_m, s.along_m) * s.inverse_length2; }

/// What a disc meets on one segment.
struct Touch {
    std::uint32_t segment = 0;
    double share = 0;  ///< along the segment; 0 at the corner it starts from
    double distance_m = 0;
    Vec2 outward;  ///< unit, from the wheel to the disc
};

bool find_touch(const std::vector<Segment>& segments, std::uint32_t k, const Disc& d, Touch& touch) {
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
    const Segment& before = segments[k == 0 ? segments.size() - 1 : k - 1];
    if (share_along(before, centre) <= 1 || dot(p, before.normal + s.normal) <= 0) return false;
    const double distance = norm(p);
    if (distance >= d.radius_m || distance <= 0) return false;
    touch = {k, 0.0, distance, (1.0 / distance) * p};
    return true;
}

bool are_neighbours(std::uint32_t a, std::uint32_t b, std::size_t count) {
    return (a + 1) % count == b || (b + 1) % count == a;
}

/// Drops the shallower of two contacts at a nearly straight concave joint.
void resolve_joints(const std::vector<Segment>& segments, std::vector<Touch>& touches) {
    for (std::size_t a = 0; a < touches.size(); ++a) {
        for (std::size_t b = a + 1; b < touches.size();) {
            const Vec2 na = segments[touches[a].segment].normal, nb = segments[touches[b].segment].normal;
            const bool same_joint = are_neighbours(touches[a].segment, touches[b].segment, segments.size());
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
double inherited_spring(const std::vector<BoundaryContact>& old, std::size_t first, std::size_t last,
                        std::uint32_t segment, const std::vector<Touch>& touches, std::size_t count) {
    for (std::size_t n = first; n < last; ++n)
        if (old[n].surface == segment) return old[n].tangential_m;
    for (std::size_t n = first; n < last; ++n) {
        if (!are_neighbours(old[n].surface, segment, count)) continue;
        const bool still_there =
            std::any_of(touches.begin(), touches.end(), [&](const Touch& t) { return t.segment == old[n].surface; });
        if (!still_there) return old[n].tangential_m;
    }
    return 0.0;
}

void search_candidates(const DemConstants& k, const WheelModel& model, const State& state, const DemWorkspace& dem,
                       WheelWorkspace& work) {
    work.candidate.clear();
    const Vec2 hub = hub_position(state.wheel);
    double reach2 = 0;
    work.searched_m.clear();
    for (const std::uint32_t n : model.mesh.boundary) {
        work.searched_m.push_back(state.wheel.position_m[n]);
        const Vec2 r = state.wheel.position_m[n] - hub;
        reach2 = max_of(reach2, dot(r, r));
    }
    const double reach = std::sqrt(reach2) + k.largest_radius_m + wheel_skin_m + 2 * largest_skin_m;
    const auto& disc = state.discs.disc;
    for (std::uint32_t p = 0; p < disc.size(); ++p) {
        const Vec2 centre{disc[p].x_m, disc[p].y_m};
        const Vec2 r = centre - hub;
        if (!(dot(r, r) <= reach * reach)) continue;
        // Until the next refresh the disc stays within its skin of where it stood at the last one.
        const double near = disc[p].radius_m + wheel_skin_m + 2 * state.pairs.inner_reference[p].skin_m;
        for (std::uint32_t s = 0; s < work.segment.size(); ++s) {
            const Segment& g = work.segment[s];
            const double share = min_of(1.0, max_of(0.0, share_along(g, centre)));
            const Vec2 away = centre - (g.from_m + share * g.along_m);
            if (dot(away, away) <= near * near) work.candidate.push_back({p, s});
        }
    }
    work.refreshes_at_search = dem.refreshes;
    work.search = false;
}

/// With each refresh, since it says how far discs may go; and when a boundary node has moved by the wheel's skin.
bool must_search(const WheelModel& model, const State& state, const DemWorkspace& dem, const WheelWorkspace& work) {
    if (work.search || work.searched_m.size() != model.mesh.boundary.size()) return true;
    if (dem.refreshes != work.refreshes_at_search) return true;
    for (std::size_t n = 0; n < work.searched_m.size(); ++n) {
        const Vec2 moved = state.wheel.position_m[model.mesh.boundary[n]] - work.searched_m[n];
        if (!(dot(moved, moved) <= wheel_skin_m * wheel_skin_m)) return true;
    }
    return false;
}

void apply_touch(const DemConstants& k, const WheelModel& model, const WheelState& wheel, std::uint32_t position,
                 const Disc& d, std::uint32_t id, const Touch& touch, double spring, double spring_step_s,
                 DemWorkspace& dem, WheelWorkspace& work) {
    const auto& loop = model.mesh.boundary;
    const std::uint32_t a = loop[touch.segment];
    const std::uint32_t b = loop[touch.segment + 1 == loop.size() ? 0 : touch.segment + 1];
    const Vec2 surface_velocity = (1.0 - touch.share) * wheel.velocity_m_s[a] + touch.share * wheel.velocity_m_s[b];
    const BoundaryForce f = boundary_force(k.wheel, k.damping_ratio, d, Vec2{0, 0} - touch.outward, touch.distance_m,
                                           0.0, surface_velocity, spring, spring_step_s);
    dem.wheel_force.push_back({position, f.on_disc()});
    work.contact_force_N[a] -= (1.0 - touch.share) * f.force_N;
    work.contact_force_N[b] -= touch.share * f.force_N;
    work.next.push_back({id, touch.segment, f.tangential_spring_m});
    work.contact.push_back({position, a, b, touch.share, touch.outward, spring, f});
    if (f.overlap_m > work.largest_overlap_share * d.radius_m) {
        work.largest_overlap_share = f.overlap_m / d.radius_m;
        work.deepest_disc = id;
    }
}

}  // namespace

void add_wheel_contacts(const DemConstants& k, const WheelModel& model, State& state, DemWorkspace& dem,
                        WheelWorkspace& work, double spring_step_s) {
    update_segments(model, state.wheel, work.segment);
    if (must_search(model, state, dem, work)) search_candidates(k, model, state, dem, work);
    work.contact_force_N.assign(state.wheel.position_m.size(), Vec2{});
    work.contact.clear();
    work.next.clear();
    dem.wheel_force.clear();
    work.largest_overlap_share = 0;
    const auto& old = state.wheel_contacts;
    std::vector<Touch> touches;
    std::size_t old_first = 0;
    for (std::size_t n = 0; n < work.candidate.size();) {
        const std::uint32_t position = work.candidate[n].position;
        const Disc& d = state.discs.disc[position];
        touches.clear();
        for (; n < work.candidate.size() && work.candidate[n].position == position; ++n) {
            Touch touch;
            if (find_touch(work.segment, work.candidate[n].segment, d, touch)) touches.push_back(touch);
        }
        if (touches.empty()) continue;
        resolve_joints(work.segment, touches);
        while (old_first < old.size() && dem.position_of_id[old[old_first].disc] < position) ++old_first;
        std::size_t old_last = old_first;
        const std::uint32_t id = state.discs.id[position];
        while (old_last < old.size() && old[old_last].disc == id) ++old_last;
        for (const Touch& touch : touches) {
            const double spring =
                inherited_spring(old, old_first, old_last, touch.segment, touches, work.segment.size());
            apply_touch(k, model, state.wheel, position, d, id, touch, spring, spring_step_s, dem, work);
        }
        old_first = old_last;
    }
    state.wheel_contacts.swap(work.next);
}

double distance_to_wheel_m(const WheelModel& model, const WheelState& wheel, Vec2 point_m) {
    std::vector<Segment> segments;
    update_segments(model, wheel, segments);
    double least2 = 1e300;
    bool inside = false;
    for (const Segment& s : segments) {
        const double share = min_of(1.0, max_of(0.0, share_along(s, point_m)));
        const Vec2 away = point_m - (s.from_m + share * s.along_m);
        least2 = min_of(least2, dot(away, away));
        const Vec2 to = s.from_m + s.along_m;  // even–odd rule: does a ray along +x cross this segment?
        if ((s.from_m.y > point_m.y) != (to.y > point_m.y)) {
            const double x = s.from_m.x + (point_m.y - s.from_m.y) / s.along_m.y * s.along_m.x;
            if (x > point_m.x) inside = !inside;
        }
    }
    return inside ? -std::sqrt(least2) : std::sqrt(least2);
}

}  // namespace ifedem

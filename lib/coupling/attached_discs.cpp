#include "coupling/attached_discs.hpp"

#include <algorithm>
#include <compare>
#include <numeric>

namespace ifedem {
namespace {

bool must_search(const SoilState& soil, const DiscsNearby& nearby, const AttachedWorkspace& work) {
    if (work.search || nearby.list_number != work.list_at_search) return true;
    for (std::size_t n = 0; n < work.searched_m.size(); ++n) {
        const Vec2 moved = soil.position_m[n] - work.searched_m[n];
        if (!(dot(moved, moved) <= surface_skin_m * surface_skin_m)) return true;
    }
    return false;
}

/// By x, ties by number: each disc looks only at the attached ones of its own x.
struct SortedByX {
    std::vector<std::uint32_t> number;
    std::vector<Vec2> position_m;  ///< per number
    double largest_radius_m = 0;
};

SortedByX sort_by_x(const SoilState& soil) {
    SortedByX s;
    s.number.resize(soil.attached.size());
    std::iota(s.number.begin(), s.number.end(), 0U);
    for (const std::uint32_t n : s.number) {
        s.position_m.push_back(attached_position_m(soil, n));
        s.largest_radius_m = max_of(s.largest_radius_m, soil.attached[n].radius_m);
    }
    // An order of all doubles: up to the next health check a node may be nowhere (NaN), which `<` cannot sort.
    std::sort(s.number.begin(), s.number.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto order = std::strong_order(s.position_m[a].x, s.position_m[b].x);
        return order != 0 ? order < 0 : a < b;
    });
    return s;
}

void search_candidates(const SoilState& soil, const DiscsNearby& nearby, AttachedWorkspace& work) {
    work.candidate.clear();
    work.searched_m = soil.position_m;
    work.list_at_search = nearby.list_number;
    work.search = false;
    const SortedByX sorted = sort_by_x(soil);
    const auto left_of = [&](std::uint32_t n, double x) { return sorted.position_m[n].x < x; };
    for (std::uint32_t p = 0; p < nearby.discs.disc.size(); ++p) {
        const Disc& d = nearby.discs.disc[p];
        const double near = d.radius_m + surface_skin_m + 2 * nearby.reference[p].skin_m;
        const double reach = near + sorted.largest_radius_m;
        const std::size_t first = work.candidate.size();
        auto at = std::lower_bound(sorted.number.begin(), sorted.number.end(), d.x_m - reach, left_of);
        for (; at != sorted.number.end() && sorted.position_m[*at].x <= d.x_m + reach; ++at) {
            const Vec2 away = Vec2{d.x_m, d.y_m} - sorted.position_m[*at];
            const double limit = near + soil.attached[*at].radius_m;
            if (dot(away, away) <= limit * limit) work.candidate.push_back({p, *at});
        }
        std::sort(work.candidate.begin() + static_cast<std::ptrdiff_t>(first), work.candidate.end(),
                  [](const SurfaceCandidate& a, const SurfaceCandidate& b) { return a.segment < b.segment; });
    }
}

}  // namespace

Vec2 attached_position_m(const SoilState& soil, std::uint32_t n) {
    const AttachedDisc& a = soil.attached[n];
    return (1.0 - a.share) * soil.position_m[soil.attached_from[n]] + a.share * soil.position_m[soil.attached_to[n]] +
           Vec2{a.offset_x_m, a.offset_y_m};
}

Vec2 attached_velocity_m_s(const SoilState& soil, std::uint32_t n) {
    const AttachedDisc& a = soil.attached[n];
    return (1.0 - a.share) * soil.velocity_m_s[soil.attached_from[n]] +
           a.share * soil.velocity_m_s[soil.attached_to[n]];
}

void add_attached_contacts(const ContactConstants& contact, double damping_ratio, const SoilState& soil,
                           const DiscsNearby& nearby, double spring_step_s, std::vector<BoundaryContact>& springs,
                           AttachedWorkspace& work, std::vector<Vec2>& node_force_N) {
    work.on_discs.clear(), work.contact.clear(), work.next.clear();
    if (must_search(soil, nearby, work)) search_candidates(soil, nearby, work);
    std::size_t old = 0;
    for (const SurfaceCandidate& c : work.candidate) {
        const Disc& d = nearby.discs.disc[c.position];
        const AttachedDisc& a = soil.attached[c.segment];
        const Vec2 to = attached_position_m(soil, c.segment) - Vec2{d.x_m, d.y_m};
        const double sum = d.radius_m + a.radius_m, distance2 = dot(to, to);
        if (distance2 >= sum * sum || distance2 <= 0) continue;
        const double distance = root(distance2);
        while (old < springs.size() &&
               (nearby.position_of_id[springs[old].disc] < c.position ||
                (nearby.position_of_id[springs[old].disc] == c.position && springs[old].surface < c.segment)))
            ++old;
        const std::uint32_t id = nearby.discs.id[c.position];
        const bool known = old < springs.size() && springs[old].disc == id && springs[old].surface == c.segment;
        const double spring = known ? springs[old].tangential_m : 0.0;
        const BoundaryForce f = boundary_force(contact, damping_ratio, d, (1.0 / distance) * to, distance, a.radius_m,
                                               attached_velocity_m_s(soil, c.segment), spring, spring_step_s);
        const std::uint32_t from = soil.attached_from[c.segment], end = soil.attached_to[c.segment];
        work.on_discs.push_back({c.position, f.on_disc()});
        node_force_N[from] -= (1.0 - a.share) * f.force_N;
        node_force_N[end] -= a.share * f.force_N;
        work.next.push_back({id, c.segment, f.tangential_spring_m});
        work.contact.push_back({c.position, from, end, a.share, (-1.0 / distance) * to, spring, f});
    }
    springs.swap(work.next);
}

}  // namespace ifedem

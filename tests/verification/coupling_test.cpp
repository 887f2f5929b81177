// Discs against the wheel's boundary: one contact a corner, continuous forces, balanced shares, springs that travel
// along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "coupling/wheel_contact.hpp"
#include "support/dem_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

constexpr double disc_radius = 0.003, disc_mass = 0.0075;

WheelCase make_rigid_wheel(std::int64_t lug_pairs) {
    WheelCase w;
    w.body = WheelBody::rigid;
    w.lug_pairs = lug_pairs;
    w.gap_columns = 2, w.pitch_columns = 4;  // joints along the tread too
    return w;
}

/// A wheel and discs that the test moves by hand.
World make_wheel_and_discs(const WheelCase& wheel, double friction, const std::vector<Disc>& discs) {
    World w;
    w.scene.stage = Stage::sinkage;
    w.scene.dem = make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, friction), 0.2, 1e-5);
    fit_radii(w.scene.dem, discs);
    w.scene.wheel = make_wheel_model(wheel);
    w.state = make_state(discs);
    w.state.wheel = place_wheel(w.scene.wheel, {0.5, 0.4});
    w.work = make_workspace(w.scene, w.state);
    w.work.dem.keep_forces = true;
    update_lists(w.scene.dem, w.state, w.work.dem);
    return w;
}

/// One evaluation; the search is asked for since discs and nodes have been moved by hand.
void evaluate(World& w, double spring_step_s) {
    w.work.wheel.search = true;
    add_wheel_contacts(w.scene.dem, w.scene.wheel, w.state, w.work.dem, w.work.wheel, spring_step_s);
    evaluate_forces(w, spring_step_s);
}

/// The boundary polygon as it stands.
std::vector<Vec2> outline(const World& w) {
    std::vector<Vec2> points;
    for (const std::uint32_t n : w.scene.wheel.mesh.boundary) points.push_back(w.state.wheel.position_m[n]);
    return points;
}

Vec2 unit(Vec2 a) { return (1 / norm(a)) * a; }
/// Outward of a counter-clockwise outline: to the right of its direction.
Vec2 outward_of(Vec2 direction) { return {direction.y, -direction.x}; }
Vec2 turned(Vec2 a, double angle) {
    return {std::cos(angle) * a.x - std::sin(angle) * a.y, std::sin(angle) * a.x + std::cos(angle) * a.y};
}

/// Corner k of the outline with its two unit directions; turn > 0 where it is convex.
struct Corner {
    Vec2 at, before, after;
    double turn = 0;
};
Corner corner_of(const std::vector<Vec2>& points, std::size_t k) {
    const std::size_t n = points.size();
    Corner c{points[k], unit(points[k] - points[(k + n - 1) % n]), unit(points[(k + 1) % n] - points[k]), 0};
    c.turn = std::atan2(cross(c.before, c.after), dot(c.before, c.after));
    return c;
}

/// Where a disc's centre is after `s` on its way along segment, corner and segment at distance h from the outline; the
/// corner itself is passed between s = 0 and h × turn.
Vec2 place_beside(const Corner& c, double h, double s, Vec2& along) {
    const double arc = h * c.turn;
    if (s < 0) return along = c.before, c.at + h * outward_of(c.before) + s * c.before;
    if (s > arc) return along = c.after, c.at + h * outward_of(c.after) + (s - arc) * c.after;
    along = turned(c.before, s / h);
    return c.at + h * outward_of(along);
}

// ---- Distance -----------------------------------------------------------------------------------------------------

/// Winding number of the outline around a point, by angles.
int winding(const std::vector<Vec2>& points, Vec2 p) {
    double sum = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k] - p, b = points[(k + 1) % points.size()] - p;
        sum += std::atan2(cross(a, b), dot(a, b));
    }
    return static_cast<int>(std::lround(sum / (2 * pi)));
}

/// Least distance to any of many points of the outline, refined by golden section on each segment.
double distance_by_search(const std::vector<Vec2>& points, Vec2 p) {
    double least = 1e300;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 a = points[k], d = points[(k + 1) % points.size()] - a;
        double low = 0, high = 1;
        for (int n = 0; n < 60; ++n) {
            const double third = (high - low) / 3;
            if (norm(p - (a + (low + third) * d)) < norm(p - (a + (high - third) * d))) {
                high -= third;
            } else {
                low += third;
            }
        }
        least = std::fmin(least, norm(p - (a + 0.5 * (low + high) * d)));
    }
    return least;
}

TEST(Distance, agrees_with_search_and_winding_number) {
    Random random{7};
    double worst = 0;
    int inside = 0;
    for (const std::int64_t pairs : {std::int64_t{12}, std::int64_t{0}}) {
        World w = make_wheel_and_discs(make_rigid_wheel(pairs), 0, {make_disc({}, disc_radius, disc_mass)});
        for (Vec2& p : w.state.wheel.position_m)
            p = hub_position(w.state.wheel) + turned(p - hub_position(w.state.wheel), 0.37);
        const std::vector<Vec2> points = outline(w);
        for (int n = 0; n < 1500; ++n) {
            // Half of the points near the lugs, where it is hard.
            const double r = n % 2 == 0 ? 0.2 * random.uniform() : 0.145 + 0.02 * random.uniform();
            const Vec2 p = hub_position(w.state.wheel) + turned({r, 0}, 2 * pi * random.uniform());
            const double got = distance_to_wheel_m(w.scene.wheel, w.state.wheel, p),
                         want = distance_by_search(points, p);
            const bool in = winding(points, p) != 0;
            inside += in ? 1 : 0;
            worst = std::fmax(worst, std::fabs(got - (in ? -want : want)));
        }
    }
    std::printf("distance to the wheel: 3000 points, %d inside, worst difference %.1e m\n", inside, worst);
    EXPECT_GT(inside, 1000);
    EXPECT_LT(inside, 2900);
    EXPECT_LT(worst, 1e-9);  // the search ends at (2/3)^60 of a segment
}

// ---- Corners ------------------------------------------------------------------------------------------------------

TEST(ConvexCorner, is_one_contact_with_a_continuous_force) {
    constexpr double overlap = 1e-4, h = disc_radius - overlap, ds = 2e-6, way = 1e-3;
    int corners = 0;
    double worst_jump = 0, worst_size = 0, sharpest = 0;
    for (const std::int64_t pairs : {std::int64_t{12}, std::int64_t{0}}) {
        World w = make_wheel_and_discs(make_rigid_wheel(pairs), 0, {make_disc({}, disc_radius, disc_mass)});
        const std::vector<Vec2> points = outline(w);
        for (std::size_t k = 0; k < points.size() / 2; ++k) {
            const Corner c = corner_of(points, k);
            if (c.turn <= 0) continue;
            ++corners, sharpest = std::fmax(sharpest, c.turn);
            Vec2 along, last;
            for (double s = -way; s < h * c.turn + way; s += ds) {
                const Vec2 at = place_beside(c, h, s, along);
                w.state.discs.disc[0].x_m = at.x, w.state.discs.disc[0].y_m = at.y;
                evaluate(w, 0);
                ASSERT_EQ(w.work.wheel.contact.size(), 1U) << "corner " << k << ", s " << s;
                const Vec2 f{force_on(w, 0).x_N, force_on(w, 0).y_N},
                    want = stiffness_N_m * overlap * outward_of(along);
                worst_size = std::fmax(worst_size, norm(f - want) / (stiffness_N_m * overlap));
                if (s > -way) worst_jump = std::fmax(worst_jump, norm(f - last) / (stiffness_N_m * overlap) / (ds / h));
                last = f;
            }
        }
    }
    std::printf(
        "%d convex corners up to %.0f degrees: force off by %.1e of K*overlap, largest change %.4f of the turn of the "
        "normal\n",
        corners, sharpest * 180 / pi, worst_size, worst_jump);
    EXPECT_GT(corners, 60);
    EXPECT_GT(sharpest, 1.5);
    EXPECT_LT(worst_size, 1e-9);
    EXPECT_LT(worst_jump, 1.001);  // the force turns with the normal and no faster
}

// A lug's root: tread and flank each push as far as they are entered.
TEST(ConcaveRoot, is_two_contacts) {
    World w = make_wheel_and_discs(make_rigid_wheel(12), 0, {make_disc({}, disc_radius, disc_mass)});
    const std::vector<Vec2> points = outline(w);
    int roots = 0;
    double worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Corner c = corner_of(points, k);
        if (c.turn > -0.8) continue;
        ++roots;
        const Vec2 n1 = outward_of(c.before), n2 = outward_of(c.after);
        for (const double second : {2e-5, 1e-4}) {
            // The point at distances r − overlap from both lines.
            const double d1 = disc_radius - 5e-5, d2 = disc_radius - second, det = cross(n1, n2);
            const Vec2 p = c.at + (1 / det) * Vec2{d1 * n2.y - d2 * n1.y, n1.x * d2 - n2.x * d1};
            w.state.discs.disc[0].x_m = p.x, w.state.discs.disc[0].y_m = p.y;
            evaluate(w, 0);
            ASSERT_EQ(w.work.wheel.contact.size(), 2U) << "root " << k;
            const Vec2 f{force_on(w, 0).x_N, force_on(w, 0).y_N}, want = stiffness_N_m * (5e-5 * n1 + second * n2);
            worst = std::fmax(worst, norm(f - want) / norm(want));
        }
    }
    std::printf("%d roots of lugs: two contacts each, force off by %.1e\n", roots, worst);
    EXPECT_EQ(roots, 48);
    EXPECT_LT(worst, 1e-9);
}

// A dented tread: a disc in a valley flatter than 45° must not be held twice.
TEST(ConcaveJoint, nearly_straight_is_one_contact) {
    WheelCase wheel = make_rigid_wheel(0);
    for (const double dent : {5e-4, 1.5e-3, 3.5e-3}) {
        World w = make_wheel_and_discs(wheel, 0, {make_disc({}, disc_radius, disc_mass)});
        const std::uint32_t node = w.scene.wheel.mesh.boundary[5];
        Vec2& p = w.state.wheel.position_m[node];
        p -= dent * unit(p - hub_position(w.state.wheel));
        const Corner c = corner_of(outline(w), 5);
        ASSERT_LT(c.turn, -0.01);
        const Vec2 bisector = unit(outward_of(c.before) + outward_of(c.after));
        const double overlap = 1e-4, h = (disc_radius - overlap) / std::cos(0.5 * c.turn);
        Vec2 last;
        double largest_change = 0, worst_size = 0;
        for (double s = -1e-3; s <= 1e-3; s += 2e-6) {  // across the valley at a height that follows the deeper side
            const Vec2 across{bisector.y, -bisector.x};
            const double rise = std::fabs(s) * std::tan(0.5 * std::fabs(c.turn));
            const Vec2 at = c.at + (h + rise) * bisector + s * across;
            w.state.discs.disc[0].x_m = at.x, w.state.discs.disc[0].y_m = at.y;
            evaluate(w, 0);
            ASSERT_EQ(w.work.wheel.contact.size(), 1U) << "s " << s;
            const Vec2 f{force_on(w, 0).x_N, force_on(w, 0).y_N};
            worst_size = std::fmax(worst_size, std::fabs(norm(f) / (stiffness_N_m * overlap) - 1));
            if (s > -1e-3) largest_change = std::fmax(largest_change, norm(f - last) / (stiffness_N_m * overlap));
            last = f;
        }
        std::printf(
            "valley of %.1f degrees: one contact, size off by %.1e, direction turns at once by %.4f (2 sin(turn/2) = "
            "%.4f)\n",
            -c.turn * 180 / pi, worst_size, largest_change, 2 * std::sin(0.5 * std::fabs(c.turn)));
        EXPECT_LT(worst_size, 1e-9);
        EXPECT_LT(largest_change,
                  1.001 * 2 * std::sin(0.5 * std::fabs(c.turn)));  // both sides equally deep: only the normal changes
    }
}

// ---- Balance and springs ------------------------------------------------------------------------------------------

// Node forces of the wheel against force and moment on the discs, with friction, spin, moving nodes and all kinds of
// contact.
TEST(Shares, balance_in_force_and_moment) {
    Random random{11};
    const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    std::vector<Disc> discs;
    for (int n = 0; n < 600; ++n) {
        const Vec2 at = Vec2{0.5, 0.4} + turned({between(0.151, 0.162), 0}, 2 * pi * random.uniform());
        discs.push_back(
            make_disc(at, between(0.002, 0.003), 0.005, {between(-1, 1), between(-1, 1)}, between(-300, 300)));
    }
    World w = make_wheel_and_discs(make_rigid_wheel(12), 0.4, discs);
    for (Vec2& v : w.state.wheel.velocity_m_s) v = {between(-1, 1), between(-1, 1)};
    w.scene.dem.soil = make_contact(1, 1, 0);  // disc–disc forces balance anyway; here they would only hide digits
    evaluate(w, 1e-5);
    Vec2 force;
    double moment = 0, size = 0;
    std::size_t rubbing = 0;
    for (const WheelContact& c : w.work.wheel.contact) {
        const Disc& d = w.state.discs.disc[c.position];
        force += c.on_disc.force_N;
        moment += cross(centre_of(d), c.on_disc.force_N) + c.on_disc.turning_N * d.radius_m;
        size += norm(c.on_disc.force_N);
        rubbing += c.on_disc.tangential_N != 0 ? 1 : 0;
    }
    for (std::size_t n = 0; n < w.work.wheel.contact_force_N.size(); ++n) {
        force += w.work.wheel.contact_force_N[n];
        moment += cross(w.state.wheel.position_m[n], w.work.wheel.contact_force_N[n]);
    }
    std::printf("shape functions: %zu contacts (%zu rubbing), unbalanced force %.1e, moment %.1e m of sum |F|\n",
                w.work.wheel.contact.size(), rubbing, norm(force) / size, std::fabs(moment) / size);
    EXPECT_GT(w.work.wheel.contact.size(), 100U);
    EXPECT_GT(rubbing, 50U);
    EXPECT_LT(norm(force) / size, 1e-14);
    EXPECT_LT(std::fabs(moment) / size, 1e-14);
}

// A disc dragged along the outline without turning stretches its spring by its way, joints or not. Friction without
// end.
TEST(Spring, is_carried_across_joints) {
    constexpr double overlap = 1e-4, h = disc_radius - overlap, ds = 2e-6, way = 1e-3, dt = 1e-5;
    int corners = 0;
    double worst = 0;
    for (const std::int64_t pairs : {std::int64_t{12}, std::int64_t{0}}) {
        World w = make_wheel_and_discs(make_rigid_wheel(pairs), 1e9, {make_disc({}, disc_radius, disc_mass)});
        const std::vector<Vec2> points = outline(w);
        for (std::size_t k = 0; k < points.size() / 4; ++k) {
            const Corner c = corner_of(points, k);
            if (c.turn <= 0) continue;
            for (const double direction : {1.0, -1.0}) {  // forwards and backwards over the joint
                ++corners;
                w.state.wheel_contacts.clear();
                const double length = 2 * way + h * c.turn;
                const auto steps = static_cast<int>(length / ds);
                for (int n = 0; n < steps; ++n) {
                    const double s = direction > 0 ? -way + n * ds : way + h * c.turn - n * ds;
                    Vec2 along;
                    const Vec2 at = place_beside(c, h, s, along), v = (direction * ds / dt) * along;
                    Disc& d = w.state.discs.disc[0];
                    d.x_m = at.x, d.y_m = at.y, d.vx_m_s = v.x, d.vy_m_s = v.y;
                    evaluate(w, dt);
                }
                ASSERT_EQ(w.state.wheel_contacts.size(), 1U);
                worst =
                    std::fmax(worst, std::fabs(std::fabs(w.state.wheel_contacts[0].tangential_m) / (steps * ds) - 1));
            }
        }
    }
    std::printf("spring over %d joints: off by %.1e of the way\n", corners, worst);
    EXPECT_GT(corners, 60);
    EXPECT_LT(worst, 1e-9);
}

// Over a nearly straight concave joint too.
TEST(Spring, is_carried_through_a_valley) {
    constexpr double overlap = 1e-4, ds = 2e-6, dt = 1e-5;
    World w = make_wheel_and_discs(make_rigid_wheel(0), 1e9, {make_disc({}, disc_radius, disc_mass)});
    Vec2& p = w.state.wheel.position_m[w.scene.wheel.mesh.boundary[5]];
    p -= 5e-4 * unit(p - hub_position(w.state.wheel));
    const Corner c = corner_of(outline(w), 5);
    ASSERT_LT(c.turn, -0.01);
    const double h = disc_radius - overlap;
    double way = 0;
    // Along the first side to where both are equally deep, then along the second.
    const double half = h * std::tan(0.5 * std::fabs(c.turn));
    for (int n = 0; n < 1000; ++n) {
        const double s = -1e-3 + n * ds;
        const bool first = s < 0;
        const Vec2 along = first ? c.before : c.after;
        const Vec2 at = first ? c.at + h * outward_of(along) + (s - half) * along
                              : c.at + h * outward_of(along) + (s + half) * along;
        Disc& d = w.state.discs.disc[0];
        d.x_m = at.x, d.y_m = at.y, d.vx_m_s = ds / dt * along.x, d.vy_m_s = ds / dt * along.y;
        evaluate(w, dt);
        way += ds;
        ASSERT_EQ(w.state.wheel_contacts.size(), 1U);
    }
    std::printf("spring through a valley of %.1f degrees: off by %.1e of the way\n", -c.turn * 180 / pi,
                std::fabs(w.state.wheel_contacts[0].tangential_m) / way - 1);
    EXPECT_NEAR(std::fabs(w.state.wheel_contacts[0].tangential_m) / way, 1,
                1e-6);  // the step over the joint is oblique
}

// ---- The search in motion -----------------------------------------------------------------------------------------

/// Discs around a wheel, flying at it or at rest.
World make_swarm(double speed_m_s) {
    Case c;
    c.gravity_m_s2 = 0;
    c.wheel.body = WheelBody::rigid;
    c.wheel.load_N = 0;
    c.travel.speed_m_s = 0.5, c.travel.acceleration_time_s = 0, c.travel.slip_percent = 60;
    c.contact.damping_ratio = 0.05;
    World w;
    w.scene = make_scene(c, Stage::travel);
    Random random{13};
    std::vector<Disc> discs;
    const Vec2 hub{0.6, 0.6};
    for (int tries = 0; discs.size() < 500 && tries < 100000; ++tries) {
        const double r = 0.002 + 0.001 * random.uniform();
        const Vec2 at = hub + turned({0.163 + 0.04 * random.uniform(), 0}, 2 * pi * random.uniform());
        if (std::any_of(discs.begin(), discs.end(),
                        [&](const Disc& d) { return norm(centre_of(d) - at) < d.radius_m + r; }))
            continue;
        const Vec2 v = 0.8 * unit(hub - at) + Vec2{2 * random.uniform() - 1, 2 * random.uniform() - 1};
        discs.push_back(make_disc(at, r, 260 * pi * r * r, 0.5 * speed_m_s * v));
    }
    w.state = make_state(discs);
    w.state.wheel = place_wheel(w.scene.wheel, hub);
    begin_stage(w.scene, w.state);
    w.work = make_workspace(w.scene, w.state);
    return w;
}

std::set<std::uint32_t> find_touching(const World& w) {
    std::set<std::uint32_t> ids;
    for (std::size_t p = 0; p < w.state.discs.disc.size(); ++p) {
        const Disc& d = w.state.discs.disc[p];
        if (norm(centre_of(d) - hub_position(w.state.wheel)) > 0.158 + d.radius_m) continue;
        if (distance_to_wheel_m(w.scene.wheel, w.state.wheel, centre_of(d)) < d.radius_m)
            ids.insert(w.state.discs.id[p]);
    }
    return ids;
}

// A spinning, towed wheel among discs: at every step exactly those that overlap the outline are in contact. Where the
// discs rest, only the wheel's own movement can ask for a new search.
TEST(Search, finds_every_touching_disc_while_everything_moves) {
    for (const double speed : {1.0, 0.0}) {
        World w = make_swarm(speed);
        std::size_t touches = 0, twice = 0, at_first_touch = 0;
        for (int n = 0; n < 1500; ++n) {
            const std::set<std::uint32_t> want = find_touching(w);
            std::set<std::uint32_t> got;
            advance(w, 1);
            for (const WheelContact& k : w.work.wheel.contact)
                if (!got.insert(w.state.discs.id[k.position]).second) ++twice;
            ASSERT_EQ(got, want) << "at step " << n;
            if (touches == 0 && !got.empty()) at_first_touch = w.work.dem.refreshes;
            touches += got.size();
        }
        std::printf(
            "search: discs at %.0f m/s: %zu touches (%zu at two sides of a root), %llu rebuilds, %zu refreshes before "
            "the first touch, wheel moved %.1f mm\n",
            speed, touches, twice, static_cast<unsigned long long>(w.work.dem.rebuilds), at_first_touch,
            1e3 * (w.state.wheel.rim.position_m.x - 0.6));
        EXPECT_GT(touches, 1000U);
        EXPECT_LT(twice, touches / 10);
        if (speed == 0) {
            EXPECT_EQ(at_first_touch, 1U);
        }
    }
}

}  // namespace
}  // namespace ifedem

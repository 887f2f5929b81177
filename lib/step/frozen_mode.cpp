#include "step/frozen_mode.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "dem/forces.hpp"
#include "fem/corotation.hpp"

namespace ifedem {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// A closed contact of disc a with disc b, a wall, or the point `share` along the segment of nodes from–to.
struct Spring {
    std::uint32_t a = 0, b = none;
    std::uint32_t from = none, to = none;
    double share = 0;
    Vec2 normal;  ///< from a to the other
    double arm_a_m = 0, arm_b_m = 0;
    double normal_N_m = 0, tangential_N_m = 0;
    double normal_Ns_m = 0, tangential_Ns_m = 0;
};

struct DiscMotion {
    Vec2 at;
    double turn = 0;
};

/// A displacement, velocity or force of all that may move.
struct Motion {
    std::vector<DiscMotion> disc;
    std::vector<Vec2> node;  ///< free nodes; those of the rigid part follow `rim`
    DiscMotion rim;
};

struct Frozen {
    std::vector<Spring> spring;
    std::vector<double> disc_mass_kg, disc_inertia_kg_m2;
    std::vector<double> node_mass_kg;  ///< 0: moves with the rim, or is held
    std::vector<char> on_rim;
    std::vector<Vec2> node_arm_m;  ///< from the rim's centre
    double rim_mass_kg = 0, rim_inertia_kg_m2 = 0;
    std::vector<CorotatedFrame> frame;  ///< of each element that may move
    std::vector<double> node_damping_kg_s;
    GainsCase drawbar, torque;      ///< of explicit loops, else 0
    std::uint32_t hub_node = none;  ///< an elastic rim's
    std::vector<std::uint32_t> rim_surface;
};

Spring make_spring(const ContactConstants& k, double damping_ratio, double mass_kg) {
    Spring s;
    const double damping = dashpot_Ns_m(damping_ratio, k.normal_stiffness_N_m, mass_kg);
    s.normal_N_m = k.normal_stiffness_N_m, s.normal_Ns_m = damping;
    if (k.friction > 0) {
        s.tangential_N_m = k.tangential_stiffness_N_m;
        s.tangential_Ns_m = k.damping_ratio_of_ratios * damping;
    }
    return s;
}

void add_disc_springs(const Scene& scene, const State& state, const std::vector<std::uint32_t>& position_of_id,
                      Frozen& f) {
    const auto& disc = state.discs.disc;
    for (std::size_t n = 0; n < state.pairs.i.size(); ++n) {
        const Disc &a = disc[state.pairs.i[n]], &b = disc[state.pairs.j[n]];
        const Vec2 d{b.x_m - a.x_m, b.y_m - a.y_m};
        const double distance = norm(d), overlap = a.radius_m + b.radius_m - distance;
        if (!(overlap > 0 && distance > 0)) continue;
        Spring s =
            make_spring(scene.dem.soil, scene.dem.damping_ratio, 1 / (a.inverse_mass_1_kg + b.inverse_mass_1_kg));
        s.a = state.pairs.i[n], s.b = state.pairs.j[n];
        s.normal = (1 / distance) * d;
        s.arm_a_m = contact_arm_m(distance, a.radius_m, b.radius_m), s.arm_b_m = distance - s.arm_a_m;
        f.spring.push_back(s);
    }
    for (const BoundaryContact& c : state.wall_contacts) {
        const std::uint32_t p = position_of_id[c.disc];
        const WallSide side = find_wall_side(scene.dem, c.surface, disc[p]);
        if (!(disc[p].radius_m + side.opposite_radius_m > side.distance_m)) continue;
        Spring s = make_spring(scene.dem.wall, scene.dem.damping_ratio, 1 / disc[p].inverse_mass_1_kg);
        s.a = p, s.normal = side.normal;
        s.arm_a_m = contact_arm_m(side.distance_m, disc[p].radius_m, side.opposite_radius_m);
        f.spring.push_back(s);
    }
}

/// A disc that touches a point that is held, or a disc of `opposite_radius_m` there.
void add_held_spring(const Scene& scene, const ContactConstants& k, const State& state, std::uint32_t position,
                     Vec2 point_m, double opposite_radius_m, Frozen& f) {
    const Disc& d = state.discs.disc[position];
    const Vec2 to = point_m - Vec2{d.x_m, d.y_m};
    const double distance = norm(to);
    if (!(distance > 0 && distance < d.radius_m + opposite_radius_m)) return;
    Spring s = make_spring(k, scene.dem.damping_ratio, 1 / d.inverse_mass_1_kg);
    s.a = position, s.normal = (1 / distance) * to;
    s.arm_a_m = contact_arm_m(distance, d.radius_m, opposite_radius_m);
    f.spring.push_back(s);
}

/// Discs on soil elements and on discs attached to them.
void add_soil_springs(const Scene& scene, const State& state, const std::vector<std::uint32_t>& position_of_id,
                      Frozen& f) {
    const SoilState& soil = state.soil;
    SoilWorkspace work;
    attach_soil_workspace(scene.soil, soil, work);
    for (const BoundaryContact& c : soil.contacts) {
        const std::uint32_t p = position_of_id[c.disc];
        const Vec2 start = soil.position_m[work.edge[c.surface].from];
        const Vec2 along = soil.position_m[work.edge[c.surface].to] - start;
        const Vec2 centre{state.discs.disc[p].x_m, state.discs.disc[p].y_m};
        const double share = std::clamp(dot(centre - start, along) / dot(along, along), 0.0, 1.0);
        add_held_spring(scene, scene.soil.contact, state, p, start + share * along, 0, f);
    }
    for (const BoundaryContact& c : soil.attached_contacts)
        add_held_spring(scene, scene.dem.soil, state, position_of_id[c.disc], attached_position_m(soil, c.surface),
                        soil.attached[c.surface].radius_m, f);
}

void add_wheel_springs(const Scene& scene, const State& state, const std::vector<std::uint32_t>& position_of_id,
                       Frozen& f) {
    const auto& loop = scene.wheel.mesh.boundary;
    for (const BoundaryContact& c : state.wheel_contacts) {
        const std::uint32_t p = position_of_id[c.disc];
        const Disc& d = state.discs.disc[p];
        Spring s = make_spring(scene.dem.wheel, scene.dem.damping_ratio, 1 / d.inverse_mass_1_kg);
        s.a = p, s.from = loop[c.surface], s.to = loop[(c.surface + 1) % loop.size()];
        const Vec2 start = state.wheel.position_m[s.from], along = state.wheel.position_m[s.to] - start;
        const Vec2 centre{d.x_m, d.y_m};
        s.share = std::clamp(dot(centre - start, along) / dot(along, along), 0.0, 1.0);
        const Vec2 to_wheel = start + s.share * along - centre;
        const double distance = norm(to_wheel);
        if (!(distance > 0 && distance < d.radius_m)) continue;
        s.normal = (1 / distance) * to_wheel, s.arm_a_m = distance;
        f.spring.push_back(s);
    }
}

void add_wheel(const Scene& scene, const State& state, Frozen& f) {
    const WheelModel& m = scene.wheel;
    f.node_mass_kg.assign(m.mesh.mesh.node_m.size(), 0.0);
    f.on_rim.assign(f.node_mass_kg.size(), 1);
    for (const std::uint32_t n : m.free_node) f.node_mass_kg[n] = m.elements.mass_kg[n], f.on_rim[n] = 0;
    for (const Vec2 at : state.wheel.position_m) f.node_arm_m.push_back(at - state.wheel.rim.position_m);
    f.rim_mass_kg = m.body_mass_kg, f.rim_inertia_kg_m2 = m.body_inertia_kg_m2;
    if (m.damping_frame == DampingFrame::rigid_motion)
        f.node_damping_kg_s = m.elements.damping_kg_s;
    else
        f.node_damping_kg_s.assign(f.node_mass_kg.size(), 0.0);  // Eq 2.8 takes it implicitly: no limit
    if (scene.c.control.scheme == ControlScheme::explicit_)
        f.drawbar = scene.c.control.drawbar, f.torque = scene.c.control.torque;
    if (m.body == WheelBody::elastic) f.hub_node = m.mesh.hub, f.rim_surface = m.mesh.rim_surface;
    if (m.free_node.empty()) return;
    for (const Element& e : m.elements.element) f.frame.push_back(find_frame(e, corners(e, state.wheel.position_m)));
}

Frozen freeze(const Scene& scene, const State& state, Movable movable) {
    Frozen f;
    std::vector<std::uint32_t> position_of_id(state.discs.id.size());
    for (std::uint32_t p = 0; p < position_of_id.size(); ++p) position_of_id[state.discs.id[p]] = p;
    if (movable != Movable::wheel) {
        for (const Disc& d : state.discs.disc) {
            f.disc_mass_kg.push_back(1 / d.inverse_mass_1_kg);
            f.disc_inertia_kg_m2.push_back(0.5 * d.radius_m * d.radius_m / d.inverse_mass_1_kg);
        }
        add_disc_springs(scene, state, position_of_id, f);
        if (scene.has_soil_elements()) add_soil_springs(scene, state, position_of_id, f);
    }
    if (movable == Movable::discs || !scene.has_wheel()) return f;
    add_wheel(scene, state, f);
    if (movable == Movable::everything) add_wheel_springs(scene, state, position_of_id, f);
    return f;
}

Vec2 node_motion(const Frozen& f, const Motion& u, std::uint32_t n) {
    return f.on_rim[n] == 0 ? u.node[n] : u.rim.at + cross(u.rim.turn, f.node_arm_m[n]);
}

void add_to_node(const Frozen& f, Motion& force, std::uint32_t n, Vec2 value) {
    if (f.on_rim[n] == 0) {
        force.node[n] += value;
        return;
    }
    force.rim.at += value;
    force.rim.turn += cross(f.node_arm_m[n], value);
}

/// How much a contact closes and slides under a motion.
struct Relative {
    double closing = 0, sliding = 0;
};
Relative relative_motion(const Frozen& f, const Spring& s, const Motion& u) {
    Vec2 d = u.disc[s.a].at;
    double turn = u.disc[s.a].turn * s.arm_a_m;
    if (s.b != none) d -= u.disc[s.b].at, turn += u.disc[s.b].turn * s.arm_b_m;
    if (s.from != none) d -= (1 - s.share) * node_motion(f, u, s.from) + s.share * node_motion(f, u, s.to);
    return {dot(d, s.normal), cross(s.normal, d) + turn};
}

/// K and C are added as stiffness · K + damping · C.
struct Weights {
    double stiffness = 1, damping = 0;
};

void add_spring_force(const Frozen& f, const Spring& s, Weights w, const Motion& u, Motion& force) {
    const Relative r = relative_motion(f, s, u);
    const double fn = (w.stiffness * s.normal_N_m + w.damping * s.normal_Ns_m) * r.closing;
    const double ft = (w.stiffness * s.tangential_N_m + w.damping * s.tangential_Ns_m) * r.sliding;
    const Vec2 on_a = fn * s.normal + ft * Vec2{-s.normal.y, s.normal.x};
    force.disc[s.a].at += on_a, force.disc[s.a].turn += ft * s.arm_a_m;
    if (s.b != none) force.disc[s.b].at -= on_a, force.disc[s.b].turn += ft * s.arm_b_m;
    if (s.from == none) return;
    add_to_node(f, force, s.from, -(1 - s.share) * on_a);
    add_to_node(f, force, s.to, -s.share * on_a);
}

void add_element_force(const Frozen& f, const Element& e, const CorotatedFrame& frame, double weight, const Motion& u,
                       Motion& force) {
    std::array<double, 8> d{};
    for (std::size_t a = 0; a < 4; ++a) {
        const Vec2 v = node_motion(f, u, e.node[a]);
        d[2 * a] = weight * (frame.c * v.x + frame.s * v.y);
        d[2 * a + 1] = weight * (frame.c * v.y - frame.s * v.x);
    }
    const std::array<double, 8> g = multiply_stiffness(e, d);
    for (std::size_t a = 0; a < 4; ++a)
        add_to_node(f, force, e.node[a],
                    {frame.c * g[2 * a] - frame.s * g[2 * a + 1], frame.s * g[2 * a] + frame.c * g[2 * a + 1]});
}

Motion make_motion(const Frozen& f) {
    Motion u;
    u.disc.resize(f.disc_mass_kg.size());
    u.node.resize(f.node_mass_kg.size());
    return u;
}

/// Mean rotation of the rim's surface about the hub: what T of an elastic rim is measured by and acts on.
double mean_turn(const Frozen& f, const Motion& u) {
    double sum = 0;
    for (const std::uint32_t n : f.rim_surface)
        sum += cross(f.node_arm_m[n], u.node[n] - u.node[f.hub_node]) / dot(f.node_arm_m[n], f.node_arm_m[n]);
    return sum / static_cast<double>(f.rim_surface.size());
}

void add_control_force(const Frozen& f, Weights w, const Motion& u, Motion& force) {
    const double px = w.stiffness * f.drawbar.proportional + w.damping * f.drawbar.derivative;
    const double pt = w.stiffness * f.torque.proportional + w.damping * f.torque.derivative;
    if (px == 0 && pt == 0) return;
    if (f.hub_node == none) {
        force.rim.at.x += px * u.rim.at.x;
        force.rim.turn += pt * u.rim.turn;
        return;
    }
    force.node[f.hub_node].x += px * u.node[f.hub_node].x;
    const double share = pt * mean_turn(f, u) / static_cast<double>(f.rim_surface.size());
    for (const std::uint32_t n : f.rim_surface) {
        const Vec2 r = f.node_arm_m[n];
        force.node[n] += share / dot(r, r) * Vec2{-r.y, r.x};
    }
}

Motion multiply(const Scene& scene, const Frozen& f, Weights w, const Motion& u) {
    Motion force = make_motion(f);
    for (const Spring& s : f.spring) add_spring_force(f, s, w, u, force);
    if (w.stiffness > 0)
        for (std::size_t k = 0; k < f.frame.size(); ++k)
            add_element_force(f, scene.wheel.elements.element[k], f.frame[k], w.stiffness, u, force);
    for (std::uint32_t n = 0; n < f.node_damping_kg_s.size(); ++n)
        if (f.on_rim[n] == 0) force.node[n] += w.damping * f.node_damping_kg_s[n] * u.node[n];
    if (!f.node_mass_kg.empty()) add_control_force(f, w, u, force);
    return force;
}

/// Calls visit(mass, component of a, component of b) for every degree of freedom.
template <class A, class B, class Visit>
void visit_components(const Frozen& f, A& a, B& b, Visit&& visit) {
    for (std::size_t p = 0; p < f.disc_mass_kg.size(); ++p) {
        visit(f.disc_mass_kg[p], a.disc[p].at.x, b.disc[p].at.x);
        visit(f.disc_mass_kg[p], a.disc[p].at.y, b.disc[p].at.y);
        visit(f.disc_inertia_kg_m2[p], a.disc[p].turn, b.disc[p].turn);
    }
    for (std::size_t n = 0; n < f.node_mass_kg.size(); ++n) {
        if (f.on_rim[n] != 0) continue;
        visit(f.node_mass_kg[n], a.node[n].x, b.node[n].x);
        visit(f.node_mass_kg[n], a.node[n].y, b.node[n].y);
    }
    if (f.rim_mass_kg <= 0) return;
    visit(f.rim_mass_kg, a.rim.at.x, b.rim.at.x);
    visit(f.rim_mass_kg, a.rim.at.y, b.rim.at.y);
    visit(f.rim_inertia_kg_m2, a.rim.turn, b.rim.turn);
}

/// aᵀMb of a motion with itself, or aᵀf of a motion with a force.
enum class With { mass, force };
double product(const Frozen& f, const Motion& a, const Motion& b, With with) {
    double sum = 0;
    visit_components(f, a, b,
                     [&](double mass, double x, double y) { sum += (with == With::mass ? mass : 1.0) * x * y; });
    return sum;
}

/// Power iteration on M⁻¹ (K + damping · C), beginning with u and ending in it.
void iterate(const Scene& scene, const Frozen& f, Weights w, Motion& u) {
    constexpr int stride = 20, most = 4000;
    constexpr double enough = 1e-5;
    double old = 0;
    for (int n = 1; n <= most; ++n) {
        Motion next = multiply(scene, f, w, u);
        const double inertia = product(f, u, u, With::mass), value = product(f, u, next, With::force) / inertia;
        if (n % stride == 0) {
            if (value - old <= enough * value) return;
            old = value;
        }
        if (!(value > 0)) return;
        const double scale = 1 / (value * std::sqrt(inertia));
        visit_components(f, next, next, [&](double mass, double& a, double&) { a *= scale / mass; });
        u = std::move(next);
    }
}

void find_loudest(const State& state, const Frozen& f, const Motion& u, FrozenMode& mode) {
    double most = 0;
    std::uint32_t at = none;
    const auto energy = [&](std::uint32_t p) {
        const DiscMotion& m = u.disc[p];
        return f.disc_mass_kg[p] * dot(m.at, m.at) + f.disc_inertia_kg_m2[p] * m.turn * m.turn;
    };
    for (std::uint32_t p = 0; p < u.disc.size(); ++p)
        if (energy(p) > most) most = energy(p), at = p;
    for (std::uint32_t n = 0; n < u.node.size(); ++n)
        if (f.on_rim[n] == 0 && f.node_mass_kg[n] * dot(u.node[n], u.node[n]) > most) return;
    if (at == none) return;
    mode.loudest_disc = state.discs.id[at];
    for (const Spring& s : f.spring) mode.loudest_contacts += s.a == at || s.b == at ? 1 : 0;
}

}  // namespace

FrozenMode find_failing_mode(const Scene& scene, const State& state, Movable movable) {
    const Frozen f = freeze(scene, state, movable);
    FrozenMode mode;
    if (f.spring.empty() && f.frame.empty() && f.node_mass_kg.empty()) return mode;
    Motion u = make_motion(f);
    Random random{1};
    visit_components(f, u, u, [&](double mass, double& a, double&) { a = (random.uniform() - 0.5) / std::sqrt(mass); });
    const Motion noise = u;
    Weights w;
    double step_s = 0;
    constexpr int most = 12;
    for (int n = 0; n < most; ++n) {
        // The mode of K alone may have no part in what the dashpots drive, and the iteration would never leave it.
        const double part = 0.5 * std::sqrt(product(f, u, u, With::mass) / product(f, noise, noise, With::mass));
        visit_components(f, u, noise, [&](double, double& a, double b) { a += part * b; });
        iterate(scene, f, w, u);
        const double inertia = product(f, u, u, With::mass);
        const double k = product(f, u, multiply(scene, f, {1, 0}, u), With::force) / inertia;
        const double c = product(f, u, multiply(scene, f, {0, 1}, u), With::force) / inertia;
        if (!(k > 0)) return mode;
        mode.omega_rad_s = std::sqrt(k);
        if (n == 0) mode.highest_rad_s = mode.omega_rad_s;
        mode.damping_ratio = 0.5 * c / mode.omega_rad_s;
        const double before = step_s;
        step_s = (std::sqrt(c * c + 4 * k) - c) / k;
        if (std::fabs(step_s - before) <= 3e-3 * step_s) break;
        w.damping = 2 / step_s;
    }
    find_loudest(state, f, u, mode);
    return mode;
}

}  // namespace ifedem

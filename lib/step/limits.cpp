#include "step/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/bitmath.hpp"
#include "step/frozen_mode.hpp"
#include "step/stable_phase.hpp"
#include "traction/control.hpp"

namespace ifedem {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The limit of a mode of frequency ω whose dashpots have the ratio ζ.
StepLimit mode_limit(std::string name, LimitGroup group, LimitKind kind, Integrator integrator, double omega_rad_s,
                     double damping_ratio) {
    StepLimit limit{std::move(name), group, kind, unlimited, unlimited};
    if (!(omega_rad_s > 0)) return limit;
    limit.step_s = largest_stable_phase(integrator, damping_ratio) / omega_rad_s;
    limit.undamped_step_s = largest_stable_phase(integrator, 0) / omega_rad_s;
    return limit;
}

StepLimit frozen_limit(std::string name, LimitGroup group, Integrator integrator, const FrozenMode& mode) {
    StepLimit limit =
        mode_limit(std::move(name), group, LimitKind::certain, integrator, mode.omega_rad_s, mode.damping_ratio);
    if (mode.highest_rad_s > 0) limit.undamped_step_s = largest_stable_phase(integrator, 0) / mode.highest_rad_s;
    return limit;
}

double smallest_disc_mass_kg(const Scene& scene) {
    const double r = scene.dem.smallest_radius_m;
    return pi * r * r * scene.c.soil.thickness_m * scene.c.soil.density_kg_m3;
}

void add_contact_limits(const Scene& scene, std::vector<StepLimit>& limits) {
    const ContactConstants& k = scene.dem.soil;
    const double m = smallest_disc_mass_kg(scene), zeta = scene.dem.damping_ratio;
    const double kn = k.normal_stiffness_N_m, ks = k.friction > 0 ? k.tangential_stiffness_N_m : 0.0;
    const Integrator integrator = scene.c.integrator;
    // Both dashpots have C = 2ζ√(K m/2); relative to a mode of frequency ω that a spring K drives, ζ ω √(m/2K).
    const double pair = std::sqrt(2 * kn / m);
    limits.push_back(mode_limit("an isolated pair of the smallest discs", LimitGroup::contacts, LimitKind::certain,
                                integrator, pair, zeta));
    const double rolling = std::sqrt(6 * ks / m);
    if (ks > 0)
        limits.push_back(mode_limit("an isolated pair of the smallest discs, turning against each other",
                                    LimitGroup::contacts, LimitKind::certain, integrator, rolling,
                                    zeta * std::sqrt(3.0)));
    // Triangular lattice: edge of the zone, every second row against the others, ω² = (6K_n + 2K_s)/m; or all discs
    // turning alike, ω² = 24K_s/m.
    const double rows = std::sqrt((6 * kn + 2 * ks) / m), turning = std::sqrt(24 * ks / m);
    const double damping = zeta * std::sqrt(2 * kn * m);  // C_n of a pair
    const double damping_s = ks > 0 ? k.damping_ratio_of_ratios * damping : 0.0;
    StepLimit dense = mode_limit("the smallest discs in a triangular lattice", LimitGroup::contacts, LimitKind::safe,
                                 integrator, rows, (6 * damping + 2 * damping_s) / (2 * m * rows));
    if (turning > 0) {
        const StepLimit other =
            mode_limit(dense.name, dense.group, dense.kind, integrator, turning, 24 * damping_s / (2 * m * turning));
        if (other.step_s < dense.step_s) dense = other;
    }
    limits.push_back(dense);
}

/// The wheel at rest, as begin_stage() places it.
State wheel_at_rest(const Scene& scene) {
    State state;
    state.wheel = place_wheel(scene.wheel, {0, 0});
    return state;
}

void add_element_limits(const Scene& scene, std::vector<StepLimit>& limits) {
    if (scene.wheel.free_node.empty()) return;
    constexpr std::array<std::string_view, 4> name{"rim", "intermediate layer", "surface layer", "lugs"};
    for (std::size_t p = 0; p < name.size(); ++p) {
        const StableStep s = stable_step(scene.wheel.elements, scene.wheel.mesh.mesh, static_cast<Part>(p));
        limits.push_back({fmt::format("the stiffest element of the {}, alone", name[p]), LimitGroup::elements,
                          LimitKind::safe, s.step_s, s.step_s});
    }
    Scene without_loops = scene;
    without_loops.c.control.scheme = ControlScheme::semi_implicit;
    const FrozenMode mode = find_failing_mode(without_loops, wheel_at_rest(scene), Movable::wheel);
    limits.push_back(frozen_limit("the whole wheel", LimitGroup::elements, Integrator::symplectic_euler, mode));
}

/// Explicit PID of a mass: with e = −x the step is v⁺ = v − (K_d v + K_p x) Δt/m, stable for K_p Δt² + 2 K_d Δt < 4 m.
double explicit_limit_s(const GainsCase& gains, double mass) {
    const double p = gains.proportional, d = gains.derivative;
    if (!(p > 0)) return d > 0 ? 2 * mass / d : unlimited;
    return (std::sqrt(d * d + 4 * p * mass) - d) / p;
}

void add_control_limits(const Scene& scene, std::vector<StepLimit>& limits) {
    if (scene.c.control.scheme != ControlScheme::explicit_) return;
    const ControlledInertia body = controlled_inertia(scene.wheel);
    const double drawbar = explicit_limit_s(scene.c.control.drawbar, body.mass_kg);
    const double torque = explicit_limit_s(scene.c.control.torque, body.inertia_kg_m2);
    limits.push_back(
        {"the explicit drawbar loop on its mass", LimitGroup::drawbar_loop, LimitKind::certain, drawbar, drawbar});
    limits.push_back(
        {"the explicit torque loop on its inertia", LimitGroup::torque_loop, LimitKind::certain, torque, torque});
}

/// Largest sum of the elements' diagonal blocks at each node: its stiffness with all neighbours held, N/m.
std::vector<double> held_stiffness_N_m(const WheelModel& wheel) {
    std::vector<std::array<double, 3>> block(wheel.mesh.mesh.node_m.size());  // xx, xy, yy
    for (const Element& e : wheel.elements.element)
        for (std::size_t a = 0; a < 4; ++a) {
            block[e.node[a]][0] += e.stiffness_N_m[8 * (2 * a) + 2 * a];
            block[e.node[a]][1] += e.stiffness_N_m[8 * (2 * a) + 2 * a + 1];
            block[e.node[a]][2] += e.stiffness_N_m[8 * (2 * a + 1) + 2 * a + 1];
        }
    std::vector<double> largest;
    for (const auto& [xx, xy, yy] : block)
        largest.push_back(0.5 * (xx + yy) + std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy));
    return largest;
}

void add_coupling_limits(const Scene& scene, std::vector<StepLimit>& limits) {
    const WheelModel& wheel = scene.wheel;
    const double k = scene.dem.wheel.normal_stiffness_N_m, m = smallest_disc_mass_kg(scene);
    const double damping = dashpot_Ns_m(scene.dem.damping_ratio, k, m);
    const std::vector<double> held = held_stiffness_N_m(wheel);
    double omega2 = k / m, zeta = scene.dem.damping_ratio;  // on a rigid surface
    for (const std::uint32_t n : wheel.mesh.boundary) {
        if (!std::binary_search(wheel.free_node.begin(), wheel.free_node.end(), n)) continue;
        const double node_mass = wheel.elements.mass_kg[n];
        // Node against disc: [k_n + k, −k; −k, k] over the masses.
        const double a = (held[n] + k) / node_mass, b = k / m, c2 = k * k / (node_mass * m);
        const double here = 0.5 * (a + b) + std::sqrt(0.25 * (a - b) * (a - b) + c2);
        if (here <= omega2) continue;
        omega2 = here;
        const double disc = -std::sqrt(c2) / std::sqrt((here - b) * (here - b) + c2);  // unit mode, mass-scaled
        const double node = std::sqrt(1 - disc * disc);
        const double closing = node / std::sqrt(node_mass) - disc / std::sqrt(m);
        zeta = damping * closing * closing / (2 * std::sqrt(here));
    }
    limits.push_back(mode_limit("the smallest disc on a node of the tread", LimitGroup::coupling, LimitKind::certain,
                                Integrator::symplectic_euler, std::sqrt(omega2), zeta));
    if (scene.stage != Stage::travel) return;
    const double fastest = travel_speed_m_s(scene.c.travel) +
                           wheel.outer_radius_m * std::fabs(commanded_omega_rad_s(scene.c.travel, scene.c.wheel));
    const double passes = 2 * scene.dem.smallest_radius_m / fastest;
    limits.push_back({"the smallest disc going its diameter, through the tread unseen", LimitGroup::coupling,
                      LimitKind::certain, passes, passes});
}

std::string_view group_name(LimitGroup group) {
    constexpr std::array<std::string_view, 6> name{"contacts",    "elements", "drawbar loop",
                                                   "torque loop", "coupling", "bed and wheel"};
    return name[static_cast<std::size_t>(group)];
}

std::string_view remedy_of(LimitGroup group) {
    switch (group) {
        case LimitGroup::contacts:
            return "Lower time_step_s, contact.damping_ratio or contact.normal_stiffness_N_m";
        case LimitGroup::elements:
            return "Lower time_step_s, coarsen the wheel's mesh, or make the stiff part rigid (wheel.body)";
        case LimitGroup::drawbar_loop:
        case LimitGroup::torque_loop:
            return "Use control.scheme = \"semi-implicit\", or lower time_step_s or the derivative gain";
        case LimitGroup::coupling:
        case LimitGroup::everything:
            return "Lower time_step_s or contact.normal_stiffness_N_m";
    }
    return "";
}

}  // namespace

ControlledInertia controlled_inertia(const WheelModel& wheel) {
    if (wheel.body != WheelBody::elastic) return {wheel.body_mass_kg, wheel.body_inertia_kg_m2};
    double sum = 0;
    for (const std::uint32_t n : wheel.mesh.rim_surface) {
        const Vec2 r = wheel.mesh.mesh.node_m[n];
        sum += 1 / (wheel.elements.mass_kg[n] * dot(r, r));
    }
    const auto count = static_cast<double>(wheel.mesh.rim_surface.size());
    return {wheel.elements.mass_kg[wheel.mesh.hub], count * count / sum};
}

std::vector<StepLimit> find_case_limits(const Scene& scene) {
    std::vector<StepLimit> limits;
    add_contact_limits(scene, limits);
    if (scene.has_soil_elements()) {
        SoilWorkspace soil;
        attach_soil_workspace(scene.soil, place_soil(scene.soil), soil);
        const double step_s = stable_step(soil.elements).step_s;
        limits.push_back(
            {"the stiffest element of the soil, alone", LimitGroup::elements, LimitKind::safe, step_s, step_s});
    }
    if (!scene.has_wheel()) return limits;
    add_element_limits(scene, limits);
    add_control_limits(scene, limits);
    add_coupling_limits(scene, limits);
    return limits;
}

std::vector<StepLimit> find_frozen_limits(const Scene& scene, const State& state) {
    std::vector<StepLimit> limits;
    const auto add = [&](Movable movable, LimitGroup group, std::string_view of) {
        const FrozenMode mode = find_failing_mode(scene, state, movable);
        if (!(mode.omega_rad_s > 0)) return;
        std::string name = fmt::format("{} as it stands", of);
        if (mode.loudest_contacts > 0)
            name += fmt::format(" (loudest: disc {} with {} contacts)", mode.loudest_disc, mode.loudest_contacts);
        limits.push_back(frozen_limit(std::move(name), group, scene.c.integrator, mode));
    };
    add(Movable::discs, LimitGroup::contacts, "the bed");
    if (scene.has_wheel() && !state.wheel_contacts.empty())
        add(Movable::everything, LimitGroup::everything, "bed and wheel together");
    return limits;
}

const StepLimit* find_worst(const std::vector<StepLimit>& limits, double step_s, Among among) {
    // What fails by itself comes before what needs a contact of disc and wheel, and that before both as a whole, which
    // bears no more than any part.
    const auto rank = [](const StepLimit& l) {
        return l.group == LimitGroup::everything ? 2 : l.group == LimitGroup::coupling ? 1 : 0;
    };
    const StepLimit* worst = nullptr;
    for (const StepLimit& l : limits) {
        if (!(step_s > l.step_s) || (among == Among::certain && l.kind != LimitKind::certain)) continue;
        if (worst == nullptr || rank(l) < rank(*worst) || (rank(l) == rank(*worst) && l.step_s < worst->step_s))
            worst = &l;
    }
    return worst;
}

std::optional<StepLimit> find_certain_excess(const Case& c) {
    for (const Stage stage : {Stage::consolidation, Stage::travel}) {
        const auto limits = find_case_limits(make_scene(c, stage));
        if (const StepLimit* worst = find_worst(limits, c.time_step_s, Among::certain)) return *worst;
    }
    return std::nullopt;
}

std::string describe_limits(const std::vector<StepLimit>& limits, double step_s) {
    std::string text;
    for (const StepLimit& l : limits) {
        if (!std::isfinite(l.step_s)) continue;
        text += fmt::format("{:6.3f} of {:.3e} s  {}, {}: {}\n", step_s / l.step_s, l.step_s, group_name(l.group),
                            l.kind == LimitKind::certain ? "certain" : "safe", l.name);
    }
    return text;
}

std::string explain_excess(const StepLimit& limit, double step_s) {
    const bool dashpot = step_s <= limit.undamped_step_s;
    return fmt::format("time_step_s = {:.4g} is {:.3g} times the largest stable step of {} ({:.4g} s; {}: {}). {}?",
                       step_s, step_s / limit.step_s, group_name(limit.group), limit.step_s,
                       dashpot ? "the dashpots alone make it unstable" : "the springs do it", limit.name,
                       remedy_of(limit.group));
}

}  // namespace ifedem

#include "step/health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "dem/closed_pairs.hpp"
#include "fem/corotation.hpp"

namespace ifedem {
namespace {

/// What a check saw, before its cause is known.
struct Symptom {
    Cause own = Cause::not_a_number;  ///< the cause if no limit of the step is exceeded
    std::string what;
    double value = 0;
    double limit = 0;
};

/// Of contacts the dashpots are the cause where the springs alone would bear the step, in every limit that is known.
Cause cause_of(const StepLimit& exceeded, const std::vector<StepLimit>& all, double step_s) {
    switch (exceeded.group) {
        case LimitGroup::contacts: {
            double springs = exceeded.undamped_step_s;
            for (const StepLimit& l : all)
                if (l.group == LimitGroup::contacts) springs = min_of(springs, l.undamped_step_s);
            return step_s <= springs ? Cause::contact_dashpot : Cause::contact_step;
        }
        case LimitGroup::elements:
            return Cause::element_step;
        case LimitGroup::drawbar_loop:
        case LimitGroup::torque_loop:
            return Cause::control_step;
        case LimitGroup::coupling:
        case LimitGroup::everything:
            return Cause::coupling_step;
    }
    return Cause::coupling_step;
}

std::string_view remedy_of(Cause cause) {
    switch (cause) {
        case Cause::contact_step:
            return "Lower time_step_s.";
        case Cause::contact_dashpot:
            return "Lower contact.damping_ratio or time_step_s.";
        case Cause::element_step:
            return "Lower time_step_s, coarsen the wheel's mesh, or make the stiff part rigid (wheel.body).";
        case Cause::control_step:
            return "Use control.scheme = \"semi-implicit\", or lower time_step_s.";
        case Cause::coupling_step:
            return "Lower time_step_s or contact.normal_stiffness_N_m.";
        case Cause::rolling_sign:
            return "Use contact.rolling_scheme = \"limit\".";
        case Cause::contact_overload:
            return "Raise contact.normal_stiffness_N_m, or lower wheel.load_N.";
        case Cause::element_overload:
            return "Stiffen the layer (or elements.material), or lower wheel.load_N.";
        case Cause::tunnelling:
            return "Lower time_step_s, or raise contact.normal_stiffness_N_m.";
        case Cause::wedged:
            return "Widen wheel.lug_gap_m, or use smaller discs.";
        case Cause::lost_disc:
            return "Lower time_step_s, or raise contact.normal_stiffness_N_m: the wall was passed.";
        case Cause::not_a_number:
            return "The same case fails at the same step: look at the last frame, and at time_step_s against the "
                   "limits "
                   "that `ifedem run` prints at the beginning of the stage.";
        case Cause::loose_bed:
            return "Lengthen stages.consolidation_s.";
        case Cause::shallow_bin:
            return "Raise bed.disc_count, or lower wheel.load_N.";
        case Cause::short_bin:
            return "Lengthen bed.length_m, or shorten travel.distance_m.";
        case Cause::beyond_discs:
            return "Begin and end the travel over blocks of discs (elements.first_disc_column, disc_columns), or let "
                   "them be converted (elements.conversion_interval_steps).";
        case Cause::control_windup:
            return "Lower the integral gain below K_p K_d / mass.";
        case Cause::control_weak:
            return "Raise the loop's gains.";
        case Cause::energy_drift:
            return "Halve time_step_s and compare; sample more often with record.energy_interval_s.";
    }
    return "";
}

/// The limit that explains a failure: one that is certain, else for discs the safe one of contacts, since a bed that is
/// still falling has no contacts to freeze.
const StepLimit* find_guilty(const Scene& scene, const HealthWatch& watch) {
    const double dt = scene.dem.step_s;
    if (const StepLimit* l = find_worst(watch.limits, dt, Among::certain)) return l;
    const StepLimit* l = find_worst(watch.limits, dt, Among::all);
    return l != nullptr && l->group == LimitGroup::contacts ? l : nullptr;
}

Violation diagnose(const Scene& scene, const State& state, const HealthWatch& watch, Symptom s) {
    Violation v{state.progress.total_steps, s.own, std::move(s.what), s.value, s.limit, ""};
    const double dt = scene.dem.step_s;
    if (const StepLimit* l = find_guilty(scene, watch)) {
        v.cause = cause_of(*l, watch.limits, dt);
        v.remedy =
            fmt::format("time_step_s is {:.3g} times the limit of {}. {}", dt / l->step_s, l->name, remedy_of(v.cause));
    } else {
        v.remedy = remedy_of(v.cause);
    }
    return v;
}

std::optional<Symptom> check_discs(const Scene& scene, const State& state) {
    const double margin = 4 * scene.dem.largest_radius_m, dt2 = scene.dem.step_s * scene.dem.step_s;
    const double left = -margin, right = scene.c.bed.length_m + margin, floor = -margin;
    const bool walled = !scene.dem.flat_walls.empty() || !scene.dem.wall_discs.empty();
    for (std::size_t p = 0; p < state.discs.disc.size(); ++p) {
        const Disc& d = state.discs.disc[p];
        const double v2 = d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s;
        const bool well = dt2 * v2 <= d.radius_m * d.radius_m && std::isfinite(d.omega_rad_s) &&
                          (!walled || (d.x_m >= left && d.x_m <= right && d.y_m >= floor));
        if (well) continue;  // not-a-number is not well
        const std::uint32_t id = state.discs.id[p];
        if (!std::isfinite(d.x_m + d.y_m + d.omega_rad_s + v2))
            return Symptom{Cause::not_a_number, fmt::format("disc {} is not a number", id),
                           d.x_m + d.y_m + d.omega_rad_s + v2, 0};
        if (walled && !(d.x_m >= left && d.x_m <= right && d.y_m >= floor))
            return Symptom{Cause::lost_disc, fmt::format("disc {} has left the bin", id), d.y_m < floor ? d.y_m : d.x_m,
                           d.y_m < floor ? floor : (d.x_m < left ? left : right)};
        return Symptom{Cause::tunnelling, fmt::format("disc {} goes its radius within a step", id),
                       std::sqrt(dt2 * v2) / d.radius_m, 1};
    }
    return std::nullopt;
}

/// Contacts of the disc with sides of the wheel that do not follow each other.
bool is_wedged(const Scene& scene, const State& state, std::uint32_t id) {
    const auto count = static_cast<std::uint32_t>(scene.wheel.mesh.boundary.size());
    std::vector<std::uint32_t> sides;
    for (const BoundaryContact& c : state.wheel_contacts)
        if (c.disc == id) sides.push_back(c.surface);
    for (const std::uint32_t a : sides)
        for (const std::uint32_t b : sides)
            if (a != b && (a + 1) % count != b && (b + 1) % count != a) return true;
    return false;
}

std::optional<Symptom> check_overlaps(const Scene& scene, const State& state, const Workspace& work) {
    const double limit = scene.c.health.overlap_limit;
    const auto& disc = state.discs.disc;
    for (std::size_t n = 0; n < work.dem.i.size(); ++n) {
        const Disc &a = disc[work.dem.i[n]], &b = disc[work.dem.j[n]];
        const double smaller = min_of(a.radius_m, b.radius_m), sum = a.radius_m + b.radius_m;
        const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m, nearest = sum - limit * smaller;
        if (dx * dx + dy * dy >= nearest * nearest || nearest <= 0) continue;  // no root in the common case
        const double share = (sum - std::sqrt(dx * dx + dy * dy)) / smaller;
        return Symptom{Cause::contact_overload,
                       fmt::format("discs {} and {} overlap by {:.3g} of the smaller radius",
                                   state.discs.id[work.dem.i[n]], state.discs.id[work.dem.j[n]], share),
                       share, limit};
    }
    if (scene.has_soil_elements() && work.soil.largest_overlap_share > limit)
        return Symptom{Cause::contact_overload,
                       fmt::format("disc {} and a soil element overlap by {:.3g} of its radius", work.soil.deepest_disc,
                                   work.soil.largest_overlap_share),
                       work.soil.largest_overlap_share, limit};
    if (!scene.has_wheel() || work.wheel.largest_overlap_share <= limit) return std::nullopt;
    const std::uint32_t id = work.wheel.deepest_disc;
    return Symptom{
        is_wedged(scene, state, id) ? Cause::wedged : Cause::contact_overload,
        fmt::format("disc {} and the wheel overlap by {:.3g} of its radius", id, work.wheel.largest_overlap_share),
        work.wheel.largest_overlap_share, limit};
}

/// A disc whose centre is inside the wheel by more than its radius: no contact sees it any more.
std::optional<Symptom> check_inside(const Scene& scene, const State& state) {
    const Vec2 hub = hub_position(state.wheel);
    double least2 = 1e300;
    for (const std::uint32_t n : scene.wheel.mesh.boundary) {
        const Vec2 r = state.wheel.position_m[n] - hub;
        least2 = min_of(least2, dot(r, r));
    }
    for (std::size_t p = 0; p < state.discs.disc.size(); ++p) {
        const Disc& d = state.discs.disc[p];
        const Vec2 r{d.x_m - hub.x, d.y_m - hub.y};
        if (dot(r, r) >= least2) continue;
        const double depth = -distance_to_wheel_m(scene.wheel, state.wheel, {d.x_m, d.y_m}) / d.radius_m;
        if (depth > 1)
            return Symptom{Cause::tunnelling, fmt::format("disc {} is inside the wheel", state.discs.id[p]), depth, 1};
    }
    return std::nullopt;
}

Symptom tell_inverted(std::string_view what, std::uint32_t name, const Element& e, std::span<const Vec2> position_m) {
    return {Cause::element_overload,
            fmt::format("{} element {} is inverted: least Jacobian of its corners in m²", what, name),
            smallest_corner_jacobian_m2(corners(e, position_m)), 0};
}

std::optional<Symptom> check_soil(const State& state, const SoilWorkspace& work) {
    const std::span<const Vec2> position_m = state.soil.position_m;
    const auto e = find_inverted(work.elements, position_m);
    if (!e) return std::nullopt;
    return tell_inverted("soil", work.block[*e], work.elements.element[*e], position_m);
}

/// Wheel and elements do not meet (region.hpp): where it comes below their surface, nothing would carry it.
std::optional<Symptom> check_region(const Scene& scene, const State& state, const SoilWorkspace& work) {
    for (const std::uint32_t n : scene.wheel.mesh.boundary) {
        const Vec2 p = state.wheel.position_m[n];
        for (const SurfaceEdge& edge : work.edge) {
            const Vec2 right = state.soil.position_m[edge.from], left = state.soil.position_m[edge.to];
            if (!(left.x <= p.x && p.x < right.x)) continue;
            const double surface_m = left.y + (p.x - left.x) / (right.x - left.x) * (right.y - left.y);
            if (surface_m - p.y > scene.dem.smallest_radius_m)
                return Symptom{Cause::beyond_discs, "the wheel is among soil elements", surface_m - p.y,
                               scene.dem.smallest_radius_m};
        }
    }
    return std::nullopt;
}

/// Routh: m s³ + K_d s² + K_p s + K_i has growing solutions if K_i m > K_p K_d, whatever the step.
bool winds_up(const GainsCase& gains, double mass) {
    return gains.integral * mass > gains.proportional * gains.derivative;
}

std::optional<Symptom> check_control(const Scene& scene, const State& state) {
    const ControlledInertia body = controlled_inertia(scene.wheel);
    const struct {
        const GainsCase& gains;
        double mass, error, limit;
        std::string_view what;
    } loops[] = {{scene.c.control.drawbar, body.mass_kg, std::fabs(state.control.drawbar.error_old),
                  scene.c.health.drawbar_error_limit_m, "the hub is too far from its target"},
                 {scene.c.control.torque, body.inertia_kg_m2, std::fabs(state.control.torque.error_old),
                  scene.c.health.torque_error_limit_rad, "the rim's angle is too far from its target"}};
    for (const auto& l : loops)
        if (!(l.error <= l.limit))
            return Symptom{winds_up(l.gains, l.mass) ? Cause::control_windup : Cause::control_weak, std::string(l.what),
                           l.error, l.limit};
    return std::nullopt;
}

std::optional<Symptom> check_wheel(const Scene& scene, const State& state) {
    const RigidBody& rim = state.wheel.rim;
    const double sum = rim.position_m.x + rim.position_m.y + rim.angle_rad + rim.omega_rad_s;
    if (!std::isfinite(sum)) return Symptom{Cause::not_a_number, "the wheel's rim is not a number", sum, 0};
    for (const std::uint32_t n : scene.wheel.free_node)
        if (!std::isfinite(state.wheel.position_m[n].x + state.wheel.position_m[n].y))
            return Symptom{Cause::not_a_number, fmt::format("wheel node {} is not a number", n), sum, 0};
    if (!scene.wheel.free_node.empty())
        if (const auto e = find_inverted(scene.wheel.elements, state.wheel.position_m))
            return tell_inverted("wheel", *e, scene.wheel.elements.element[*e], state.wheel.position_m);
    double bottom = 1e300;
    for (const std::uint32_t n : scene.wheel.mesh.boundary) bottom = min_of(bottom, state.wheel.position_m[n].y);
    const double layer = 2 * scene.dem.smallest_radius_m;
    if (bottom < layer)
        return Symptom{Cause::shallow_bin, "less than a layer of discs is under the wheel", bottom, layer};
    const double gap = min_of(rim.position_m.x, scene.c.bed.length_m - rim.position_m.x) - scene.wheel.outer_radius_m;
    if (gap < -layer) return Symptom{Cause::short_bin, "the wheel has passed an end wall", gap, -layer};
    return check_control(scene, state);
}

/// Mean number of closed contacts a disc has with discs and walls.
double count_contacts(const Scene& scene, const State& state, const Workspace& work) {
    const auto& disc = state.discs.disc;
    double contacts = 0;
    for_each_closed_pair(disc, work.dem, [&](const ClosedPair&) { contacts += 2; });
    for (const WallCandidate& c : work.dem.wall) {
        const WallSide side = find_wall_side(scene.dem, c.wall, disc[c.position]);
        if (side.distance_m < disc[c.position].radius_m + side.opposite_radius_m) contacts += 1;
    }
    return contacts / static_cast<double>(disc.size());
}

/// Sinkage only, before the wheel weighs on the bed.
std::optional<Symptom> check_bed(const Scene& scene, const State& state, const Workspace& work) {
    // Discs on soil elements have contacts that are not counted here.
    if (scene.stage != Stage::sinkage || state.progress.step > health_interval || scene.has_soil_elements())
        return std::nullopt;
    // Less than two layers have few contacts however well they have settled: check_wheel() calls them shallow.
    double diameters_m = 0;
    for (const Disc& d : state.discs.disc) diameters_m += 2 * d.radius_m;
    if (diameters_m < 2 * scene.c.bed.length_m) return std::nullopt;
    const double least = scene.c.health.least_contacts;
    const double contacts = count_contacts(scene, state, work);
    if (contacts >= least) return std::nullopt;
    return Symptom{Cause::loose_bed, "the bed does not carry yet: contacts a disc", contacts, least};
}

bool is_load_growing(const Scene& scene, const State& state) {
    return scene.stage == Stage::sinkage &&
           static_cast<double>(state.progress.step) * scene.dem.step_s < scene.c.stages.load_ramp_s;
}

void begin_window(const Scene& scene, const State& state, const Workspace& work, HealthWatch& watch) {
    watch.begun = true;
    watch.window_begin = state.progress.step;
    watch.samples = 0;
    watch.stored = measure_energy(scene, state, work);
    watch.ledger = state.energy;
    watch.squares_J2 = watch.rolling_gained_J = 0;
    watch.conversions = state.soil.conversions.size();
}

}  // namespace

std::string_view cause_name(Cause cause) {
    constexpr std::array<std::string_view, 19> name{
        "contact-step", "contact-dashpot",  "element-step",     "control-step", "coupling-step",
        "rolling-sign", "contact-overload", "element-overload", "tunnelling",   "wedged",
        "lost-disc",    "not-a-number",     "loose-bed",        "shallow-bin",  "short-bin",
        "beyond-discs", "control-windup",   "control-weak",     "energy-drift"};
    return name[static_cast<std::size_t>(cause)];
}

std::string to_text(const Violation& v) {
    const std::string limit = std::isfinite(v.value) ? fmt::format(", limit {:.6g}", v.limit) : "";
    return fmt::format("stopped at step {}: {} (value {:.6g}{}; cause: {}). {}", v.total_steps, v.what, v.value, limit,
                       cause_name(v.cause), v.remedy);
}

Violation refuse_step(const State& state, const StepLimit& exceeded, const HealthWatch& watch, double step_s) {
    const Cause cause = cause_of(exceeded, watch.limits, step_s);
    return {state.progress.total_steps,
            cause,
            fmt::format("the step is beyond the limit of {}", exceeded.name),
            step_s,
            exceeded.step_s,
            fmt::format("{} --allow-unstable goes on all the same.", remedy_of(cause))};
}

HealthWatch begin_watch(const Scene& scene, const State& state) {
    HealthWatch watch;
    watch.limits = find_case_limits(scene);
    const std::vector<StepLimit> frozen = find_frozen_limits(scene, state);
    watch.limits.insert(watch.limits.end(), frozen.begin(), frozen.end());
    watch.window_steps = std::max<std::uint64_t>(1, steps_of_stage(scene.c, scene.stage) / 25);
    return watch;
}

std::optional<Violation> check_health(const Scene& scene, const State& state, const Workspace& work,
                                      const HealthWatch& watch) {
    std::optional<Symptom> s = check_discs(scene, state);
    if (!s) s = check_bed(scene, state, work);
    if (!s && scene.has_wheel()) s = check_wheel(scene, state);
    if (!s && scene.has_wheel()) s = check_inside(scene, state);
    if (!s && scene.has_soil_elements()) s = check_soil(state, work.soil);
    if (!s && scene.has_soil_elements() && scene.has_wheel()) s = check_region(scene, state, work.soil);
    if (!s) s = check_overlaps(scene, state, work);
    if (!s) return std::nullopt;
    return diagnose(scene, state, watch, std::move(*s));
}

std::optional<Violation> check_budget(const Scene& scene, const State& state, const Workspace& work,
                                      const EnergyFlow& sample, double interval_s, HealthWatch& watch) {
    // A conversion changes what is stored (its record says by how much): a window does not reach over one. Nor does it
    // over a growing load, of which the account knows the end alone.
    if (!watch.begun || watch.conversions != state.soil.conversions.size() || is_load_growing(scene, state)) {
        begin_window(scene, state, work, watch);
        return std::nullopt;
    }
    ++watch.samples;
    for (const double flow : {sample.torque_W, sample.drawbar_W, sample.lost_normal_W, sample.lost_tangential_W,
                              sample.lost_rolling_W, sample.lost_wheel_W})
        watch.squares_J2 += flow * flow * interval_s * interval_s;
    watch.rolling_gained_J += max_of(0.0, -sample.lost_rolling_W) * interval_s;
    constexpr std::uint64_t fewest = 20;
    if (watch.samples < fewest || state.progress.step - watch.window_begin < watch.window_steps) return std::nullopt;

    const EnergyStore now = measure_energy(scene, state, work);
    const EnergyLedger &a = watch.ledger, &b = state.energy;
    const double work_J = b.work_torque_J + b.work_drawbar_J - a.work_torque_J - a.work_drawbar_J;
    const std::array<double, 4> lost{b.lost_normal_J - a.lost_normal_J, b.lost_tangential_J - a.lost_tangential_J,
                                     b.lost_rolling_J - a.lost_rolling_J, b.lost_wheel_J - a.lost_wheel_J};
    double balance = now.sum_J() - watch.stored.sum_J() - work_J, turned_over = std::fabs(work_J), gained = 0;
    for (const double l : lost) balance += l, turned_over += std::fabs(l), gained += max_of(0.0, -l);
    gained += max_of(0.0, balance);
    const double quarter = 0.25 * turned_over,
                 floor = 0.01 * (now.kinetic_discs_J + now.kinetic_wheel_J + now.kinetic_soil_J);
    const double allowed = max_of(max_of(quarter, 3 * std::sqrt(watch.squares_J2)), floor);
    const double by_rolling = watch.rolling_gained_J;
    begin_window(scene, state, work, watch);
    if (scene.dem.rolling == RollingScheme::sign && by_rolling > max_of(quarter, floor))
        return diagnose(scene, state, watch,
                        {Cause::rolling_sign, "the rolling resistance drives (J in this window)", by_rolling,
                         max_of(quarter, floor)});
    if (!(gained > allowed)) return std::nullopt;
    return diagnose(scene, state, watch,
                    {Cause::energy_drift, "energy comes from nowhere (J in this window)", gained, allowed});
}

std::optional<Violation> check_rest(const Scene& scene, const State& state, const Workspace& work, HealthWatch& watch) {
    if (scene.stage != Stage::consolidation || find_guilty(scene, watch) == nullptr) return std::nullopt;
    if (watch.rest_J != 0 && state.progress.step - watch.rest_begin < watch.window_steps) return std::nullopt;
    const EnergyStore now = measure_energy(scene, state, work);
    const double lost = watch.rest_J - now.sum_J();
    const bool begun = watch.rest_J != 0;
    watch.rest_begin = state.progress.step, watch.rest_J = now.sum_J();
    double fall_J = 0;  // of each disc by its own diameter
    for (const Disc& d : state.discs.disc)
        fall_J += 2 * d.radius_m * norm(scene.dem.gravity_m_s2) / d.inverse_mass_1_kg;
    const bool restless = begun && lost < 0.1 * now.kinetic_discs_J && now.kinetic_discs_J > 1e-6 * fall_J &&
                          count_contacts(scene, state, work) > 1;  // a bed that still falls loses nothing
    watch.restless_windows = restless ? watch.restless_windows + 1 : 0;
    if (watch.restless_windows < 2) return std::nullopt;
    return diagnose(scene, state, watch,
                    {Cause::energy_drift, "the bed does not come to rest (lost J in this window)", lost,
                     0.1 * now.kinetic_discs_J});
}

}  // namespace ifedem

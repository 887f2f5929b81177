#include "step/health.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ifedem {
namespace {

std::optional<Violation> check_discs(const Scene& scene, const State& state) {
    const double margin = 4 * scene.dem.largest_radius_m;
    const double left = -margin, right = scene.c.bed.length_m + margin, floor = -margin;
    for (std::size_t p = 0; p < state.discs.disc.size(); ++p) {
        const Disc& d = state.discs.disc[p];
        const double sum = d.x_m + d.y_m + d.vx_m_s + d.vy_m_s + d.omega_rad_s;
        if (!std::isfinite(sum))
            return Violation{state.progress.total_steps, fmt::format("disc {} is not a number", state.discs.id[p]), sum,
                             0, "Halve time_step_s, or lower contact.damping_ratio: the contacts are unstable."};
        if (d.x_m < left || d.x_m > right || d.y_m < floor)
            return Violation{state.progress.total_steps, fmt::format("disc {} has left the bin", state.discs.id[p]),
                             d.y_m < floor ? d.y_m : d.x_m, d.y_m < floor ? floor : (d.x_m < left ? left : right),
                             "Halve time_step_s, or raise contact.normal_stiffness_N_m: the wall was passed."};
    }
    return std::nullopt;
}

std::optional<Violation> check_overlaps(const Scene& scene, const State& state, const Workspace& work) {
    const double limit = scene.c.health.overlap_limit;
    const auto& disc = state.discs.disc;
    for (std::size_t n = 0; n < work.dem.i.size(); ++n) {
        const Disc& a = disc[work.dem.i[n]];
        const Disc& b = disc[work.dem.j[n]];
        const double overlap = a.radius_m + b.radius_m - norm({b.x_m - a.x_m, b.y_m - a.y_m});
        const double share = overlap / min_of(a.radius_m, b.radius_m);
        if (share > limit)
            return Violation{state.progress.total_steps,
                             fmt::format("discs {} and {} overlap by {:.3g} of the smaller radius",
                                         state.discs.id[work.dem.i[n]], state.discs.id[work.dem.j[n]], share),
                             share, limit,
                             "Raise contact.normal_stiffness_N_m, or halve time_step_s if speeds are growing."};
    }
    if (scene.has_wheel() && work.wheel.largest_overlap_share > limit)
        return Violation{
            state.progress.total_steps, fmt::format("disc {} and the wheel overlap", work.wheel.deepest_disc),
            work.wheel.largest_overlap_share, limit, "Raise contact.normal_stiffness_N_m, or halve time_step_s."};
    if (scene.has_soil_elements() && work.soil.largest_overlap_share > limit)
        return Violation{
            state.progress.total_steps, fmt::format("disc {} and a soil element overlap", work.soil.deepest_disc),
            work.soil.largest_overlap_share, limit, "Raise contact.normal_stiffness_N_m, or halve time_step_s."};
    return std::nullopt;
}

std::optional<Violation> check_soil(const State& state, const SoilWorkspace& work) {
    if (const auto e = find_inverted(work.elements, state.soil.position_m))
        return Violation{state.progress.total_steps, fmt::format("soil element {} is inverted", work.block[*e]), 0, 0,
                         "Stiffen elements.material, keep the wheel further from the elements, or halve time_step_s."};
    return std::nullopt;
}

std::optional<Violation> check_wheel(const Scene& scene, const State& state) {
    const RigidBody& rim = state.wheel.rim;
    const double sum = rim.position_m.x + rim.position_m.y + rim.angle_rad + rim.omega_rad_s;
    if (!std::isfinite(sum))
        return Violation{state.progress.total_steps, "the wheel's rim is not a number", sum, 0,
                         "Halve time_step_s, or use control.scheme = \"semi-implicit\"."};
    if (!scene.wheel.free_node.empty()) {
        if (const auto e = find_inverted(scene.wheel.elements, state.wheel.position_m))
            return Violation{state.progress.total_steps, fmt::format("wheel element {} is inverted", *e), 0, 0,
                             "Lower wheel.load_N, stiffen the layer, or halve time_step_s if it came suddenly."};
    }
    const double x = std::fabs(state.control.drawbar.error_old), turn = std::fabs(state.control.torque.error_old);
    if (x > scene.c.health.drawbar_error_limit_m)
        return Violation{state.progress.total_steps, "the hub is too far from its target", x,
                         scene.c.health.drawbar_error_limit_m, "Raise control.drawbar gains, or halve time_step_s."};
    if (turn > scene.c.health.torque_error_limit_rad)
        return Violation{state.progress.total_steps, "the rim's angle is too far from its target", turn,
                         scene.c.health.torque_error_limit_rad, "Raise control.torque gains, or halve time_step_s."};
    return std::nullopt;
}

}  // namespace

std::optional<Violation> check_health(const Scene& scene, const State& state, const Workspace& work) {
    if (auto v = check_discs(scene, state)) return v;
    if (scene.has_wheel())
        if (auto v = check_wheel(scene, state)) return v;
    if (scene.has_soil_elements())
        if (auto v = check_soil(state, work.soil)) return v;
    return check_overlaps(scene, state, work);
}

std::string to_text(const Violation& v) {
    return fmt::format("stopped at step {}: {} (value {:.6g}, limit {:.6g}). {}", v.total_steps, v.what, v.value,
                       v.limit, v.remedy);
}

}  // namespace ifedem

#include "coupling/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bitmath.hpp"
#include "coupling/stress_handover.hpp"

namespace ifedem {
namespace {

constexpr double clearance_radii = 4;
constexpr double rest_lift_radii = 1e-3;

}  // namespace

double mobilised_sine(const std::array<double, 3>& stress_Pa) {
    const double half = 0.5 * (stress_Pa[0] - stress_Pa[1]), mean = -0.5 * (stress_Pa[0] + stress_Pa[1]);
    if (!(mean > 0)) return std::numeric_limits<double>::infinity();
    return std::sqrt(half * half + stress_Pa[2] * stress_Pa[2]) / mean;
}

bool leaves_elastic_range(const SoilModel& model, const SoilState& soil, std::uint32_t block) {
    const double sine = cos_sin(model.c.friction_angle_deg * pi / 180).sin;
    return mobilised_sine(element_stress_Pa(model, soil, block)) > sine;
}

bool is_tread_near(const SoilModel& model, const DemConstants& k, const State& state, std::uint32_t block,
                   std::span<const Vec2> tread_m) {
    const auto node = model.nodes_of(block);
    const double room = clearance_radii * k.largest_radius_m;
    const double left = state.soil.position_m[node[0]].x - room, right = state.soil.position_m[node[1]].x + room;
    const double near_m = block_surface_m(model, state, block) + room;
    return std::ranges::any_of(tread_m, [&](Vec2 p) { return p.x > left && p.x < right && p.y < near_m; });
}

bool is_at_rest(const SoilModel& model, const DemConstants& k, const State& state, std::uint32_t block) {
    const auto node = model.nodes_of(block);
    const double left = state.soil.position_m[node[0]].x, right = state.soil.position_m[node[1]].x;
    double mass = 0, twice_kinetic_J = 0;
    for (const Disc& d : state.discs.disc) {
        if (!(d.x_m >= left && d.x_m < right)) continue;
        const double m = 1.0 / d.inverse_mass_1_kg;
        mass += m;
        twice_kinetic_J += m * (d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s);
    }
    return twice_kinetic_J <= 2 * mass * norm(model.gravity_m_s2) * rest_lift_radii * k.largest_radius_m;
}

std::optional<DueConversion> find_due_adaptive(const SoilModel& model, const DemConstants& k, const State& state,
                                               std::span<const Vec2> tread_m) {
    const auto [first, last] = find_disc_columns(model, state.soil);
    if (first == last) return std::nullopt;
    const std::uint32_t j = model.rows - 1;
    if (last < model.columns) {
        const std::uint32_t ahead = model.block(last, j);
        if (is_tread_near(model, k, state, ahead, tread_m) || leaves_elastic_range(model, state.soil, ahead))
            return DueConversion{ConversionKind::to_discs, ahead};
    }
    const std::uint32_t behind = model.block(first, j);
    if (last - first > 1 && !is_tread_near(model, k, state, behind, tread_m) && is_at_rest(model, k, state, behind))
        return DueConversion{ConversionKind::to_element, behind};
    return std::nullopt;
}

}  // namespace ifedem

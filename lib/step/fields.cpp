#include "step/fields.hpp"

#include <cmath>

#include "core/bitmath.hpp"
#include "dem/closed_pairs.hpp"
#include "dem/forces.hpp"

namespace ifedem {
namespace {

/// Σ r F over the contacts of a disc.
struct MomentSum {
    double x_Nm = 0, y_Nm = 0, xy_Nm = 0;
};

/// Adds the symmetric part of r F.
void add_moment(MomentSum& s, Vec2 arm_m, Vec2 force_N) {
    s.x_Nm += arm_m.x * force_N.x, s.y_Nm += arm_m.y * force_N.y;
    s.xy_Nm += 0.5 * (arm_m.x * force_N.y + arm_m.y * force_N.x);
}

void add_surface_moments(const ContactConstants& k, const std::vector<SurfaceContact>& contacts,
                         std::vector<MomentSum>& sum) {
    for (const SurfaceContact& c : contacts) {
        if (c.on_disc.overlap_m <= 0) continue;
        const Vec2 normal = Vec2{} - c.outward;
        add_moment(sum[c.position], c.on_disc.arm_m * normal,
                   spring_force_N(k, normal, c.on_disc.overlap_m, c.on_disc.tangential_spring_m));
    }
}

}  // namespace

std::vector<DiscStress> measure_stress(const Scene& scene, const State& state, const Workspace& work) {
    const auto& disc = state.discs.disc;
    std::vector<MomentSum> sum(disc.size());
    for_each_closed_pair(disc, work.dem, [&](const ClosedPair& c) {
        const Vec2 force = spring_force_N(scene.dem.soil, c.normal, c.overlap_m, state.pairs.tangential_m[c.number]);
        const double arm_i = contact_arm_m(c.distance_m, disc[c.i].radius_m, disc[c.j].radius_m);
        add_moment(sum[c.i], arm_i * c.normal, force);
        add_moment(sum[c.j], (arm_i - c.distance_m) * c.normal, Vec2{} - force);
    });
    for (std::size_t n = 0; n < work.dem.wall.size(); ++n) {
        const Disc& d = disc[work.dem.wall[n].position];
        const WallSide side = find_wall_side(scene.dem, work.dem.wall[n].wall, d);
        const double overlap = d.radius_m + side.opposite_radius_m - side.distance_m;
        if (overlap <= 0) continue;
        const double arm = contact_arm_m(side.distance_m, d.radius_m, side.opposite_radius_m);
        add_moment(sum[work.dem.wall[n].position], arm * side.normal,
                   spring_force_N(scene.dem.wall, side.normal, overlap, state.wall_contacts[n].tangential_m));
    }
    add_surface_moments(scene.dem.wheel, work.wheel.contact, sum);
    add_surface_moments(scene.soil.contact, work.soil.contact, sum);
    add_surface_moments(scene.dem.soil, work.soil.attached.contact, sum);
    std::vector<DiscStress> stress;
    for (std::size_t p = 0; p < disc.size(); ++p) {
        const double scale = 1.0 / (pi * disc[p].radius_m * disc[p].radius_m * scene.c.soil.thickness_m);
        stress.push_back({scale * sum[p].x_Nm, scale * sum[p].y_Nm, scale * sum[p].xy_Nm});
    }
    return stress;
}

DiscFields measure_fields(const Scene& scene, const State& state, const Workspace& work) {
    const auto& disc = state.discs.disc;
    std::vector<double> sum_Nm(disc.size(), 0.0);  // Σ arm · spring force over the contacts of a disc, N m
    for_each_closed_pair(disc, work.dem, [&](const ClosedPair& c) {
        const double force = scene.dem.soil.normal_stiffness_N_m * c.overlap_m;
        sum_Nm[c.i] += contact_arm_m(c.distance_m, disc[c.i].radius_m, disc[c.j].radius_m) * force;
        sum_Nm[c.j] += contact_arm_m(c.distance_m, disc[c.j].radius_m, disc[c.i].radius_m) * force;
    });
    DiscFields fields;
    for (std::size_t p = 0; p < disc.size(); ++p) {
        const Disc& d = disc[p];
        const double volume = pi * d.radius_m * d.radius_m * scene.c.soil.thickness_m;
        fields.speed_m_s.push_back(static_cast<float>(std::sqrt(d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s)));
        fields.pressure_Pa.push_back(static_cast<float>(0.5 * sum_Nm[p] / volume));
    }
    return fields;
}

}  // namespace ifedem

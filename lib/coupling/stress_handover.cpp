#include "coupling/stress_handover.hpp"

#include <cmath>

#include "dem/contact_law.hpp"
#include "fem/corotation.hpp"
#include "fem/elasticity.hpp"

namespace ifedem {
namespace {

constexpr std::size_t bottom_left = 0, bottom_right = 1, top_right = 2, top_left = 3;

/// Of a point of a block, in the triangle of the corners `first`, `second` and the centre.
struct AreaCoordinates {
    std::size_t first = 0, second = 0;
    double l_first = 0, l_second = 0, l_centre = 0;

    [[nodiscard]] Vec2 interpolate(const std::array<Vec2, 4>& v) const {
        const Vec2 centre = 0.25 * ((v[0] + v[1]) + (v[2] + v[3]));  // Eqs 5.2, 5.3
        return l_first * v[first] + l_second * v[second] + l_centre * centre;
    }
};

/// Of a point of the undeformed block, a along and b up, both from −½ to ½.
AreaCoordinates find_area_coordinates(double a, double b) {
    const bool sideways = std::fabs(a) > std::fabs(b);
    const double out = sideways ? a : b, along = sideways ? b : a;
    const double depth = std::fabs(out);  // 0 at the centre, ½ on the edge
    AreaCoordinates c;
    // `first` is at the negative end of `along` on each edge.
    if (!sideways) c.first = b < 0 ? bottom_left : top_left, c.second = b < 0 ? bottom_right : top_right;
    if (sideways) c.first = a < 0 ? bottom_left : bottom_right, c.second = a < 0 ? top_left : top_right;
    c.l_first = depth - along, c.l_second = depth + along, c.l_centre = 1 - 2 * depth;
    return c;
}

using Neighbours = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Neighbours find_neighbours(const std::vector<Disc>& discs, double room_m) {
    Neighbours pairs;
    for (std::uint32_t i = 0; i < discs.size(); ++i)
        for (std::uint32_t j = i + 1; j < discs.size(); ++j) {
            const Vec2 between{discs[j].x_m - discs[i].x_m, discs[j].y_m - discs[i].y_m};
            const double reach = discs[i].radius_m + discs[j].radius_m + room_m;
            if (dot(between, between) < reach * reach) pairs.emplace_back(i, j);
        }
    return pairs;
}

/// Σ r_y F_y / V of the normal springs between discs just placed.
double vertical_stress_Pa(const std::vector<Disc>& discs, const Neighbours& pairs, double stiffness_N_m,
                          double volume_m3) {
    double sum = 0;
    for (const auto& [i, j] : pairs) {
        const Vec2 between{discs[j].x_m - discs[i].x_m, discs[j].y_m - discs[i].y_m};
        const double distance = norm(between);
        const double overlap = discs[i].radius_m + discs[j].radius_m - distance;
        if (overlap > 0) sum -= stiffness_N_m * overlap * between.y * between.y / distance;
    }
    return sum / volume_m3;
}

}  // namespace

BlockCorners find_corners(const SoilModel& model, const SoilState& soil, std::uint32_t block) {
    BlockCorners corners;
    const auto node = model.nodes_of(block);
    for (std::size_t a = 0; a < 4; ++a) {
        corners.position_m[a] = soil.position_m[node[a]];
        corners.velocity_m_s[a] = soil.velocity_m_s[node[a]];
    }
    return corners;
}

std::vector<Disc> place_pattern(const SoilModel& model, const SoilState& soil, const BlockCorners& corners,
                                double squash) {
    std::vector<Disc> placed;
    for (const Disc& p : soil.pattern) {
        const AreaCoordinates c = find_area_coordinates(p.x_m / model.c.block_length_m - 0.5,
                                                        (1 - squash) * p.y_m / model.c.block_height_m - 0.5);
        const Vec2 x = c.interpolate(corners.position_m), v = c.interpolate(corners.velocity_m_s);
        Disc d = p;
        d.x_m = x.x, d.y_m = x.y, d.vx_m_s = v.x, d.vy_m_s = v.y;
        placed.push_back(d);
    }
    return placed;
}

std::array<double, 3> element_stress_Pa(const SoilModel& model, const SoilState& soil, std::uint32_t block) {
    return quad_stress_Pa(model.material, PlaneState::strain, soil.shape[block].corner_m,
                          find_corners(model, soil, block).position_m);
}

std::array<double, 3> mean_stress_Pa(const DemConstants& k, const State& state,
                                     const std::vector<std::uint32_t>& positions, double volume_m3) {
    const auto& disc = state.discs.disc;
    std::vector<char> among(disc.size(), 0);
    for (const std::uint32_t p : positions) among[p] = 1;
    std::array<double, 3> sum{};
    const PairState& pairs = state.pairs;
    for (std::size_t n = 0; n < pairs.inner.size(); ++n) {
        const std::uint32_t i = pairs.i[pairs.inner[n]], j = pairs.j[pairs.inner[n]];
        if (among[i] == 0 && among[j] == 0) continue;
        const Vec2 between{disc[j].x_m - disc[i].x_m, disc[j].y_m - disc[i].y_m};
        const double distance = norm(between), overlap = disc[i].radius_m + disc[j].radius_m - distance;
        if (overlap <= 0) continue;
        const Vec2 normal = (1.0 / distance) * between;
        // Of a pair within the block the arms make the whole distance. Across its border the contact point halves the
        // overlap, where contact_arm_m() divides the distance as the radii do: less than an overlap apart.
        const double arm = (among[i] != 0 ? disc[i].radius_m - 0.5 * overlap : 0.0) +
                           (among[j] != 0 ? disc[j].radius_m - 0.5 * overlap : 0.0);
        const Vec2 r = arm * normal;
        const Vec2 on_i = spring_force_N(k.soil, normal, overlap, pairs.tangential_m[n]);
        sum[0] += r.x * on_i.x, sum[1] += r.y * on_i.y, sum[2] += 0.5 * (r.x * on_i.y + r.y * on_i.x);
    }
    return {sum[0] / volume_m3, sum[1] / volume_m3, sum[2] / volume_m3};
}

ElementShape relax(const Material& material, const std::array<Vec2, 4>& now, const std::array<double, 3>& s) {
    const Elasticity d = find_elasticity(material, PlaneState::strain);
    const double det = d.direct_Pa * d.direct_Pa - d.cross_Pa * d.cross_Pa;
    const double ex = (d.direct_Pa * s[0] - d.cross_Pa * s[1]) / det,
                 ey = (d.direct_Pa * s[1] - d.cross_Pa * s[0]) / det;
    const double half_gamma = 0.5 * s[2] / d.shear_Pa;
    const double scale = 1.0 / ((1 + ex) * (1 + ey) - half_gamma * half_gamma);
    const Vec2 middle = 0.25 * ((now[0] + now[1]) + (now[2] + now[3]));
    ElementShape shape;
    for (std::size_t a = 0; a < 4; ++a) {
        const Vec2 x = now[a] - middle;
        shape.corner_m[a] = middle + scale * Vec2{(1 + ey) * x.x - half_gamma * x.y, (1 + ex) * x.y - half_gamma * x.x};
    }
    return shape;
}

double wanted_stress_Pa(const SoilModel& model, const SoilState& soil, std::uint32_t block) {
    const double weight_Pa = model.material.density_kg_m3 * norm(model.gravity_m_s2) * model.c.block_height_m;
    return min_of(-0.1 * 0.5 * weight_Pa, element_stress_Pa(model, soil, block)[1]);
}

double find_squash(const SoilModel& model, const DemConstants& k, const SoilState& soil, const BlockCorners& corners,
                   double wanted_Pa) {
    const double volume = quad_area_m2(corners.position_m) * model.thickness_m;
    const Neighbours pairs = find_neighbours(place_pattern(model, soil, corners, 0), 0.06 * k.largest_radius_m);
    double low = -0.03, high = 0.03;
    for (int n = 0; n < 40; ++n) {
        const double middle = 0.5 * (low + high);
        const double stress =
            vertical_stress_Pa(place_pattern(model, soil, corners, middle), pairs, k.soil.normal_stiffness_N_m, volume);
        (stress > wanted_Pa ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

void share_mass(double mass_kg, std::vector<Disc>& discs) {
    double own_kg = 0;
    for (const Disc& d : discs) own_kg += 1.0 / d.inverse_mass_1_kg;
    const double factor = own_kg / mass_kg;
    for (Disc& d : discs) d.inverse_mass_1_kg *= factor;
}

}  // namespace ifedem

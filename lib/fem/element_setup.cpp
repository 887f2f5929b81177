#include <fmt/format.h>

#include <string_view>

#include "core/error.hpp"
#include "fem/corotation.hpp"
#include "fem/elasticity.hpp"
#include "fem/elements.hpp"

namespace ifedem {
namespace {

struct ShapeGradients {
    std::array<Vec2, 4> gradient_1_m;
    double jacobian_m2 = 0;
};

/// ∂N_a/∂X at (ξ, η) of the bilinear quad with corners at (±1, ±1), counter-clockwise from (−1, −1).
ShapeGradients find_gradients(const std::array<Vec2, 4>& corner, double xi, double eta) {
    constexpr std::array<double, 4> sx{-1, 1, 1, -1};
    constexpr std::array<double, 4> sy{-1, -1, 1, 1};
    std::array<Vec2, 4> local;
    Vec2 dxi;
    Vec2 deta;
    for (std::size_t a = 0; a < 4; ++a) {
        local[a] = {0.25 * sx[a] * (1 + sy[a] * eta), 0.25 * sy[a] * (1 + sx[a] * xi)};
        dxi += local[a].x * corner[a];
        deta += local[a].y * corner[a];
    }
    ShapeGradients result;
    result.jacobian_m2 = cross(dxi, deta);
    for (std::size_t a = 0; a < 4; ++a) {
        result.gradient_1_m[a] = {(deta.y * local[a].x - dxi.y * local[a].y) / result.jacobian_m2,
                                  (dxi.x * local[a].y - deta.x * local[a].x) / result.jacobian_m2};
    }
    return result;
}

/// Kᵉ = ∫ Bᵀ D B t dA (Eq 2.5) by 2 × 2 Gauss points, made symmetric to the bit. Plain loops: Kᵉ feeds the state, and
/// the order of Eigen's sums is not ours to fix.
std::array<double, 64> integrate_stiffness(const std::array<Vec2, 4>& corner, const Elasticity& d, double thickness_m) {
    std::array<double, 64> sum{};
    const double g = 1 / std::sqrt(3.0);
    for (const double eta : {-g, g}) {
        for (const double xi : {-g, g}) {
            const ShapeGradients s = find_gradients(corner, xi, eta);
            const double weight = s.jacobian_m2 * thickness_m;
            for (std::size_t a = 0; a < 4; ++a) {
                for (std::size_t b = 0; b < 4; ++b) {
                    const Vec2 na = s.gradient_1_m[a];
                    const Vec2 nb = s.gradient_1_m[b];
                    double* const k = &sum[16 * a + 2 * b];
                    k[0] += weight * (d.direct_Pa * na.x * nb.x + d.shear_Pa * na.y * nb.y);
                    k[1] += weight * (d.cross_Pa * na.x * nb.y + d.shear_Pa * na.y * nb.x);
                    k[8] += weight * (d.cross_Pa * na.y * nb.x + d.shear_Pa * na.x * nb.y);
                    k[9] += weight * (d.direct_Pa * na.y * nb.y + d.shear_Pa * na.x * nb.x);
                }
            }
        }
    }
    std::array<double, 64> k{};
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t j = 0; j < 8; ++j) k[8 * i + j] = 0.5 * (sum[8 * i + j] + sum[8 * j + i]);
    }
    return k;
}

std::string_view part_name(Part part) {
    constexpr std::array<std::string_view, 4> name{"rim", "intermediate", "surface", "lug"};
    return name[static_cast<std::size_t>(part)];
}

void check_material(const Material& m, Part part, PlaneState plane) {
    const double limit = plane == PlaneState::strain ? 0.5 : 1.0;
    if (m.young_Pa > 0 && m.density_kg_m3 > 0 && m.damping_1_s >= 0 && m.poisson > -1 && m.poisson < limit) return;
    fail_input(
        fmt::format("the material of part '{}' is impossible (E = {} Pa, ν = {}, ρ = {} kg/m³, c = {} 1/s). Give E "
                    "and ρ above 0, c not below 0 and ν between -1 and {}?",
                    part_name(part), m.young_Pa, m.poisson, m.density_kg_m3, m.damping_1_s, limit));
}

Element make_element(const Mesh& mesh, std::size_t index, const Elasticity& elasticity, double thickness_m) {
    Element e;
    e.node = mesh.quad[index];
    const std::array<Vec2, 4> p = corners(e, mesh.node_m);
    if (!(smallest_corner_jacobian_m2(p) > 0)) {
        fail_input(
            fmt::format("element {} has a corner with a non-positive Jacobian (nodes clockwise, or the quad is not "
                        "convex). Order its nodes counter-clockwise or change the mesh?",
                        index));
    }
    const Vec2 mean = 0.25 * ((p[0] + p[1]) + (p[2] + p[3]));
    for (std::size_t a = 0; a < 4; ++a) e.reference_m[a] = p[a] - mean;
    e.gradient_1_m = find_gradients(e.reference_m, 0, 0).gradient_1_m;
    e.stiffness_N_m = integrate_stiffness(e.reference_m, elasticity, thickness_m);
    return e;
}

}  // namespace

ElementSet make_elements(const Mesh& mesh, const std::array<Material, 4>& material, double thickness_m,
                         PlaneState plane) {
    return make_elements(mesh, material, {thickness_m, thickness_m, thickness_m, thickness_m}, plane);
}

ElementSet make_elements(const Mesh& mesh, const std::array<Material, 4>& material,
                         const std::array<double, 4>& thickness_m, PlaneState plane) {
    for (const double t : thickness_m)
        if (!(t > 0)) fail_input(fmt::format("the thickness of the elements is {} m. Give wheel.width_m above 0?", t));
    ElementSet set;
    set.mass_kg.assign(mesh.node_m.size(), 0.0);
    set.damping_kg_s.assign(mesh.node_m.size(), 0.0);
    for (std::size_t k = 0; k < mesh.quad.size(); ++k) {
        const Material& m = material[static_cast<std::size_t>(mesh.part[k])];
        check_material(m, mesh.part[k], plane);
        const double thickness = thickness_m[static_cast<std::size_t>(mesh.part[k])];
        set.element.push_back(make_element(mesh, k, find_elasticity(m, plane), thickness));
        const double mass = m.density_kg_m3 * thickness * quad_area_m2(set.element.back().reference_m);
        set.element_mass_kg.push_back(mass);
        for (const std::uint32_t node : mesh.quad[k]) {
            set.mass_kg[node] += 0.25 * mass;
            set.damping_kg_s[node] += m.damping_1_s * (0.25 * mass);
        }
    }
    return set;
}

}  // namespace ifedem

#include "fem/elements.hpp"

#include "fem/corotation.hpp"
#include "fem/elasticity.hpp"

namespace ifedem {

void add_internal_force(const ElementSet& set, std::span<const Vec2> position_m, std::span<Vec2> force_N) {
    for (const Element& e : set.element) {
        const std::array<Vec2, 4> force = internal_force(e, corners(e, position_m));
        for (std::size_t a = 0; a < 4; ++a) force_N[e.node[a]] += force[a];
    }
}

double strain_energy_J(const ElementSet& set, std::span<const Vec2> position_m) {
    double energy = 0;
    for (const Element& e : set.element) {
        const CorotatedFrame frame = find_frame(e, corners(e, position_m));
        const std::array<double, 8> g = multiply_stiffness(e, frame.d_m);
        for (std::size_t k = 0; k < 8; ++k) energy += 0.5 * g[k] * frame.d_m[k];
    }
    return energy;
}

std::optional<std::uint32_t> find_inverted(const ElementSet& set, std::span<const Vec2> position_m) {
    for (std::uint32_t k = 0; k < set.element.size(); ++k) {
        // Written so that not-a-number counts as inverted.
        if (!(smallest_corner_jacobian_m2(corners(set.element[k], position_m)) > 0)) return k;
    }
    return std::nullopt;
}

std::array<double, 3> centroid_stress_Pa(const Element& element, const Material& material, PlaneState plane,
                                         std::span<const Vec2> position_m) {
    const CorotatedFrame f = find_frame(element, corners(element, position_m));
    double ex = 0;
    double ey = 0;
    double gamma = 0;
    for (std::size_t a = 0; a < 4; ++a) {
        const Vec2 n = element.gradient_1_m[a];
        ex += n.x * f.d_m[2 * a];
        ey += n.y * f.d_m[2 * a + 1];
        gamma += n.y * f.d_m[2 * a] + n.x * f.d_m[2 * a + 1];
    }
    const Elasticity d = find_elasticity(material, plane);
    const double sx = d.direct_Pa * ex + d.cross_Pa * ey;
    const double sy = d.cross_Pa * ex + d.direct_Pa * ey;
    const double t = d.shear_Pa * gamma;
    const double cc = f.c * f.c;
    const double ss = f.s * f.s;
    const double cs = f.c * f.s;
    return {cc * sx + ss * sy - 2 * cs * t, ss * sx + cc * sy + 2 * cs * t, cs * (sx - sy) + (cc - ss) * t};
}

std::array<double, 3> quad_stress_Pa(const Material& material, PlaneState plane, const std::array<Vec2, 4>& reference_m,
                                     const std::array<Vec2, 4>& corner_m) {
    constexpr auto any = Part::rim;
    const Mesh mesh{{reference_m.begin(), reference_m.end()}, {{0, 1, 2, 3}}, {any}};
    const ElementSet set = make_elements(mesh, {material, material, material, material}, 1.0, plane);
    return centroid_stress_Pa(set.element[0], material, plane, corner_m);
}

std::array<Material, 4> wheel_materials(const WheelCase& wheel) {
    return {wheel.rim, wheel.intermediate, wheel.surface, wheel.lug};
}

std::array<double, 4> wheel_widths_m(const WheelCase& wheel) {
    const double rim_m = wheel.rim_width_m > 0 ? wheel.rim_width_m : wheel.width_m;
    return {rim_m, wheel.width_m, wheel.width_m, wheel.width_m};
}

}  // namespace ifedem

#include "fem/elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "support/quad_meshes.hpp"

namespace ifedem {
namespace {

using scene::everywhere;
constexpr Material rubber{4e6, 0.3, 1200, 10};

Mesh make_odd_quads() {  // three unequal quads of two parts
    Mesh mesh = scene::make_grid(3, 1, [](double i, double j) {
        return Vec2{0.02 * i + 0.004 * j * i, 0.03 * j + 0.003 * i * (1 - j)};
    });
    mesh.part[2] = Part::lug;
    return mesh;
}

// Table 4-1: a rim of 10 mm in a tyre of 170 mm. Stiffness and mass go with the width of each part.
TEST(Elements, each_part_has_its_own_width) {
    WheelCase wheel;
    wheel.body = WheelBody::elastic;
    wheel.rim_width_m = 0.25 * wheel.width_m;
    const WheelMesh mesh = make_wheel_mesh(wheel);
    const ElementSet narrow = make_elements(mesh.mesh, wheel_materials(wheel), wheel_widths_m(wheel), wheel.plane);
    const ElementSet wide = make_elements(mesh.mesh, wheel_materials(wheel), wheel.width_m, wheel.plane);
    for (std::size_t e = 0; e < mesh.mesh.quad.size(); ++e) {
        const double share = mesh.mesh.part[e] == Part::rim ? 0.25 : 1.0;
        EXPECT_NEAR(narrow.element_mass_kg[e], share * wide.element_mass_kg[e], 1e-15);
        EXPECT_NEAR(narrow.element[e].stiffness_N_m[0], share * wide.element[e].stiffness_N_m[0],
                    1e-12 * wide.element[e].stiffness_N_m[0]);
    }
    wheel.rim_width_m = 0;
    EXPECT_EQ(wheel_widths_m(wheel)[0], wheel.width_m);
}

TEST(Elements, mass_and_damping_are_lumped_in_quarters) {
    const Mesh mesh = scene::make_bar(2, 1, 0.2, 0.05);
    const ElementSet set = make_elements(mesh, everywhere(rubber), 0.1, PlaneState::stress);
    const double element_mass = 1200 * 0.1 * 0.1 * 0.05;
    EXPECT_DOUBLE_EQ(set.element_mass_kg[0], element_mass);
    EXPECT_DOUBLE_EQ(set.mass_kg[0], element_mass / 4);
    EXPECT_DOUBLE_EQ(set.mass_kg[1], element_mass / 2);
    EXPECT_DOUBLE_EQ(set.damping_kg_s[1], 10 * element_mass / 2);
}

TEST(Elements, each_part_has_its_material) {
    const Mesh mesh = make_odd_quads();
    std::array<Material, 4> material = everywhere(rubber);
    const ElementSet soft = make_elements(mesh, material, 0.1, PlaneState::stress);
    material[3].young_Pa *= 2;
    const ElementSet stiff = make_elements(mesh, material, 0.1, PlaneState::stress);
    EXPECT_EQ(soft.element[0].stiffness_N_m, stiff.element[0].stiffness_N_m);
    for (std::size_t k = 0; k < 64; ++k) {
        EXPECT_NEAR(stiff.element[2].stiffness_N_m[k], 2 * soft.element[2].stiffness_N_m[k], 1e-9);
    }
}

TEST(Elements, stiffness_is_symmetric_and_blind_to_rigid_motion) {
    const ElementSet set = make_elements(make_odd_quads(), everywhere(rubber), 0.1, PlaneState::strain);
    for (const Element& e : set.element) {
        for (std::size_t i = 0; i < 8; ++i) {
            double along_x = 0;
            double along_y = 0;
            double turn = 0;
            for (std::size_t j = 0; j < 8; ++j) {
                const double k = e.stiffness_N_m[8 * i + j];
                EXPECT_EQ(k, e.stiffness_N_m[8 * j + i]);
                (j % 2 == 0 ? along_x : along_y) += k;
                turn += k * (j % 2 == 0 ? -e.reference_m[j / 2].y : e.reference_m[j / 2].x);
            }
            EXPECT_NEAR(along_x, 0, 1e-9);
            EXPECT_NEAR(along_y, 0, 1e-9);
            EXPECT_NEAR(turn, 0, 1e-11);
        }
    }
}

TEST(Elements, square_has_the_eigenvalues_of_the_closed_form) {
    // Free square, plane stress, thickness t: E t/(1−ν) for the dilatation is the largest, so dt = 2 √(m (1−ν)/(4 E
    // t)).
    const ElementSet set =
        make_elements(scene::make_bar(1, 1, 0.01, 0.01), everywhere(rubber), 0.1, PlaneState::stress);
    const double mass = 1200 * 0.1 * 1e-4;
    EXPECT_NEAR(stable_step(set).step_s / (2 * std::sqrt(mass / 4 * (1 - 0.3) / (4e6 * 0.1))), 1, 1e-12);
}

TEST(Elements, stable_step_names_the_smallest_element) {
    Mesh mesh = scene::make_grid(3, 1, [](double i, double j) { return Vec2{0.01 * i * (i + 1), 0.1 * j}; });
    mesh.part = {Part::rim, Part::surface, Part::surface};
    const ElementSet set = make_elements(mesh, everywhere(rubber), 0.1, PlaneState::stress);
    EXPECT_EQ(stable_step(set).element, 0U);
    EXPECT_EQ(stable_step(set, mesh, Part::surface).element, 1U);
    EXPECT_EQ(stable_step(set, mesh, Part::lug).step_s, std::numeric_limits<double>::infinity());
}

TEST(Elements, centroid_stress_is_hookes_in_global_axes) {
    const Mesh mesh = scene::make_bar(1, 1, 0.1, 0.1);
    const ElementSet set = make_elements(mesh, everywhere(rubber), 0.1, PlaneState::stress);
    std::vector<Vec2> stretched = mesh.node_m;  // uniaxial: ε along x, −ν ε along y
    for (Vec2& p : stretched) p = {p.x * 1.001, p.y * (1 - 0.3 * 0.001)};
    const auto along_x = centroid_stress_Pa(set.element[0], rubber, PlaneState::stress, stretched);
    EXPECT_NEAR(along_x[0], 4000, 1e-6);
    EXPECT_NEAR(along_x[1], 0, 1e-6);
    EXPECT_NEAR(along_x[2], 0, 1e-6);
    const auto turned = centroid_stress_Pa(set.element[0], rubber, PlaneState::stress, scene::turned(stretched, 0.5));
    EXPECT_NEAR(turned[0], 4000 * std::cos(0.5) * std::cos(0.5), 1e-6);
    EXPECT_NEAR(turned[1], 4000 * std::sin(0.5) * std::sin(0.5), 1e-6);
    EXPECT_NEAR(turned[2], 4000 * std::sin(0.5) * std::cos(0.5), 1e-6);
}

TEST(Elements, inversion_is_found_and_rotation_is_not_one) {
    const Mesh mesh = scene::make_bar(3, 1, 0.3, 0.1);
    const ElementSet set = make_elements(mesh, everywhere(rubber), 0.1, PlaneState::stress);
    EXPECT_FALSE(find_inverted(set, scene::turned(mesh.node_m, 3.0)).has_value());
    std::vector<Vec2> folded = mesh.node_m;
    folded[2] = {0.09, 0.0};  // lower right corner of element 1 passes its lower left one
    EXPECT_EQ(find_inverted(set, folded), 1U);
    folded[2].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(find_inverted(set, folded), 1U);
}

TEST(Elements, bad_meshes_and_materials_are_refused) {
    Mesh clockwise = scene::make_bar(1, 1, 0.1, 0.1);
    std::swap(clockwise.quad[0][1], clockwise.quad[0][3]);
    EXPECT_THROW(static_cast<void>(make_elements(clockwise, everywhere(rubber), 0.1, PlaneState::stress)), Error);
    const Mesh good = scene::make_bar(1, 1, 0.1, 0.1);
    Material m = rubber;
    m.poisson = 0.5;
    EXPECT_THROW(static_cast<void>(make_elements(good, everywhere(m), 0.1, PlaneState::strain)), Error);
    EXPECT_NO_THROW(static_cast<void>(make_elements(good, everywhere(m), 0.1, PlaneState::stress)));
    m = rubber;
    m.young_Pa = 0;
    EXPECT_THROW(static_cast<void>(make_elements(good, everywhere(m), 0.1, PlaneState::stress)), Error);
    EXPECT_THROW(static_cast<void>(make_elements(good, everywhere(rubber), 0, PlaneState::stress)), Error);
}

}  // namespace
}  // namespace ifedem

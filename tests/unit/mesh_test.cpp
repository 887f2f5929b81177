#include "fem/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/error.hpp"

namespace ifedem {
namespace {

double quad_area_m2(const Mesh& mesh, std::size_t k) {
    const auto& q = mesh.quad[k];
    return 0.5 * cross(mesh.node_m[q[2]] - mesh.node_m[q[0]], mesh.node_m[q[3]] - mesh.node_m[q[1]]);
}

/// Sine of the sharpest or flattest corner, and the longest edge over the shortest.
struct Shape {
    double smallest_sine = 1;
    double largest_aspect = 1;
};

Shape find_shape(const Mesh& mesh, Part part) {
    Shape shape;
    for (std::size_t k = 0; k < mesh.quad.size(); ++k) {
        if (mesh.part[k] != part) continue;
        double longest = 0;
        double shortest = 1e9;
        for (std::size_t a = 0; a < 4; ++a) {
            const Vec2 p = mesh.node_m[mesh.quad[k][a]];
            const Vec2 next = mesh.node_m[mesh.quad[k][(a + 1) % 4]] - p;
            const Vec2 previous = mesh.node_m[mesh.quad[k][(a + 3) % 4]] - p;
            shape.smallest_sine = std::min(shape.smallest_sine, cross(next, previous) / (norm(next) * norm(previous)));
            longest = std::max(longest, norm(next));
            shortest = std::min(shortest, norm(next));
        }
        shape.largest_aspect = std::max(shape.largest_aspect, longest / shortest);
    }
    return shape;
}

/// Edges that belong to one quad only, directed as in that quad.
std::set<std::pair<std::uint32_t, std::uint32_t>> find_free_edges(const Mesh& mesh) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& q : mesh.quad) {
        for (std::size_t a = 0; a < 4; ++a) {
            if (edges.erase({q[(a + 1) % 4], q[a]}) == 0) edges.insert({q[a], q[(a + 1) % 4]});
        }
    }
    return edges;
}

TEST(WheelMesh, has_the_boundary_of_the_text) {
    const WheelMesh wheel = make_wheel_mesh(WheelCase{});
    // 444 elements and 493 nodes (section 3.2.2, swapped) leave 96 boundary edges by Euler's formula: 24 lugs × 4.
    EXPECT_EQ(wheel.boundary.size(), 96U);
    EXPECT_EQ(std::count(wheel.mesh.part.begin(), wheel.mesh.part.end(), Part::lug), 24);
    EXPECT_EQ(wheel.mesh.quad.size(), 6U * 48 + 24);
    EXPECT_EQ(wheel.rim_surface.size(), 48U);
}

TEST(WheelMesh, largest_diameter_is_that_of_table_3_1) {
    const WheelMesh wheel = make_wheel_mesh(WheelCase{});
    double largest = 0;
    for (const Vec2 p : wheel.mesh.node_m) largest = std::max(largest, norm(p));
    EXPECT_NEAR(2 * largest, 0.316, 1e-15);
}

TEST(WheelMesh, lugs_are_as_thick_and_as_far_apart_as_asked) {
    WheelCase c;
    const WheelMesh wheel = make_wheel_mesh(c);
    std::vector<std::array<std::uint32_t, 4>> lug;
    for (std::size_t k = 0; k < wheel.mesh.quad.size(); ++k) {
        if (wheel.mesh.part[k] == Part::lug) lug.push_back(wheel.mesh.quad[k]);
    }
    const auto& node = wheel.mesh.node_m;
    for (const auto& q : lug) {
        const Vec2 base = node[q[3]] - node[q[0]];
        const Vec2 top = node[q[2]] - node[q[1]];
        EXPECT_NEAR(2 * c.tread_radius_m * std::asin(norm(base) / (2 * c.tread_radius_m)), c.lug_thickness_m, 1e-15);
        EXPECT_NEAR(norm(top), norm(base), 1e-15);  // parallel sides
    }
    const double gap_chord = norm(node[lug[1][0]] - node[lug[0][3]]);
    EXPECT_NEAR(2 * c.tread_radius_m * std::asin(gap_chord / (2 * c.tread_radius_m)), c.lug_gap_m, 1e-15);
}

TEST(WheelMesh, phase_turns_the_first_lug) {
    WheelCase c;
    c.lug_phase_deg = 10;
    const WheelMesh wheel = make_wheel_mesh(c);
    const Vec2 first = wheel.mesh.node_m[wheel.boundary[0]];
    EXPECT_NEAR(std::atan2(first.y, first.x), 10 * std::numbers::pi / 180, 1e-14);
}

TEST(WheelMesh, boundary_is_the_counter_clockwise_outer_edge) {
    for (const WheelBody body : {WheelBody::rigid_rim, WheelBody::elastic}) {
        WheelCase c;
        c.body = body;
        c.gap_columns = 3;
        c.pitch_columns = 3;
        const WheelMesh wheel = make_wheel_mesh(c);
        auto free = find_free_edges(wheel.mesh);
        double area = 0;
        for (std::size_t k = 0; k < wheel.boundary.size(); ++k) {
            const std::uint32_t a = wheel.boundary[k];
            const std::uint32_t b = wheel.boundary[(k + 1) % wheel.boundary.size()];
            EXPECT_EQ(free.erase({a, b}), 1U) << "segment " << k;
            area += 0.5 * cross(wheel.mesh.node_m[a], wheel.mesh.node_m[b]);
        }
        EXPECT_EQ(free.size(), body == WheelBody::elastic ? 0U : wheel.rim_surface.size());  // else the hole of the rim
        double quads = 0;
        for (std::size_t k = 0; k < wheel.mesh.quad.size(); ++k) quads += quad_area_m2(wheel.mesh, k);
        double hole = 0;
        for (std::size_t k = 0; k < wheel.rim_surface.size(); ++k) {
            hole += 0.5 * cross(wheel.mesh.node_m[wheel.rim_surface[k]],
                                wheel.mesh.node_m[wheel.rim_surface[(k + 1) % wheel.rim_surface.size()]]);
        }
        EXPECT_NEAR(quads, body == WheelBody::elastic ? area : area - hole, 1e-15);
    }
}

TEST(WheelMesh, rigid_nodes_follow_the_body) {
    WheelCase c;
    c.body = WheelBody::rigid_rim;
    const WheelMesh rim = make_wheel_mesh(c);
    EXPECT_EQ(rim.rigid, rim.rim_surface);
    EXPECT_EQ(rim.hub, WheelMesh::no_node);
    c.body = WheelBody::rigid;
    const WheelMesh rigid = make_wheel_mesh(c);
    EXPECT_EQ(rigid.rigid.size(), rigid.mesh.node_m.size());
    EXPECT_EQ(rigid.mesh.quad.size(), rim.mesh.quad.size());
    c.body = WheelBody::elastic;
    const WheelMesh elastic = make_wheel_mesh(c);
    EXPECT_TRUE(elastic.rigid.empty());
    ASSERT_NE(elastic.hub, WheelMesh::no_node);
    EXPECT_EQ(norm(elastic.mesh.node_m[elastic.hub]), 0.0);
    for (const std::uint32_t k : elastic.rim_surface) EXPECT_NEAR(norm(elastic.mesh.node_m[k]), c.rim_radius_m, 1e-15);
}

TEST(WheelMesh, elastic_rim_has_no_slivers) {
    for (const std::int64_t rings : {1, 2, 3, 6}) {
        for (const std::int64_t pitch : {1, 2, 4}) {
            WheelCase c;
            c.body = WheelBody::elastic;
            c.rim_rings = rings;
            c.pitch_columns = pitch;
            const Shape shape = find_shape(make_wheel_mesh(c).mesh, Part::rim);
            EXPECT_GT(shape.smallest_sine, 0.4) << rings << " rings, " << pitch << " columns";
            EXPECT_LT(shape.largest_aspect, 8) << rings << " rings, " << pitch << " columns";
        }
    }
}

TEST(WheelMesh, smooth_tread_has_as_many_columns_and_no_lugs) {
    for (const WheelBody body : {WheelBody::rigid, WheelBody::rigid_rim, WheelBody::elastic}) {
        WheelCase c;
        c.body = body;
        c.lug_pairs = 0;
        const WheelMesh wheel = make_wheel_mesh(c);
        EXPECT_EQ(wheel.boundary.size(), 48U);
        for (const std::uint32_t k : wheel.boundary) EXPECT_NEAR(norm(wheel.mesh.node_m[k]), c.tread_radius_m, 1e-15);
    }
}

// 448 quads with 477 nodes have 56 boundary edges by Euler's rule: 7 rings of 56 around 56 quads within the rim.
TEST(WheelMesh, the_tyre_of_chapter_4_has_the_columns_of_the_published_counts) {
    const WheelCase c = read_case(IFEDEM_SOURCE_DIR "/reproductions/chapter4/cases/tyre.toml").wheel;
    const WheelMesh wheel = make_wheel_mesh(c);
    EXPECT_EQ(wheel.boundary.size(), 2U * (477U - 448U - 1U));
    EXPECT_EQ(wheel.mesh.quad.size() + static_cast<std::size_t>(c.rim_rings) * 56U + 56U, 448U);
}

TEST(WheelMesh, impossible_wheels_are_refused) {
    const auto refused = [](auto change) {
        WheelCase c;
        change(c);
        EXPECT_THROW(static_cast<void>(make_wheel_mesh(c)), Error);
    };
    refused([](WheelCase& c) { c.tread_radius_m = 0.08; });
    refused([](WheelCase& c) { c.surface_thickness_m = 0.06; });
    refused([](WheelCase& c) { c.intermediate_rings = 0; });
    refused([](WheelCase& c) { c.lug_pairs = 40; });
    refused([](WheelCase& c) { c.lug_gap_m = 0; });
    refused([](WheelCase& c) {
        c.body = WheelBody::elastic;
        c.lug_pairs = 11;
        c.pitch_columns = 2;
    });
}

}  // namespace
}  // namespace ifedem

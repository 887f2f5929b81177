#include "fem/gmsh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "support/scratch.hpp"

namespace ifedem {
namespace {

const std::string folder = std::string(IFEDEM_SOURCE_DIR) + "/tests/support/gmsh/";

/// The wheel of wheel.geo.
WheelCase small_wheel() {
    WheelCase wheel;
    wheel.rim_radius_m = 0.03;
    wheel.tread_radius_m = 0.05;
    wheel.surface_thickness_m = 0.01;
    wheel.lug_pairs = 0;
    return wheel;
}

double quad_area_m2(const Mesh& mesh, std::size_t k) {
    const auto& q = mesh.quad[k];
    return 0.5 * cross(mesh.node_m[q[2]] - mesh.node_m[q[0]], mesh.node_m[q[3]] - mesh.node_m[q[1]]);
}

double area_m2(const Mesh& mesh, Part part) {
    double sum = 0;
    for (std::size_t k = 0; k < mesh.quad.size(); ++k) sum += mesh.part[k] == part ? quad_area_m2(mesh, k) : 0;
    return sum;
}

WheelMesh read_wheel(const std::string& file, const WheelCase& wheel) {
    return make_gmsh_wheel(parse_gmsh(read_text(folder + file), file), wheel, file);
}

/// Of a ring of 24 chords.
double ring_area_m2(double inner_m, double outer_m) {
    return 12 * std::sin(2 * std::numbers::pi / 24) * (outer_m * outer_m - inner_m * inner_m);
}

class GmshFormat : public testing::TestWithParam<const char*> {};

TEST_P(GmshFormat, GivesTheWheelOfItsGeometry) {
    const WheelMesh wheel = read_wheel(GetParam(), small_wheel());
    EXPECT_EQ(wheel.mesh.quad.size(), 72U);
    EXPECT_EQ(wheel.mesh.node_m.size(), 96U);
    EXPECT_NEAR(area_m2(wheel.mesh, Part::intermediate), ring_area_m2(0.03, 0.04), 1e-9);
    EXPECT_NEAR(area_m2(wheel.mesh, Part::surface), ring_area_m2(0.04, 0.05), 1e-9);
    for (std::size_t k = 0; k < wheel.mesh.quad.size(); ++k) EXPECT_GT(quad_area_m2(wheel.mesh, k), 0) << k;

    ASSERT_EQ(wheel.boundary.size(), 24U);
    for (std::size_t k = 0; k < 24; ++k) {
        const Vec2 a = wheel.mesh.node_m[wheel.boundary[k]], b = wheel.mesh.node_m[wheel.boundary[(k + 1) % 24]];
        EXPECT_NEAR(norm(a), 0.05, 1e-9);
        EXPECT_NEAR(cross(a, b), 0.05 * 0.05 * std::sin(2 * std::numbers::pi / 24), 1e-9)
            << "not the next, counter-clockwise";
    }
    ASSERT_EQ(wheel.rim_surface.size(), 24U);
    for (const std::uint32_t n : wheel.rim_surface) EXPECT_NEAR(norm(wheel.mesh.node_m[n]), 0.03, 1e-9);
    EXPECT_EQ(wheel.rigid, wheel.rim_surface);
    EXPECT_EQ(wheel.hub, WheelMesh::no_node);
}

INSTANTIATE_TEST_SUITE_P(Both, GmshFormat, testing::Values("wheel22.msh", "wheel41.msh"));

TEST(Gmsh, BothFormatsGiveTheSameWheel) {
    const WheelMesh a = read_wheel("wheel22.msh", small_wheel()), b = read_wheel("wheel41.msh", small_wheel());
    ASSERT_EQ(a.mesh.node_m.size(), b.mesh.node_m.size());
    std::set<std::pair<long, long>> of_a, of_b;
    for (const Vec2 n : a.mesh.node_m) of_a.insert({std::lround(1e9 * n.x), std::lround(1e9 * n.y)});
    for (const Vec2 n : b.mesh.node_m) of_b.insert({std::lround(1e9 * n.x), std::lround(1e9 * n.y)});
    EXPECT_EQ(of_a, of_b);
}

TEST(Gmsh, IsTurnedByTheLugPhase) {
    WheelCase turned = small_wheel();
    turned.lug_phase_deg = 90;
    const WheelMesh a = read_wheel("wheel22.msh", small_wheel()), b = read_wheel("wheel22.msh", turned);
    for (std::size_t n = 0; n < a.mesh.node_m.size(); ++n) {
        EXPECT_NEAR(b.mesh.node_m[n].x, -a.mesh.node_m[n].y, 1e-15);
        EXPECT_NEAR(b.mesh.node_m[n].y, a.mesh.node_m[n].x, 1e-15);
    }
}

/// A square plate of quads of side 0.1 m about the hub: `n` by `n`, without the quads that `hole` names.
std::string plate(int n, const std::string& group, const std::set<std::pair<int, int>>& hole = {}) {
    std::string nodes, elements;
    int count = 0;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            nodes += std::to_string(1 + j * (n + 1) + i) + " " + std::to_string(0.1 * i / n - 0.05) + " " +
                     std::to_string(0.1 * j / n - 0.05) + " 0\n";
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            if (hole.contains({i, j})) continue;
            const int a = 1 + j * (n + 1) + i;
            elements += std::to_string(++count) + " 3 2 1 1 " + std::to_string(a) + " " + std::to_string(a + n + 1) +
                        " " + std::to_string(a + n + 2) + " " + std::to_string(a + 1) + "\n";  // clockwise
        }
    }
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"" + group +
           "\"\n$EndPhysicalNames\n$Nodes\n" + std::to_string((n + 1) * (n + 1)) + "\n" + nodes +
           "$EndNodes\n$Elements\n" + std::to_string(count) + "\n" + elements + "$EndElements\n";
}

/// The program's own mesh of a wheel as if it came from a file.
GmshMesh as_gmsh(const Mesh& mesh) {
    GmshMesh result{mesh.node_m, mesh.quad, {}};
    for (const Part part : mesh.part)
        result.group.emplace_back(std::array{"rim", "intermediate", "surface", "lug"}[static_cast<std::size_t>(part)]);
    return result;
}

/// Places of nodes, from whichever numbering, the first of them the rightmost.
std::vector<std::pair<double, double>> places(const WheelMesh& wheel, std::vector<std::uint32_t> nodes) {
    std::vector<std::pair<double, double>> result;
    for (const std::uint32_t n : nodes) result.emplace_back(wheel.mesh.node_m[n].x, wheel.mesh.node_m[n].y);
    std::rotate(result.begin(), std::max_element(result.begin(), result.end()), result.end());
    return result;
}

TEST(Gmsh, FindsTheLoopsThatTheOwnMeshIsMadeWith) {
    for (const WheelBody body : {WheelBody::rigid, WheelBody::rigid_rim, WheelBody::elastic}) {
        WheelCase wheel;
        wheel.body = body;
        const WheelMesh own = make_wheel_mesh(wheel), read = make_gmsh_wheel(as_gmsh(own.mesh), wheel, "own");
        EXPECT_EQ(places(read, read.boundary), places(own, own.boundary));
        auto of_read = places(read, read.rim_surface), of_own = places(own, own.rim_surface);
        std::ranges::sort(of_read);
        std::ranges::sort(of_own);
        EXPECT_EQ(of_read, of_own);
        EXPECT_EQ(read.rigid.size(), own.rigid.size());
        EXPECT_EQ(read.mesh.quad.size(), own.mesh.quad.size());
        EXPECT_EQ(read.hub == WheelMesh::no_node, own.hub == WheelMesh::no_node);
        if (read.hub != WheelMesh::no_node) {
            EXPECT_LT(norm(read.mesh.node_m[read.hub]), 1e-12);
        }
    }
}

TEST(Gmsh, LeavesHolesBetweenSpokesFree) {
    GmshMesh mesh = parse_gmsh(read_text(folder + "wheel22.msh"), "m");
    const auto is_inside = [&](std::uint32_t n) {
        return norm(mesh.node_m[n]) > 0.0349 && norm(mesh.node_m[n]) < 0.0401;
    };
    const auto hole = std::ranges::find_if(mesh.quad, [&](const auto& q) { return std::ranges::all_of(q, is_inside); });
    ASSERT_NE(hole, mesh.quad.end());
    mesh.group.erase(mesh.group.begin() + (hole - mesh.quad.begin()));
    mesh.quad.erase(hole);
    const WheelMesh wheel = make_gmsh_wheel(mesh, small_wheel(), "m");
    EXPECT_EQ(wheel.mesh.quad.size(), 71U);
    EXPECT_EQ(wheel.boundary.size(), 24U);
    EXPECT_EQ(wheel.rim_surface.size(), 24U);
}

/// What is said about a mesh that is none, with this in place of that.
std::string fault_of(std::string text, const std::string& that = "", const std::string& with = "") {
    if (!that.empty()) {
        const std::size_t at = text.find(that);
        EXPECT_NE(at, std::string::npos) << that;
        if (at != std::string::npos) text.replace(at, that.size(), with);
    }
    try {
        (void)make_gmsh_wheel(parse_gmsh(text, "m"), small_wheel(), "m");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "no fault";
}

TEST(Gmsh, SaysWhatIsWrongWhereAndWhatToDo) {
    const std::string good = read_text(folder + "wheel22.msh"), new_format = read_text(folder + "wheel41.msh");
    struct Bad {
        std::string text, that, with, fault;
    };
    const std::vector<Bad> bad = {
        {"", "", "", "m:1: the file does not begin with $MeshFormat"},
        {good, "2.2 0 8", "3 0 8", "m:2: format 3 (2.2 and 4.1 are read)"},
        {good, "2.2 0 8", "2.2 1 8", "m:2: the file is binary"},
        {good, "$Nodes\n96", "$Nodes\n97", "m:107: \"$EndNodes\" is no node number"},
        {good, "$Nodes\n96", "$Nodes\n95", "m:106: \"96\" stands where $EndNodes should"},
        {good, "1 0.03 0 0", "1 0.03 0 0.5", "m:11: node 1 lies at z = 0.5"},
        {good, "1 0.03 0 0", "1 nan 0 0", "m:11: coordinate is not finite"},
        {good, "1 0.03 0 0", "1 1e999 0 0", "m:11: \"1e999\" is no coordinate"},
        {good, "2 1 \"intermediate\"", "2 1 \"tyre\"", "m: physical surface \"tyre\" is no part of a wheel"},
        {good, "2 1 \"intermediate\"", "1 1 \"intermediate\"", "m:110: quad 1 belongs to no named physical surface"},
        {good, "1 3 2 1", "1 2 2 1", "m:110: an element of Gmsh type 2"},
        {good.substr(0, good.size() / 2), "", "", "m:"},
        {new_format, "$Entities\n13 20 8 0", "$Entities\n13 20 9 0", "m:"},
        {plate(4, "surface"), "", "", "m: there is no hole round the hub"},
        {plate(4, "rim"), "", "", "m: all quads belong to the rim"},
        {plate(4, "surface", {{1, 1}, {1, 2}, {2, 1}, {2, 2}}), "", "", "m: a node of the rim surface is 0.0"},
        {plate(4, "surface", {{0, 1}, {1, 0}}), "", "", "m: the outline touches itself at x = -0.025, y = -0.025"},
        {plate(3, "surface", {{0, 1}, {1, 1}, {2, 1}}), "", "", "m: the wheel is in pieces"},
        {plate(2, "surface", {{1, 1}, {0, 1}, {1, 0}}), "", "", "m: the outline does not go round"},
    };
    for (const Bad& b : bad) {
        const std::string fault = fault_of(b.text, b.that, b.with);
        EXPECT_TRUE(fault.starts_with(b.fault) && fault.ends_with("?"))
            << "expected: " << b.fault << "\nreported: " << fault;
    }
}

TEST(Gmsh, TheCaseNamesAMeshAndKeepsItsChecksum) {
    const Scratch scratch;
    const std::string keys =
        "wheel = { mesh_file = \"w.msh\", rim_radius_mm = 30, tread_radius_mm = 50, lug_pairs = 0, "
        "surface_thickness_mm = 10 }";
    std::filesystem::copy_file(folder + "wheel41.msh", scratch.file("w.msh"));
    std::ofstream(scratch.file("case.toml")) << keys;
    const Case c = read_case(scratch.file("case.toml"));
    EXPECT_EQ(c.wheel.mesh_file, scratch.file("w.msh"));
    EXPECT_EQ(c.wheel.mesh_checksum.size(), 16U);
    EXPECT_EQ(make_wheel_mesh(c.wheel).boundary.size(), 24U);
    const Case again = parse_case(to_toml(c), "resolved");
    EXPECT_EQ(to_toml(again), to_toml(c));
    std::ofstream(scratch.file("w.msh"), std::ios::app) << "\n";
    EXPECT_NO_THROW((void)parse_case(to_toml(c), "resolved")) << "a report needs no mesh";
    EXPECT_THROW((void)make_wheel_mesh(c.wheel), Error) << "the mesh has changed";
    EXPECT_NE(read_case(scratch.file("case.toml")).wheel.mesh_checksum, c.wheel.mesh_checksum);
    std::filesystem::remove(scratch.file("w.msh"));
    EXPECT_THROW((void)read_case(scratch.file("case.toml")), Error);
}

}  // namespace
}  // namespace ifedem

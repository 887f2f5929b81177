#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "fem/gmsh.hpp"

namespace ifedem {
namespace {

using Quad = std::array<std::uint32_t, 4>;
using Loop = std::vector<std::uint32_t>;

constexpr std::array<std::string_view, 4> part_names = {"rim", "intermediate", "surface", "lug"};  // in Part's order
constexpr double size_tolerance = 0.01;  // of a radius that the case and the mesh both give

[[noreturn]] void fail_mesh(const std::string& name, const std::string& message) {
    fail_input(fmt::format("{}: {}", name, message));
}

Part find_part(const std::string& group, const std::string& name) {
    const auto* const found = std::ranges::find(part_names, std::string_view(group));
    if (found == part_names.end())
        fail_mesh(name, fmt::format("physical surface \"{}\" is no part of a wheel (these are rim, intermediate, "
                                    "surface, lug). Rename it?",
                                    group));
    return static_cast<Part>(found - part_names.begin());
}

/// Twice the signed area of the triangle a, b, c.
double turn(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// The quad counter-clockwise; it must be convex, or its map to the unit square folds.
Quad orient(Quad quad, const std::vector<Vec2>& node, const std::string& name) {
    const auto at = [&](std::size_t k) { return node[quad[k % 4]]; };
    if (turn(at(0), at(1), at(2)) + turn(at(2), at(3), at(0)) < 0) std::swap(quad[1], quad[3]);
    for (std::size_t k = 0; k < 4; ++k) {
        if (!(turn(at(k), at(k + 1), at(k + 2)) > 0))
            fail_mesh(name, fmt::format("the quad about x = {:.4g}, y = {:.4g} is not convex (its corner {} turns the "
                                        "wrong way). Refine or smooth the mesh there?",
                                        at(0).x, at(0).y, (k + 1) % 4));
    }
    return quad;
}

/// The quads that a wheel of this body carries, oriented, with unused nodes left out.
Mesh take_parts(const GmshMesh& source, const WheelCase& wheel, const std::string& name) {
    Mesh mesh;
    constexpr std::uint32_t unused = 0xffffffffU;
    std::vector<std::uint32_t> number(source.node_m.size(), unused);
    const CosSin phase = cos_sin(wheel.lug_phase_deg * (pi / 180.0));
    for (std::size_t q = 0; q < source.quad.size(); ++q) {
        const Part part = find_part(source.group[q], name);
        if (part == Part::rim && wheel.body != WheelBody::elastic) continue;
        Quad quad = orient(source.quad[q], source.node_m, name);
        for (std::uint32_t& corner : quad) {
            if (number[corner] == unused) {
                number[corner] = static_cast<std::uint32_t>(mesh.node_m.size());
                const Vec2 at = source.node_m[corner];
                mesh.node_m.push_back({phase.cos * at.x - phase.sin * at.y, phase.sin * at.x + phase.cos * at.y});
            }
            corner = number[corner];
        }
        mesh.quad.push_back(quad);
        mesh.part.push_back(part);
    }
    if (mesh.quad.empty())
        fail_mesh(name,
                  "all quads belong to the rim (a rigid rim carries none). Name the layers, or set wheel.body = "
                  "\"elastic\"?");
    return mesh;
}

/// Edges of one quad only, as node → next node with the mesh to the left: the outer loop runs counter-clockwise, holes
/// run clockwise.
std::map<std::uint32_t, std::uint32_t> find_free_edges(const Mesh& mesh, const std::string& name) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> used;
    for (const Quad& quad : mesh.quad) {
        for (std::size_t k = 0; k < 4; ++k) ++used[{quad[k], quad[(k + 1) % 4]}];
    }
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [edge, times] : used) {
        const Vec2 at = mesh.node_m[edge.first];
        if (times > 1)
            fail_mesh(name, fmt::format("quads overlap at x = {:.4g}, y = {:.4g} (two have the same edge on the same "
                                        "side). Remove one?",
                                        at.x, at.y));
        if (used.contains({edge.second, edge.first})) continue;
        if (!next.emplace(edge).second)
            fail_mesh(name, fmt::format("the outline touches itself at x = {:.4g}, y = {:.4g} (quads are joined by a "
                                        "node only). Join them by an edge?",
                                        at.x, at.y));
    }
    return next;
}

std::vector<Loop> find_loops(std::map<std::uint32_t, std::uint32_t> next) {
    std::vector<Loop> loops;
    while (!next.empty()) {
        Loop loop;
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            if (loop.empty()) loop.push_back(at->first);
            loop.push_back(at->second);
            next.erase(at);
        }
        loop.pop_back();  // back at the first
        loops.push_back(std::move(loop));
    }
    return loops;
}

double area_m2(const Loop& loop, const std::vector<Vec2>& node) {
    double twice = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) twice += cross(node[loop[k]], node[loop[(k + 1) % loop.size()]]);
    return 0.5 * twice;
}

/// Whether the hub, at the origin, lies within the loop: how often it winds round it.
bool surrounds_hub(const Loop& loop, const std::vector<Vec2>& node) {
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 a = node[loop[k]], b = node[loop[(k + 1) % loop.size()]];
        if ((a.y > 0) != (b.y > 0) && a.x + (b.x - a.x) * (-a.y / (b.y - a.y)) > 0) inside = !inside;
    }
    return inside;
}

Loop take_outer_loop(const std::vector<Loop>& loops, const Mesh& mesh, const std::string& name) {
    const Loop* outer = nullptr;
    for (const Loop& loop : loops) {
        if (area_m2(loop, mesh.node_m) < 0) continue;
        if (outer != nullptr)
            fail_mesh(name,
                      "the wheel is in pieces (there are two outlines). Are coincident nodes merged (Coherence "
                      "Mesh)?");
        outer = &loop;
    }
    if (outer == nullptr || !surrounds_hub(*outer, mesh.node_m))
        fail_mesh(name, "the outline does not go round x = 0, y = 0 (where the hub is). Move the mesh?");
    return *outer;
}

Loop find_rim_surface(const std::vector<Loop>& loops, const Mesh& mesh, WheelBody body, const std::string& name) {
    Loop surface;
    if (body == WheelBody::elastic) {  // nodes of both sides of the joint
        std::vector<char> of_rim(mesh.node_m.size(), 0), of_layers(mesh.node_m.size(), 0);
        for (std::size_t q = 0; q < mesh.quad.size(); ++q) {
            for (const std::uint32_t n : mesh.quad[q]) (mesh.part[q] == Part::rim ? of_rim : of_layers)[n] = 1;
        }
        for (std::uint32_t n = 0; n < mesh.node_m.size(); ++n)
            if (of_rim[n] != 0 && of_layers[n] != 0) surface.push_back(n);
        if (surface.empty())
            fail_mesh(name,
                      "rim and layers share no nodes (an elastic wheel is driven there). Name the rim's surface "
                      "\"rim\" and merge coincident nodes?");
        return surface;
    }
    for (const Loop& loop : loops) {
        if (area_m2(loop, mesh.node_m) < 0 && surrounds_hub(loop, mesh.node_m)) surface = loop;
    }
    if (surface.empty())
        fail_mesh(name,
                  "there is no hole round the hub (a rigid rim fills one). Cut out the rim, or name its surface "
                  "\"rim\"?");
    std::ranges::reverse(surface);
    return surface;
}

void check_radius(double found_m, double stated_m, const char* what, const char* keys, const std::string& name) {
    if (std::fabs(found_m - stated_m) <= size_tolerance * stated_m) return;
    fail_mesh(name, fmt::format("{} is {:.6g} m from the hub and the case says {:.6g} m ({}). Correct one, or is the "
                                "mesh not in metres?",
                                what, found_m, stated_m, keys));
}

void check_sizes(const WheelMesh& result, const WheelCase& wheel, const std::string& name) {
    for (const std::uint32_t n : result.rim_surface)
        check_radius(norm(result.mesh.node_m[n]), wheel.rim_radius_m, "a node of the rim surface", "wheel.rim_radius_m",
                     name);
    double outermost_m = 0;
    for (const std::uint32_t n : result.boundary) outermost_m = std::max(outermost_m, norm(result.mesh.node_m[n]));
    const double lug_m = wheel.lug_pairs > 0 ? wheel.lug_height_m : 0.0;
    check_radius(outermost_m, wheel.tread_radius_m + lug_m, "the outermost node",
                 "wheel.tread_radius_m, with wheel.lug_height_m unless wheel.lug_pairs is 0", name);
}

std::uint32_t find_hub(const Mesh& mesh, double tread_radius_m, const std::string& name) {
    for (std::uint32_t n = 0; n < mesh.node_m.size(); ++n)
        if (norm(mesh.node_m[n]) < 1e-6 * tread_radius_m) return n;
    fail_mesh(name,
              "there is no node at x = 0, y = 0 (load and drawbar act at an elastic wheel's centre). Embed a point "
              "there?");
}

}  // namespace

WheelMesh make_gmsh_wheel(const GmshMesh& mesh, const WheelCase& wheel, const std::string& name) {
    WheelMesh result;
    result.mesh = take_parts(mesh, wheel, name);
    const std::vector<Loop> loops = find_loops(find_free_edges(result.mesh, name));
    result.boundary = take_outer_loop(loops, result.mesh, name);
    result.rim_surface = find_rim_surface(loops, result.mesh, wheel.body, name);
    check_sizes(result, wheel, name);
    if (wheel.body == WheelBody::rigid_rim) result.rigid = result.rim_surface;
    if (wheel.body == WheelBody::rigid) {
        for (std::uint32_t n = 0; n < result.mesh.node_m.size(); ++n) result.rigid.push_back(n);
    }
    if (wheel.body == WheelBody::elastic) result.hub = find_hub(result.mesh, wheel.tread_radius_m, name);
    return result;
}

WheelMesh read_gmsh_wheel(const WheelCase& wheel) {
    std::ifstream file(wheel.mesh_file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) fail_io(fmt::format("{} cannot be read. Check wheel.mesh_file and its permissions?", wheel.mesh_file));
    const std::string found = to_hex(checksum(std::as_bytes(std::span(text))));
    if (!wheel.mesh_checksum.empty() && found != wheel.mesh_checksum)
        fail_input(
            fmt::format("{} has changed since the case was resolved (its checksum is {}, wheel.mesh_checksum = "
                        "{}). Restore it, or run the case anew?",
                        wheel.mesh_file, found, wheel.mesh_checksum));
    return make_gmsh_wheel(parse_gmsh(text, wheel.mesh_file), wheel, wheel.mesh_file);
}

}  // namespace ifedem

#include "fem/hub_core.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/bitmath.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

/// A logical a × b block of quads; `loop` is its border, counter-clockwise from the corner (0, 0).
struct Block {
    std::uint32_t a = 0, b = 0;
    std::vector<Vec2> loop_m;

    [[nodiscard]] Vec2 bottom(std::uint32_t i) const { return loop_m[i]; }
    [[nodiscard]] Vec2 right(std::uint32_t j) const { return loop_m[a + j]; }
    [[nodiscard]] Vec2 top(std::uint32_t i) const { return loop_m[a + b + (a - i)]; }
    [[nodiscard]] Vec2 left(std::uint32_t j) const { return j == 0 ? loop_m[0] : loop_m[2 * a + b + (b - j)]; }
    [[nodiscard]] std::uint32_t index(std::uint32_t i, std::uint32_t j) const { return j * (a + 1) + i; }
    /// Block node of the k-th point of the loop.
    [[nodiscard]] std::uint32_t loop_index(std::uint32_t k) const {
        if (k <= a) return index(k, 0);
        if (k <= a + b) return index(a, k - a);
        if (k <= 2 * a + b) return index(2 * a + b - k, b);
        return index(0, 2 * a + 2 * b - k);
    }
};

/// A corner of the block as a point of the loop, for loop point k: where its side begins and how far along it k is.
struct Side {
    std::uint32_t begin = 0, end = 0;
    double share = 0;
};

Side side_of(const Block& block, std::uint32_t k) {
    const std::uint32_t corner[5] = {0, block.a, block.a + block.b, 2 * block.a + block.b, 2 * (block.a + block.b)};
    std::size_t s = 0;
    while (k >= corner[s + 1]) ++s;
    return {corner[s], corner[s + 1],
            static_cast<double>(k - corner[s]) / static_cast<double>(corner[s + 1] - corner[s])};
}

Block lay_out_block(const std::vector<double>& angle_rad, double radius_m) {
    const auto n = static_cast<std::uint32_t>(angle_rad.size());
    Block block;
    block.a = n / 8 * 2;  // both sides even, so that a node stands in the centre
    block.b = n / 2 - block.a;
    double offset = 0;  // equal angles with the same mean as the columns'
    for (std::uint32_t k = 0; k < n; ++k) offset += (angle_rad[k] - 2 * pi * k / n) / n;
    const auto on_circle = [&](std::uint32_t k) {
        const CosSin a = cos_sin(offset + 2 * pi * (k % n) / n);
        return Vec2{radius_m * a.cos, radius_m * a.sin};
    };
    for (std::uint32_t k = 0; k < n; ++k) {
        const Side side = side_of(block, k);
        const Vec2 chord = (1 - side.share) * on_circle(side.begin) + side.share * on_circle(side.end);
        block.loop_m.push_back(0.5 *
                               (on_circle(k) + chord));  // between circle (flat corners) and square (kinked rings)
    }
    return block;
}

/// Transfinite interpolation between the four sides.
Vec2 inside(const Block& block, std::uint32_t i, std::uint32_t j) {
    if (2 * i == block.a && 2 * j == block.b) return {0.0, 0.0};  // exactly, whatever the rounding
    const double u = static_cast<double>(i) / block.a;
    const double v = static_cast<double>(j) / block.b;
    const Vec2 sides = (1 - v) * block.bottom(i) + v * block.top(i) + (1 - u) * block.left(j) + u * block.right(j);
    const Vec2 corners = (1 - u) * (1 - v) * block.bottom(0) + u * (1 - v) * block.bottom(block.a) +
                         (1 - u) * v * block.top(0) + u * v * block.top(block.a);
    return sides - corners;
}

void add_quad(Mesh& mesh, std::array<std::uint32_t, 4> quad) {
    mesh.quad.push_back(quad);
    mesh.part.push_back(Part::rim);
}

void add_block(Mesh& mesh, const Block& block) {
    const auto first = static_cast<std::uint32_t>(mesh.node_m.size());
    for (std::uint32_t j = 0; j <= block.b; ++j) {
        for (std::uint32_t i = 0; i <= block.a; ++i) mesh.node_m.push_back(inside(block, i, j));
    }
    for (std::uint32_t j = 0; j < block.b; ++j) {
        for (std::uint32_t i = 0; i < block.a; ++i) {
            add_quad(mesh, {first + block.index(i, j), first + block.index(i + 1, j), first + block.index(i + 1, j + 1),
                            first + block.index(i, j + 1)});
        }
    }
}

/// Rings of quads from the border nodes `inner` to the mesh's first nodes.
void add_rim_rings(Mesh& mesh, std::vector<std::uint32_t> inner, std::int64_t rings) {
    const auto n = static_cast<std::uint32_t>(inner.size());
    const std::vector<std::uint32_t> border = inner;
    for (std::int64_t ring = 1; ring <= rings; ++ring) {
        const double share = static_cast<double>(ring) / static_cast<double>(rings);
        std::vector<std::uint32_t> outer;
        for (std::uint32_t k = 0; k < n; ++k) {
            outer.push_back(ring == rings ? k : static_cast<std::uint32_t>(mesh.node_m.size()));
            const Vec2 point = (1 - share) * mesh.node_m[border[k]] + share * mesh.node_m[k];
            if (ring < rings) mesh.node_m.push_back(point);
        }
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t next = (k + 1) % n;
            add_quad(mesh, {inner[k], outer[k], outer[next], inner[next]});
        }
        inner = outer;
    }
}

}  // namespace

std::uint32_t add_hub_core(Mesh& mesh, const std::vector<double>& angle_rad, double rim_radius_m, std::int64_t rings) {
    const auto n = static_cast<std::uint32_t>(angle_rad.size());
    if (n % 4 != 0 || n < 8) {
        fail_input(
            fmt::format("an elastic rim cannot be meshed with {} columns (a block of quads with a centre node needs "
                        "a multiple of 4, at least 8). Change wheel.gap_columns, pitch_columns or lug_pairs?",
                        n));
    }
    const double thick_as_wide = 1 - 2 * pi * static_cast<double>(rings) / n;  // share of the radius left to the block
    const Block block = lay_out_block(angle_rad, rim_radius_m * std::max(0.4, thick_as_wide));
    const auto first = static_cast<std::uint32_t>(mesh.node_m.size());
    add_block(mesh, block);
    std::vector<std::uint32_t> border;
    for (std::uint32_t k = 0; k < n; ++k) border.push_back(first + block.loop_index(k));
    add_rim_rings(mesh, border, rings);
    return first + block.index(block.a / 2, block.b / 2);
}

}  // namespace ifedem

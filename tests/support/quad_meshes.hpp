#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "fem/elements.hpp"

namespace ifedem::scene {

/// nx × ny quads; `place` maps grid coordinates (i, j) to a position. Node (i, j) has index j (nx + 1) + i.
inline Mesh make_grid(std::uint32_t nx, std::uint32_t ny, const std::function<Vec2(double, double)>& place) {
    Mesh mesh;
    for (std::uint32_t j = 0; j <= ny; ++j) {
        for (std::uint32_t i = 0; i <= nx; ++i) mesh.node_m.push_back(place(i, j));
    }
    for (std::uint32_t j = 0; j < ny; ++j) {
        for (std::uint32_t i = 0; i < nx; ++i) {
            const std::uint32_t k = j * (nx + 1) + i;
            mesh.quad.push_back({k, k + 1, k + nx + 2, k + nx + 1});
            mesh.part.push_back(Part::rim);
        }
    }
    return mesh;
}

inline Mesh make_bar(std::uint32_t nx, std::uint32_t ny, double length_m, double height_m) {
    return make_grid(nx, ny, [=](double i, double j) { return Vec2{length_m * i / nx, height_m * j / ny}; });
}

/// The same material in every part.
inline std::array<Material, 4> everywhere(const Material& m) { return {m, m, m, m}; }

inline std::vector<Vec2> turned(const std::vector<Vec2>& points, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    std::vector<Vec2> result;
    for (const Vec2 p : points) result.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
    return result;
}

/// Positions after adding a fixed, irregular displacement of the given size: no symmetry hides an error.
inline std::vector<Vec2> shaken(std::vector<Vec2> points, double size_m) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double t = static_cast<double>(k) + 1;
        points[k] += size_m * Vec2{std::sin(12.9898 * t), std::cos(78.233 * t * t)};
    }
    return points;
}

inline std::vector<Vec2> find_force(const ElementSet& set, const std::vector<Vec2>& position_m) {
    std::vector<Vec2> force(position_m.size());
    add_internal_force(set, position_m, force);
    return force;
}

inline double largest(const std::vector<Vec2>& v) {
    double result = 0;
    for (const Vec2 a : v) result = std::max({result, std::abs(a.x), std::abs(a.y)});
    return result;
}

}  // namespace ifedem::scene

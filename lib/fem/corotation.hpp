#pragma once
#include <array>
#include <cmath>

#include "fem/elements.hpp"

namespace ifedem {

/// An element's rotated frame: R = [c −s; s c] turns the reference into the mean direction of the current shape.
struct CorotatedFrame {
    double c = 1, s = 0;
    double inverse_stretch = 0;   ///< 1/√((F11+F22)² + (F21−F12)²)
    std::array<double, 8> y_m{};  ///< Rᵀx about the element's mean: x0 y0 x1 y1 …
    std::array<double, 8> d_m{};  ///< Rᵀx − X
};

/// Fixed order, and half the chain of waiting additions that a running sum would have.
inline double add_pairwise(const std::array<double, 4>& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/// `corner_m` are the current positions of the element's nodes. R is the polar rotation of F = ∂x/∂X at the centroid.
/// Cosine and sine come from normalising, never from an angle: no trigonometry, and no jump at ±π.
inline CorotatedFrame find_frame(const Element& e, const std::array<Vec2, 4>& corner_m) {
    const double mean_x = 0.25 * add_pairwise({corner_m[0].x, corner_m[1].x, corner_m[2].x, corner_m[3].x});
    const double mean_y = 0.25 * add_pairwise({corner_m[0].y, corner_m[1].y, corner_m[2].y, corner_m[3].y});
    std::array<double, 4> x{};
    std::array<double, 4> y{};
    std::array<double, 4> stretch{};  // corner shares of F11 + F22
    std::array<double, 4> skew{};     // and of F21 − F12
    for (std::size_t a = 0; a < 4; ++a) {
        x[a] = corner_m[a].x - mean_x;
        y[a] = corner_m[a].y - mean_y;
        stretch[a] = x[a] * e.gradient_1_m[a].x + y[a] * e.gradient_1_m[a].y;
        skew[a] = y[a] * e.gradient_1_m[a].x - x[a] * e.gradient_1_m[a].y;
    }
    const double sum = add_pairwise(stretch);
    const double difference = add_pairwise(skew);
    CorotatedFrame f;
    f.inverse_stretch = 1.0 / std::sqrt(sum * sum + difference * difference);
    f.c = sum * f.inverse_stretch;
    f.s = difference * f.inverse_stretch;
    for (std::size_t a = 0; a < 4; ++a) {
        f.y_m[2 * a] = f.c * x[a] + f.s * y[a];
        f.y_m[2 * a + 1] = f.c * y[a] - f.s * x[a];
        f.d_m[2 * a] = f.y_m[2 * a] - e.reference_m[a].x;
        f.d_m[2 * a + 1] = f.y_m[2 * a + 1] - e.reference_m[a].y;
    }
    return f;
}

/// g = Kᵉ d. Column by column (Kᵉ is symmetric to the bit), so that the eight sums run side by side in vector registers
/// while each keeps its order.
inline std::array<double, 8> multiply_stiffness(const Element& e, const std::array<double, 8>& d_m) {
    std::array<double, 8> g{};
    for (std::size_t j = 0; j < 8; ++j) {
        for (std::size_t i = 0; i < 8; ++i) g[i] += e.stiffness_N_m[8 * j + i] * d_m[j];
    }
    return g;
}

/// −∂U/∂x of one element at its four corners, U = ½ dᵀKᵉd. With g = Kᵉd,
///   ∂U/∂x_a = R g_a + q ∂θ/∂x_a,   q = Σ (g_x y_y − g_y y_x)   (how U changes when only R turns),
///   ∂θ/∂x_a = (−c N_,y − s N_,x, c N_,x − s N_,y) / stretch.
inline std::array<Vec2, 4> internal_force(const Element& e, const std::array<Vec2, 4>& corner_m) {
    const CorotatedFrame f = find_frame(e, corner_m);
    const std::array<double, 8> g = multiply_stiffness(e, f.d_m);
    std::array<double, 4> turn{};
    for (std::size_t a = 0; a < 4; ++a) turn[a] = g[2 * a] * f.y_m[2 * a + 1] - g[2 * a + 1] * f.y_m[2 * a];
    const double q = add_pairwise(turn) * f.inverse_stretch;
    std::array<Vec2, 4> force;
    for (std::size_t a = 0; a < 4; ++a) {
        const Vec2 n = e.gradient_1_m[a];
        force[a].x = -(f.c * g[2 * a] - f.s * g[2 * a + 1]) + q * (f.c * n.y + f.s * n.x);
        force[a].y = -(f.s * g[2 * a] + f.c * g[2 * a + 1]) - q * (f.c * n.x - f.s * n.y);
    }
    return force;
}

inline std::array<Vec2, 4> corners(const Element& e, std::span<const Vec2> position_m) {
    return {position_m[e.node[0]], position_m[e.node[1]], position_m[e.node[2]], position_m[e.node[3]]};
}

/// Smallest of the four corner Jacobians (four times the parametric Jacobian), positive for a convex counter-clockwise
/// quad.
inline double smallest_corner_jacobian_m2(const std::array<Vec2, 4>& p) {
    double smallest = cross(p[1] - p[0], p[3] - p[0]);
    for (std::size_t a = 1; a < 4; ++a) {
        const double here = cross(p[(a + 1) % 4] - p[a], p[(a + 3) % 4] - p[a]);
        smallest = here < smallest ? here : smallest;
    }
    return smallest;
}

}  // namespace ifedem

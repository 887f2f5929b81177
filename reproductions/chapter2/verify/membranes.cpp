// Published problems in plane stress: NAFEMS LE1 (an elliptic membrane under tension) and Cook's membrane. Loads are
// scaled down so that the rotation of the elements' frames does not show, and results are scaled up again.
#include <array>
#include <cmath>

#include "elements.hpp"
#include "support/beams.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

constexpr double le1_MPa = 92.7, cook_rise = 23.97;  ///< published; the sources are named in external.csv

/// σ_y at (2, 0) of LE1 in MPa: a quarter of the ring between the ellipses with half-axes 2, 1 and 3.25, 2.75 m, pulled
/// outwards by 10 MPa. Elements n along the radius, 2n along the arc.
double stretch_ellipse_MPa(std::uint32_t n) {
    constexpr Material steel{210e9, 0.3, 1, 0};
    constexpr double small = 1e-3, pull_Pa = small * 10e6;
    const Mesh mesh = make_grid(n, 2 * n, [n](double i, double j) {
        const double s = i / n, angle = pi / 2 * j / (2 * n);
        return Vec2{(2 + 1.25 * s) * std::cos(angle), (1 + 1.75 * s) * std::sin(angle)};
    });
    const ElementSet set = make_elements(mesh, everywhere(steel), thickness_m, PlaneState::stress);
    Supports supports = make_supports(mesh.node_m.size());
    const auto node = [n](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
    for (std::uint32_t i = 0; i <= n; ++i) supports.held[2 * node(i, 0) + 1] = supports.held[2 * node(i, 2 * n)] = 1;
    for (std::uint32_t j = 0; j < 2 * n; ++j) {
        const Vec2 along = mesh.node_m[node(n, j + 1)] - mesh.node_m[node(n, j)];
        const Vec2 half = (0.5 * pull_Pa * thickness_m) * Vec2{along.y, -along.x};
        supports.load_N[node(n, j)] += half, supports.load_N[node(n, j + 1)] += half;
    }
    StaticState state{mesh.node_m, {}};
    if (find_equilibrium(set, supports, state) != Convergence::reached) return std::nan("");
    // Parabola through the centroids of the three elements next to the edge: their stress is even in y, so that the
    // distance from the axis costs no more than the elements themselves do.
    std::array<double, 3> stress{};
    for (std::uint32_t i = 0; i < 3; ++i)
        stress[i] = centroid_stress_Pa(set.element[i], steel, PlaneState::stress, state.position_m)[1];
    return 1e-6 / small * (15 * stress[0] - 10 * stress[1] + 3 * stress[2]) / 8;
}

/// Rise of the middle of the right side of Cook's membrane (corners (0, 0), (48, 44), (48, 60), (0, 44); E 1, ν 1/3,
/// thickness 1) under a shear force of 1 spread along its right side; n × n elements.
double shear_trapezium(std::uint32_t n) {
    constexpr Material unit{1, 1.0 / 3, 1, 0};
    constexpr double small = 1e-4;
    const Mesh mesh = make_grid(n, n, [n](double i, double j) {
        const double s = i / n, t = j / n, low = 44 * s, high = 44 + 16 * s;
        return Vec2{48 * s, low + t * (high - low)};
    });
    const ElementSet set = make_elements(mesh, everywhere(unit), 1, PlaneState::stress);
    Supports supports = make_supports(mesh.node_m.size());
    for (std::uint32_t j = 0; j <= n; ++j) {
        hold(supports, j * (n + 1));
        supports.load_N[j * (n + 1) + n].y = small / n * (j == 0 || j == n ? 0.5 : 1);
    }
    StaticState state{mesh.node_m, {}};
    if (find_equilibrium(set, supports, state) != Convergence::reached) return std::nan("");
    const std::size_t middle = (n / 2) * (n + 1) + n;
    return (state.position_m[middle].y - mesh.node_m[middle].y) / small;
}

}  // namespace

void measure_membranes(Output& out) {
    std::vector<std::vector<std::string>> rows;
    const auto add_row = [&](const char* name, std::uint32_t n, double error) {
        rows.push_back({name, std::to_string(n), number(std::fabs(error))});
    };
    for (const std::uint32_t n : {1U, 2U, 4U, 8U, 16U}) add_row("cantilever", n, bend_cantilever(n));
    for (const std::uint32_t n : {30U, 60U, 120U, 240U, 480U})
        add_row("ring", n, squeeze_ring(n).along / (pi / 4 - 2 / pi) - 1);
    double ellipse_MPa = 0, rise = 0;
    for (const std::uint32_t n : {4U, 8U, 16U, 32U, 64U}) {
        ellipse_MPa = stretch_ellipse_MPa(n), rise = shear_trapezium(n);
        add_row("ellipse", n, ellipse_MPa / le1_MPa - 1);
        add_row("trapezium", n, rise / cook_rise - 1);
    }
    out.write_table("convergence.csv", "case,elements,error", rows);
    out.add("le1_stress", ellipse_MPa, "MPa", "σ_y at the inner end of the long axis; 64 × 128 quads");
    out.add("cook_rise", rise, "-", "middle of the right side; 64 × 64 quads");
}

}  // namespace ifedem::chapter2

// Eqs 2.4 and 2.5: constant strain, bending, large deflection, rotation, waves.
#include "elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fem/elasticity.hpp"
#include "support/beams.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

void measure_patch(Output& out) {
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
        const PatchErrors e = strain_patch(plane);
        out.add(plane == PlaneState::stress ? "patch_plane_stress" : "patch_plane_strain",
                std::max({e.stress, e.inner_force, e.energy}), "-",
                "worst relative error of stress, inner node force and energy; twelve distorted quads");
    }
}

/// The patch's quads at rest and under the strain, drawn 100 times as large.
void draw_patch(std::vector<std::vector<std::string>>& rows) {
    const Mesh mesh = make_distorted_patch();
    for (const auto& quad : mesh.quad) {
        for (std::size_t a = 0; a <= 4; ++a) {
            const Vec2 p = mesh.node_m[quad[a % 4]];
            const Vec2 moved = p + 100 * Vec2{1e-3 * p.x + 3e-4 * p.y, 3e-4 * p.x - 4e-4 * p.y};
            rows.push_back({"patch", number(p.x), number(p.y), number(moved.x), number(moved.y)});
        }
        rows.push_back({});
    }
}

/// Compressed by 3 % between smooth sides, as the soil elements of chapter 5: E 1.7 MPa, ν 0.3, plane strain.
void measure_confined(Output& out) {
    constexpr Material soil{1.7e6, 0.3, 2195, 0};
    const Mesh mesh = make_distorted_patch();
    const ElementSet set = make_elements(mesh, everywhere(soil), thickness_m, PlaneState::strain);
    std::vector<Vec2> position = mesh.node_m;
    std::vector<std::vector<std::string>> rows;
    double mean = 0;
    for (int percent = 0; percent <= 3; ++percent) {
        for (std::size_t n = 0; n < position.size(); ++n) position[n].y = (1 - 0.01 * percent) * mesh.node_m[n].y;
        mean = 0;
        for (const Element& e : set.element)
            mean -=
                centroid_stress_Pa(e, soil, PlaneState::strain, position)[1] / static_cast<double>(set.element.size());
        rows.push_back({"confined", std::to_string(percent), number(1e-3 * mean), "", ""});
    }
    draw_patch(rows);
    out.write_table("constant_strain.csv", "kind,x,y,moved_x,moved_y", rows);
    out.add("confined_stress", 1e-3 * mean, "kPa", "3 %, E 1.7 MPa, ν 0.3, plane strain");
}

/// Largest node force of one turned square, over E t h: by the code, and by f = K u taken to the letter (Eq 2.4).
struct FalseForce {
    double code = 0, linear = 0;
};
FalseForce turn_square(double angle_rad) {
    const Mesh mesh = make_bar(1, 1, 0.1, 0.1);
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    const std::vector<Vec2> position = turned(mesh.node_m, angle_rad);
    const double unit = rubber.young_Pa * thickness_m * 0.1;
    const Element& e = set.element[0];
    std::array<double, 8> u{};
    Vec2 centre;
    for (const std::uint32_t n : e.node) centre += 0.25 * position[n];
    for (std::size_t a = 0; a < 4; ++a) {
        u[2 * a] = position[e.node[a]].x - centre.x - e.reference_m[a].x;
        u[2 * a + 1] = position[e.node[a]].y - centre.y - e.reference_m[a].y;
    }
    FalseForce f{largest(find_force(set, position)) / unit, 0};
    for (std::size_t i = 0; i < 8; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < 8; ++j) sum += e.stiffness_N_m[8 * i + j] * u[j];
        f.linear = std::fmax(f.linear, std::fabs(sum) / unit);
    }
    return f;
}

void measure_rotation(Output& out) {
    std::vector<std::vector<std::string>> rows;
    double largest_of_code = 0;
    for (double degrees = 1; degrees < 181; degrees += degrees < 10 ? 1 : 5) {
        const FalseForce f = turn_square(degrees * pi / 180);
        largest_of_code = std::fmax(largest_of_code, f.code);
        const double closed = (1 - std::cos(degrees * pi / 180)) / (1 - rubber.poisson) / 2;
        rows.push_back({number(degrees), number(std::fmax(f.code, 1e-18)), number(f.linear), number(closed)});
    }
    out.write_table("rotation.csv", "angle_deg,code,linear,closed", rows);
    out.add("rotation_force", largest_of_code, "-", "largest node force over E t h of a square turned by 1° to 180°");
    out.add("rotation_force_linear", turn_square(pi / 6).linear, "-", "f = K u to the letter, at 30°, over E t h");
}

/// The elastica itself: θ″ = −α cos θ, θ(0) = 0, θ′(1) = 0, by shooting with the midpoint rule. Shortening and rise.
Vec2 integrate_elastica(double alpha) {
    constexpr int steps = 1000;
    constexpr double ds = 1.0 / steps;
    double low = 0, high = alpha;
    Vec2 tip;
    for (int k = 0; k < 50; ++k) {
        double angle = 0, curvature = 0.5 * (low + high);
        tip = {1, 0};
        for (int n = 0; n < steps; ++n) {
            const double middle = angle + 0.5 * ds * curvature;
            tip += ds * Vec2{-std::cos(middle), std::sin(middle)};
            const double half = curvature - 0.5 * ds * alpha * std::cos(angle);
            curvature -= ds * alpha * std::cos(middle);
            angle += ds * half;
        }
        (curvature > 0 ? high : low) = 0.5 * (low + high);
    }
    return tip;
}

void measure_bending(Output& out) {
    const double four = bend_cantilever(4), eight = bend_cantilever(8), sixteen = bend_cantilever(16);
    out.add("cantilever_tip", 1 + eight, "-", "tip deflection over Timoshenko's, 80 × 8 quads");
    out.add("cantilever_order", observed_order(four, eight, sixteen), "-", "in the quad's size: 4, 8, 16 rows");
    std::vector<std::vector<std::string>> rows;
    for (const double alpha : {1.0, 2.0, 4.0, 10.0}) {
        const Vec2 tip = bend_elastica(alpha);
        out.add(fmt::format("elastica_rise_{:g}", alpha), tip.y, "-", "w/L; 220 × 1 quads");
        out.add(fmt::format("elastica_shortening_{:g}", alpha), tip.x, "-", "u/L");
        rows.push_back({"quads", number(alpha), number(tip.y), number(tip.x)});
    }
    for (double alpha = 0.25; alpha < 10.1; alpha += 0.25) {
        const Vec2 tip = integrate_elastica(alpha);
        rows.push_back({"closed", number(alpha), number(tip.y), number(tip.x)});
    }
    out.write_table("elastica.csv", "kind,alpha,rise,shortening", rows);
    const RingGive ring = squeeze_ring();
    out.add("ring_along", ring.along, "-", "P R³/EI; a quarter of 480 quads");
    out.add("ring_across", ring.across, "-", "P R³/EI");
}

void measure_waves(Output& out) {
    const double bar = std::sqrt(rubber.young_Pa / rubber.density_kg_m3), nu = rubber.poisson;
    const double confined = bar * std::sqrt((1 - nu) / ((1 + nu) * (1 - 2 * nu)));
    const Wave thin = strike_bar(PlaneState::stress, 0.005, false, 0.9),
               wide = strike_bar(PlaneState::strain, 0.02, true, 0.9);
    out.add("wave_bar_speed", thin.speed_m_s / bar, "-", "over √(E/ρ); plane stress, 400 quads");
    out.add("wave_bar_stress", -thin.stress_Pa / (rubber.density_kg_m3 * bar * 1e-3), "-", "over ρ c v0");
    out.add("wave_confined_speed", wide.speed_m_s / confined, "-", "over √(E(1−ν)/((1+ν)(1−2ν)ρ)); plane strain");
    out.add("wave_confined_stress", -wide.stress_Pa / (rubber.density_kg_m3 * confined * 1e-3), "-", "over ρ c v0");
}

}  // namespace

void measure_elements(Output& out, Effort) {
    measure_patch(out);
    measure_confined(out);
    measure_rotation(out);
    measure_bending(out);
    measure_membranes(out);
    measure_waves(out);
    measure_exact_waves(out);
}

}  // namespace ifedem::chapter2

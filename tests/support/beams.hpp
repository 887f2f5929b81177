// Patches, beams, rings and bars of quads with known answers.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/bitmath.hpp"
#include "fem/elements.hpp"
#include "fem/equilibrium.hpp"
#include "support/quad_meshes.hpp"

namespace ifedem::scene {

inline constexpr Material rubber{4e6, 0.3, 1200, 0};
inline constexpr double thickness_m = 0.1;

inline Supports make_supports(std::size_t nodes) {
    return {std::vector<std::uint8_t>(2 * nodes, 0), std::vector<Vec2>(nodes)};
}

inline void hold(Supports& supports, std::size_t node) { supports.held[2 * node] = supports.held[2 * node + 1] = 1; }

/// 4 × 3 quads with every inner node moved: no two alike, none a parallelogram.
inline Mesh make_distorted_patch() {
    Mesh mesh = make_bar(4, 3, 0.4, 0.3);
    const std::vector<Vec2> moved = scene::shaken(mesh.node_m, 0.02);
    for (std::uint32_t j = 1; j < 3; ++j) {
        for (std::uint32_t i = 1; i < 4; ++i) mesh.node_m[j * 5 + i] = moved[j * 5 + i];
    }
    return mesh;
}

inline bool is_inner(const Mesh& mesh, std::size_t node) {
    const Vec2 p = mesh.node_m[node];
    return p.x > 1e-9 && p.x < 0.4 - 1e-9 && p.y > 1e-9 && p.y < 0.3 - 1e-9;
}

/// Cantilever of nx × ny quads, held at x = 0, with an end load spread as a beam's parabolic shear; tip position.
struct Cantilever {
    Mesh mesh;
    ElementSet set;
    Supports supports;
    StaticState state;
    std::uint32_t nx = 0, ny = 0;

    Cantilever(std::uint32_t columns, std::uint32_t rows, double length_m, double height_m, const Material& m)
        : mesh(make_bar(columns, rows, length_m, height_m)), nx(columns), ny(rows) {
        set = make_elements(mesh, everywhere(m), thickness_m, PlaneState::stress);
        supports = make_supports(mesh.node_m.size());
        for (std::uint32_t j = 0; j <= ny; ++j) hold(supports, j * (nx + 1));
        state = {mesh.node_m, {}};
    }
    void load(double force_N) {
        const auto shear_until = [](double s) { return s * s * (3 - 2 * s); };  // ∫ 6 s (1 − s)
        for (std::uint32_t j = 0; j <= ny; ++j) {
            const double below = std::max(0.0, (j - 0.5) / ny), above = std::min(1.0, (j + 0.5) / ny);
            supports.load_N[j * (nx + 1) + nx].y = force_N * (shear_until(above) - shear_until(below));
        }
    }
    [[nodiscard]] Vec2 tip_move_m() const {  // of the middle of the end
        Vec2 sum;
        for (const std::uint32_t j : {0U, ny}) {
            const std::uint32_t k = j * (nx + 1) + nx;
            sum += 0.5 * (state.position_m[k] - mesh.node_m[k]);
        }
        return sum;
    }
};

/// Tip of a cantilever under a small end load over Timoshenko's, less 1; `rows` rows of square quads.
inline double bend_cantilever(std::uint32_t rows) {
    constexpr double length = 1, height = 0.1, force = 1e-3;  // deflection 1e-5 m: linear
    const double inertia = thickness_m * height * height * height / 12, area = thickness_m * height;
    const double shear = rubber.young_Pa / (2 * (1 + rubber.poisson));
    const double kappa = 10 * (1 + rubber.poisson) / (12 + 11 * rubber.poisson);  // rectangle, Cowper 1966
    const double expected =
        force * length * length * length / (3 * rubber.young_Pa * inertia) + force * length / (kappa * shear * area);
    Cantilever beam(10 * rows, rows, length, height, rubber);
    beam.load(force);
    if (find_equilibrium(beam.set, beam.supports, beam.state) != Convergence::reached) return std::nan("");
    return beam.tip_move_m().y / expected - 1;
}

/// Rise and shortening of a slender cantilever, over its length, under an end load α = P L²/EI (Euler's elastica).
/// Bilinear quads of length l lock by ½ (l/H)² with ν = 0, whatever their height: 0.4 % at l = H/11.
inline Vec2 bend_elastica(double alpha) {
    constexpr std::uint32_t columns = 220;
    constexpr double length = 1, height = 0.05;
    const Material m{4e6, 0, 1200, 0};
    Cantilever beam(columns, 1, length, height, m);
    const double stiffness = m.young_Pa * thickness_m * height * height * height / 12;
    const int increments = static_cast<int>(std::ceil(4 * alpha));
    for (int k = 1; k <= increments; ++k) {
        beam.load(alpha * stiffness / (length * length) * k / increments);
        if (find_equilibrium(beam.set, beam.supports, beam.state) != Convergence::reached)
            return {std::nan(""), std::nan("")};
    }
    return {-beam.tip_move_m().x / length, beam.tip_move_m().y / length};
}

/// Change of a thin ring's diameters along and across a diametral load, in P R³/EI.
struct RingGive {
    double along = 0, across = 0;
};

/// A quarter of the ring, inextensional in theory: π/4 − 2/π along the load, 2/π − 1/2 across it.
inline RingGive squeeze_ring(std::uint32_t columns = 480) {
    constexpr double radius = 1, height = 0.04, force = 1e-3;
    const Material m{4e6, 0, 1200, 0};
    const Mesh mesh = make_grid(columns, 1, [=](double i, double j) {
        const double angle = pi / 2 * (1 - i / columns);  // from the load at the top clockwise, so outwards is +j
        const double r = radius + height * (j - 0.5);
        return Vec2{r * std::cos(angle), r * std::sin(angle)};
    });
    const ElementSet set = make_elements(mesh, everywhere(m), thickness_m, PlaneState::stress);
    Supports supports = make_supports(mesh.node_m.size());
    for (const std::uint32_t row : {0U, columns + 1}) {
        supports.held[2 * row] = 1;                  // x at the top
        supports.held[2 * (row + columns) + 1] = 1;  // y at the side
        supports.load_N[row].y = -0.25 * force;      // half the load on this quarter, on two nodes
    }
    StaticState state{mesh.node_m, {}};
    if (find_equilibrium(set, supports, state) != Convergence::reached) return {std::nan(""), std::nan("")};
    const auto mean_move = [&](std::uint32_t k) {
        return 0.5 * (state.position_m[k] - mesh.node_m[k] + state.position_m[k + columns + 1] -
                      mesh.node_m[k + columns + 1]);
    };
    const double unit = force * radius * radius * radius / (m.young_Pa * thickness_m * height * height * height / 12);
    return {-2 * mean_move(0).y / unit, 2 * mean_move(columns).x / unit};
}

/// Central difference (leapfrog) with held coordinates; `velocity_m_s` is half a step behind the positions.
struct Motion {
    const ElementSet& set;
    std::vector<Vec2> position_m, velocity_m_s;
    std::vector<std::uint8_t> held;

    void step(double dt_s) {
        const std::vector<Vec2> force = find_force(set, position_m);
        for (std::size_t k = 0; k < force.size(); ++k) {
            Vec2 change = (dt_s / set.mass_kg[k]) * force[k];
            if (!held.empty() && held[2 * k] != 0) change.x = 0;
            if (!held.empty() && held[2 * k + 1] != 0) change.y = 0;
            velocity_m_s[k] += change;
            position_m[k] += dt_s * velocity_m_s[k];
        }
    }
    [[nodiscard]] double kinetic_J() const {
        double sum = 0;
        for (std::size_t k = 0; k < velocity_m_s.size(); ++k) {
            sum += 0.5 * set.mass_kg[k] * dot(velocity_m_s[k], velocity_m_s[k]);
        }
        return sum;
    }
    [[nodiscard]] double spin() const {  // angular momentum, kg m²/s
        double sum = 0;
        for (std::size_t k = 0; k < velocity_m_s.size(); ++k) {
            sum += set.mass_kg[k] * cross(position_m[k], velocity_m_s[k]);
        }
        return sum;
    }
};

/// A bar struck at x = 0 by the speed v0: speed of the front between two stations, and the stress behind it.
struct Wave {
    double speed_m_s = 0;
    double stress_Pa = 0;
};

inline Wave strike_bar(PlaneState plane, double height_m, bool confined, double step_share) {
    constexpr std::uint32_t columns = 400;
    constexpr double length = 1, v0 = 1e-3;
    const Mesh mesh = make_bar(columns, 1, length, height_m);
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, plane);
    Motion motion{set, mesh.node_m, std::vector<Vec2>(mesh.node_m.size()), {}};
    motion.held.assign(2 * mesh.node_m.size(), 0);
    for (const std::uint32_t row : {0U, columns + 1}) {
        motion.held[2 * row] = 1;
        motion.velocity_m_s[row].x = v0;
        for (std::uint32_t i = 0; confined && i <= columns; ++i) motion.held[2 * (row + i) + 1] = 1;
    }
    const double dt = step_share * stable_step(set).step_s;
    std::array<double, 2> arrival{};
    double previous[2] = {0, 0};
    constexpr std::array<std::uint32_t, 2> station{columns / 4, 3 * columns / 4};
    for (int k = 1; arrival[1] == 0 && k < 100000; ++k) {
        motion.step(dt);
        for (std::size_t s = 0; s < 2; ++s) {
            const double v = motion.velocity_m_s[station[s]].x;
            if (arrival[s] == 0 && v >= v0 / 2) arrival[s] = dt * (k - (v - v0 / 2) / (v - previous[s]));
            previous[s] = v;
        }
    }
    Wave wave{length / 2 / (arrival[1] - arrival[0]), 0};
    for (std::uint32_t i = columns / 4; i < columns / 2; ++i) {
        wave.stress_Pa += centroid_stress_Pa(set.element[i], rubber, plane, motion.position_m)[0] / (columns / 4);
    }
    return wave;
}

/// One square element, stretched a little and let go: its largest strain energy in 300 steps over the first. `share`
/// is the step over 2 √(m (1 − ν) / (4 E t)), the limit of its stiffest mode, dilatation.
struct Swing {
    double limit_s = 0;
    double largest = 0;
};
inline Swing swing_element(double share) {
    const Mesh mesh = make_bar(1, 1, 0.1, 0.1);
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, PlaneState::stress);
    const double mass = rubber.density_kg_m3 * thickness_m * 0.01;
    const double limit = 2 * std::sqrt(mass / 4 * (1 - rubber.poisson) / (rubber.young_Pa * thickness_m));
    Motion motion{set, mesh.node_m, std::vector<Vec2>(4), {}};
    for (Vec2& p : motion.position_m) p = (1 + 1e-9) * p;
    const double begin = strain_energy_J(set, motion.position_m);
    double most = 0;
    for (int k = 0; k < 300; ++k) {
        motion.step(share * limit);
        most = std::max(most, strain_energy_J(set, motion.position_m));
    }
    return {limit, most / begin};
}

/// How far a patch of distorted quads is from a constant strain that it should carry exactly, relative errors.
struct PatchErrors {
    double stress = 0, inner_force = 0, energy = 0;
};
inline PatchErrors strain_patch(PlaneState plane) {
    const Mesh mesh = make_distorted_patch();
    constexpr double e1 = 1e-3, e2 = -4e-4, half_gamma = 3e-4;  // symmetric gradient: the rotation is exactly 1
    const ElementSet set = make_elements(mesh, everywhere(rubber), thickness_m, plane);
    std::vector<Vec2> position;
    for (const Vec2 p : mesh.node_m)
        position.push_back({p.x + e1 * p.x + half_gamma * p.y, p.y + half_gamma * p.x + e2 * p.y});
    const double e = rubber.young_Pa, nu = rubber.poisson;
    const double scale = plane == PlaneState::stress ? e / (1 - nu * nu) : e / ((1 + nu) * (1 - 2 * nu));
    const double major = plane == PlaneState::stress ? 1 : 1 - nu;
    const double sx = scale * (major * e1 + nu * e2), sy = scale * (major * e2 + nu * e1);
    const double txy = e / (1 + nu) * half_gamma;
    PatchErrors errors;
    for (const Element& element : set.element) {
        const auto stress = centroid_stress_Pa(element, rubber, plane, position);
        for (const double off : {stress[0] - sx, stress[1] - sy, stress[2] - txy})
            errors.stress = std::max(errors.stress, std::abs(off) / (scale * e1));
    }
    const std::vector<Vec2> force = find_force(set, position);
    for (std::size_t k = 0; k < force.size(); ++k)
        if (is_inner(mesh, k)) errors.inner_force = std::max(errors.inner_force, norm(force[k]) / largest(force));
    const double energy = 0.5 * (sx * e1 + sy * e2 + 2 * txy * half_gamma) * 0.4 * 0.3 * thickness_m;
    errors.energy = std::abs(strain_energy_J(set, position) / energy - 1);
    return errors;
}

}  // namespace ifedem::scene

// Eqs 2.17 and 2.18 once more, from the text and in vectors, all pairs and no lists: what the fast code is compared
// with.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "dem/dem_constants.hpp"
#include "model/state.hpp"

namespace ifedem::reference {

struct Force {
    Vec2 force_N;
    double moment_Nm = 0;
    double rolling_limit_Nm = 0;
};

/// A body in contact: a disc, or a wall (infinite mass and, if flat, infinite radius = 0 here).
struct Body {
    Vec2 centre_m, velocity_m_s;
    double omega_rad_s = 0, radius_m = 0, inverse_mass_1_kg = 0;
};
inline Body to_body(const Disc& d) {
    return {{d.x_m, d.y_m}, {d.vx_m_s, d.vy_m_s}, d.omega_rad_s, d.radius_m, d.inverse_mass_1_kg};
}

struct Touching {
    Vec2 normal;  ///< unit, from a to b
    double overlap_m = 0;
    double arm_a_m = 0, arm_b_m = 0;
    double half_chord_m = 0;
};

/// The force of b on a and the new tangential spring. The contact point divides the distance of two discs
/// as their radii do and is the foot on a flat wall.
inline Force contact(const ContactConstants& k, double damping_ratio, double step_s, const Body& a, const Body& b,
                     const Touching& touch, double& spring_m) {
    const Vec2 n = touch.normal, t{-n.y, n.x};
    const Vec2 va = a.velocity_m_s + cross(a.omega_rad_s, touch.arm_a_m * n);
    const Vec2 vb = b.velocity_m_s + cross(b.omega_rad_s, -touch.arm_b_m * n);
    const double reduced = 1.0 / (a.inverse_mass_1_kg + b.inverse_mass_1_kg);
    const double cn = 2 * damping_ratio * std::sqrt(k.normal_stiffness_N_m * reduced);
    const double cs = 2 * damping_ratio * std::sqrt(k.tangential_stiffness_N_m * reduced);
    const double closing = dot(va - vb, n), sliding = dot(va - vb, t);
    const double fn = std::max(k.normal_stiffness_N_m * touch.overlap_m + cn * closing, k.smallest_normal_N);
    const double cap = k.friction * std::max(fn, 0.0);
    spring_m =
        std::clamp(spring_m + sliding * step_s, -cap / k.tangential_stiffness_N_m, cap / k.tangential_stiffness_N_m);
    const double ft = std::clamp(k.tangential_stiffness_N_m * spring_m + cs * sliding, -cap, cap);
    return {-fn * n - ft * t, -ft * touch.arm_a_m,
            2 * k.rolling_chords * touch.half_chord_m * k.normal_stiffness_N_m * touch.overlap_m};
}

/// All contacts of a set of discs known by id, springs by (lower id, higher id) and by (id, wall).
struct Dem {
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> pair_spring_m;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> wall_spring_m;
    std::vector<Force> force;  ///< by id, gravity excluded

    /// Evaluates every contact and advances its spring; those that have ended are forgotten.
    void evaluate(const DemConstants& k, const std::vector<Disc>& by_id, double step_s) {
        force.assign(by_id.size(), {});
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> pairs, walls;
        for (std::uint32_t a = 0; a < by_id.size(); ++a) {
            for (std::uint32_t b = a + 1; b < by_id.size(); ++b) add_pair(k, by_id, a, b, step_s, pairs);
            const auto count = static_cast<std::uint32_t>(k.flat_walls.size() + k.wall_discs.size());
            for (std::uint32_t w = 0; w < count; ++w) add_wall(k, by_id, a, w, step_s, walls);
        }
        pair_spring_m.swap(pairs);
        wall_spring_m.swap(walls);
    }

private:
    /// Half the common chord of two circles from the circle equations.
    static double half_chord(double ra, double rb, double distance) {
        const double x = (distance * distance + ra * ra - rb * rb) / (2 * distance);
        return std::sqrt(std::max((ra - x) * (ra + x), 0.0));
    }

    void add_pair(const DemConstants& k, const std::vector<Disc>& by_id, std::uint32_t a, std::uint32_t b,
                  double step_s, std::map<std::pair<std::uint32_t, std::uint32_t>, double>& springs) {
        const Body ba = to_body(by_id[a]), bb = to_body(by_id[b]);
        const Vec2 to_b = bb.centre_m - ba.centre_m;
        const double distance = norm(to_b), overlap = ba.radius_m + bb.radius_m - distance;
        if (overlap <= 0) return;
        double spring = pair_spring_m.count({a, b}) != 0 ? pair_spring_m[{a, b}] : 0.0;
        const double lever = distance / (ba.radius_m + bb.radius_m);
        const Touching touch{(1 / distance) * to_b, overlap, lever * ba.radius_m, lever * bb.radius_m,
                             half_chord(ba.radius_m, bb.radius_m, distance)};
        const Force f = contact(k.soil, k.damping_ratio, step_s, ba, bb, touch, spring);
        springs[{a, b}] = spring;
        force[a].force_N += f.force_N, force[b].force_N -= f.force_N;
        force[a].moment_Nm += f.moment_Nm, force[b].moment_Nm += f.moment_Nm / touch.arm_a_m * touch.arm_b_m;
        force[a].rolling_limit_Nm += f.rolling_limit_Nm, force[b].rolling_limit_Nm += f.rolling_limit_Nm;
    }

    void add_wall(const DemConstants& k, const std::vector<Disc>& by_id, std::uint32_t a, std::uint32_t w,
                  double step_s, std::map<std::pair<std::uint32_t, std::uint32_t>, double>& springs) {
        const Body ba = to_body(by_id[a]);
        const double r = ba.radius_m;
        Touching touch;
        const std::size_t flat = k.flat_walls.size();
        if (w < flat) {
            const double height = dot(ba.centre_m - k.flat_walls[w].point_m, k.flat_walls[w].normal);
            touch = {-1.0 * k.flat_walls[w].normal, r - height, height, 0,
                     std::sqrt(std::max((r - height) * (r + height), 0.0))};
        } else {
            const Vec2 to_wall = k.wall_discs[w - flat].centre_m - ba.centre_m;
            const double distance = norm(to_wall), overlap = r + k.wall_discs[w - flat].radius_m - distance;
            const double opposite = k.wall_discs[w - flat].radius_m, lever = distance / (r + opposite);
            touch = {(1 / distance) * to_wall, overlap, lever * r, lever * opposite,
                     half_chord(r, k.wall_discs[w - flat].radius_m, distance)};
        }
        if (touch.overlap_m <= 0) return;
        double spring = wall_spring_m.count({a, w}) != 0 ? wall_spring_m[{a, w}] : 0.0;
        const Force f = contact(k.wall, k.damping_ratio, step_s, ba, Body{}, touch, spring);
        springs[{a, w}] = spring;
        force[a].force_N += f.force_N;
        force[a].moment_Nm += f.moment_Nm, force[a].rolling_limit_Nm += f.rolling_limit_Nm;
    }
};

/// The discs of a state in the order of their numbers.
inline std::vector<Disc> by_id(const State& state) {
    std::vector<Disc> discs(state.discs.disc.size());
    for (std::size_t p = 0; p < discs.size(); ++p) discs[state.discs.id[p]] = state.discs.disc[p];
    return discs;
}

}  // namespace ifedem::reference

// A bar of one row of quads whose end is driven at v0. With ν = 0 it is a chain of lumped masses and springs, stable up
// to Δt = l/c, and there the central difference (Eqs 2.7, 2.8) carries the wave from node to node without any error.
#include <cmath>

#include "elements.hpp"
#include "support/beams.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

constexpr std::uint32_t quads = 40;
constexpr double length_m = 1, quad_m = length_m / quads, drive_m_s = 1e-3;
constexpr Material material{4e6, 0, 1200, 0};

/// Twice as high as its quads are long, so that the axial modes are the stiffest.
struct Bar {
    Mesh mesh = make_bar(quads, 1, length_m, 2 * quad_m);
    ElementSet set = make_elements(mesh, everywhere(material), thickness_m, PlaneState::stress);
    double speed_m_s = std::sqrt(material.young_Pa / material.density_kg_m3);

    [[nodiscard]] Motion drive(bool far_end_held) const {
        Motion motion{set, mesh.node_m, std::vector<Vec2>(mesh.node_m.size()), {}};
        motion.held.assign(2 * mesh.node_m.size(), 0);
        for (const std::uint32_t row : {0U, quads + 1}) {
            for (std::uint32_t i = 0; i <= quads; ++i) motion.held[2 * (row + i) + 1] = 1;
            motion.held[2 * row] = 1;
            motion.velocity_m_s[row].x = drive_m_s;
            if (far_end_held) motion.held[2 * (row + quads)] = 1;
        }
        return motion;
    }
};

/// Velocity of node `node` in step `step` (from 1) over v0: the wave passes, and comes back from the free end.
double closed_velocity(std::uint32_t node, int step) {
    const int j = static_cast<int>(node), n = static_cast<int>(quads);
    return (step > j ? 1 : 0) + (step > 2 * n - j ? 1 : 0);
}

double largest_velocity_error(const Bar& bar) {
    Motion motion = bar.drive(false);
    double worst = 0;
    for (int step = 1; step < 2 * static_cast<int>(quads); ++step) {
        motion.step(quad_m / bar.speed_m_s);
        for (std::uint32_t j = 0; j <= quads; ++j)
            worst = std::fmax(worst, std::fabs(motion.velocity_m_s[j].x / drive_m_s - closed_velocity(j, step)));
    }
    return worst;
}

/// Mean axial stress of the last five quads after half the wave's way back, over ρ c v0, compression > 0.
double stress_at_held_end(const Bar& bar) {
    Motion motion = bar.drive(true);
    for (std::uint32_t step = 0; step < 3 * quads / 2; ++step) motion.step(quad_m / bar.speed_m_s);
    double stress_Pa = 0;
    for (std::uint32_t i = quads - 5; i < quads; ++i)
        stress_Pa += centroid_stress_Pa(bar.set.element[i], material, PlaneState::stress, motion.position_m)[0] / 5;
    return -stress_Pa / (material.density_kg_m3 * bar.speed_m_s * drive_m_s);
}

double velocity_at_free_end(const Bar& bar) {
    Motion motion = bar.drive(false);
    for (std::uint32_t step = 0; step < 3 * quads / 2; ++step) motion.step(quad_m / bar.speed_m_s);
    return motion.velocity_m_s[quads].x / drive_m_s;
}

/// Largest stable step over l/c of a bar that nothing holds, by bisection: held ends take away the stiffest mode. 4000
/// steps tell a step 10⁻⁵ beyond the limit.
double measured_limit(const Bar& bar) {
    double low = 0.9, high = 1.1;
    for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (low + high);
        Motion motion = bar.drive(false);
        motion.held[0] = motion.held[2 * (quads + 1)] = 0;
        double largest_speed = 0;
        for (int step = 0; step < 4000 && largest_speed < 1e6; ++step) {
            motion.step(middle * quad_m / bar.speed_m_s);
            if (step % 20 == 0) largest_speed = std::fmax(largest_speed, largest(motion.velocity_m_s) / drive_m_s);
        }
        (largest_speed < 1e6 ? low : high) = middle;
    }
    return low;
}

/// Profiles when the front is at six tenths of the bar, at the largest step and at half of it.
void draw_profiles(Output& out, const Bar& bar) {
    std::vector<std::vector<std::string>> rows;
    for (const int share : {1, 2}) {
        Motion motion = bar.drive(false);
        for (std::uint32_t step = 0; step < 6 * quads / 10 * static_cast<std::uint32_t>(share); ++step)
            motion.step(quad_m / bar.speed_m_s / share);
        for (std::uint32_t j = 0; j <= quads; ++j)
            rows.push_back({std::to_string(share), number(j * quad_m), number(motion.velocity_m_s[j].x / drive_m_s)});
    }
    out.write_table("wave.csv", "steps_a_quad,x_m,velocity", rows);
}

}  // namespace

void measure_exact_waves(Output& out) {
    const Bar bar;
    out.add("wave_nodal_error", largest_velocity_error(bar), "-",
            "worst error of v/v0 over 41 nodes and 79 steps of l/c, reflection included");
    out.add("wave_free_end", velocity_at_free_end(bar), "-", "velocity of the free end over v0 after the reflection");
    out.add("wave_held_end", stress_at_held_end(bar), "-", "stress at the held end over ρ c v0 after the reflection");
    out.add("bar_limit", measured_limit(bar), "-", "largest stable step over l/c, bisection");
    draw_profiles(out, bar);
}

}  // namespace ifedem::chapter2

#include "dem/forces.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "dem/pair_kernel.hpp"

namespace ifedem {
namespace {

void add_force(DiscForce& to, const DiscForce& f) {
    to.x_N += f.x_N, to.y_N += f.y_N;
    to.turning_N += f.turning_N, to.rolling_Nm += f.rolling_Nm;
}

void add_walls(const DemConstants& k, const Block& block, State& state, DemWorkspace& work, double spring_step_s) {
    for (std::uint32_t n = block.wall_begin; n < block.wall_end; ++n) {
        const Disc& d = state.discs.disc[work.wall[n].position];
        double& spring = state.wall_contacts[n].tangential_m;
        const WallSide side = find_wall_side(k, work.wall[n].wall, d);
        const BoundaryForce f = boundary_force(k.wall, k.damping_ratio, d, side.normal, side.distance_m,
                                               side.opposite_radius_m, side.velocity_m_s, spring, spring_step_s);
        spring = f.tangential_spring_m;
        add_force(work.force[block.slot(work.wall[n].position)], f.on_disc());
    }
}

/// One block's forces in list order, to the block's own slots.
void add_block_forces(const DemConstants& k, const Block& block, State& state, DemWorkspace& work,
                      double spring_step_s) {
    std::fill(work.force.begin() + block.force_begin, work.force.begin() + block.force_end, DiscForce{});
    add_walls(k, block, state, work, spring_step_s);
    PairBatch batch;
    batch.disc = state.discs.disc.data();
    batch.i = work.i.data(), batch.j = work.j.data();
    batch.damping_Ns_m = work.damping_Ns_m.data();
    batch.spring_m = state.pairs.tangential_m.data();
    batch.rolling_Nm = k.rolling_springs ? work.rolling_Nm.data() : nullptr;
    batch.force = work.force.data() + (block.force_begin - block.disc_begin);  // slots before: no fewer than discs
    batch.begin = block.pair_begin, batch.end = block.pair_end;
    batch.spring_step_s = spring_step_s;
    work.pair_kernel(k.soil, batch);
}

/// What other blocks and the wheel hold for this one.
void merge_block(const Block& block, DemWorkspace& work) {
    for (std::uint32_t n = block.merge_begin; n < block.merge_end; ++n)
        add_force(work.force[work.merge[n].target], work.force[work.merge[n].slot]);
    const auto before = [](const WheelForce& f, std::uint32_t position) { return f.position < position; };
    auto at = std::lower_bound(work.wheel_force.begin(), work.wheel_force.end(), block.disc_begin, before);
    for (; at != work.wheel_force.end() && at->position < block.disc_end; ++at)
        add_force(work.force[block.slot(at->position)], at->on_disc);
}

}  // namespace

void add_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s,
                const BlockVisitor& finished, const Alongside& alongside) {
    const auto finish = [&](Block& block) {
        merge_block(block, work);
        finished(block);
    };
    const std::size_t count = work.block.size();
    const auto first_block_of = [&](int thread, int threads) -> std::size_t {
        if (thread == threads) return count;
        const double all = static_cast<double>(count) + alongside.blocks;
        return static_cast<std::size_t>(max_of(0.0, all * thread / threads - alongside.blocks));
    };
#pragma omp parallel
    {
        const int threads = omp_get_num_threads(), thread = omp_get_thread_num();
        const std::size_t begin = first_block_of(thread, threads), end = first_block_of(thread + 1, threads);
        if (thread == 0 && alongside.work) alongside.work();
        // A block waits for the blocks that reach into it: those of this thread are done when its own turn comes,
        // those of other threads after the barrier.
        for (std::size_t b = begin; b < end; ++b) {
            add_block_forces(k, work.block[b], state, work, spring_step_s);
            if (work.block[b].first_source >= begin) finish(work.block[b]);
        }
#pragma omp barrier
        for (std::size_t b = begin; b < end; ++b)
            if (work.block[b].first_source < begin) finish(work.block[b]);
    }
}

BoundaryForce boundary_force(const ContactConstants& k, double damping_ratio, const Disc& disc, Vec2 normal,
                             double centre_distance_m, double opposite_radius_m, Vec2 surface_velocity_m_s,
                             double old_spring_m, double spring_step_s) {
    BoundaryForce out;
    out.overlap_m = (disc.radius_m + opposite_radius_m) - centre_distance_m;
    if (out.overlap_m <= 0) return out;
    // A straight surface is the limit of a large circle: its chord is that of the disc cut by the line.
    const double chord = opposite_radius_m > 0
                             ? root(max_of(chord_product(centre_distance_m, centre_distance_m * centre_distance_m,
                                                         out.overlap_m, disc.radius_m, opposite_radius_m),
                                           0.0)) /
                                   centre_distance_m
                             : 2.0 * root(max_of(out.overlap_m * (2.0 * disc.radius_m - out.overlap_m), 0.0));
    // The contact point divides the distance to another disc as the radii do; on a straight surface it is the foot.
    const double lever =
        centre_distance_m / (opposite_radius_m > 0 ? disc.radius_m + opposite_radius_m : disc.radius_m);
    const double arm = lever * disc.radius_m;
    const Vec2 tangent{-normal.y, normal.x};
    const Vec2 u = Vec2{disc.vx_m_s, disc.vy_m_s} - surface_velocity_m_s;
    const double damping = dashpot_Ns_m(damping_ratio, k.normal_stiffness_N_m, 1.0 / disc.inverse_mass_1_kg);
    const auto f = contact_forces(k, out.overlap_m, dot(u, normal), dot(u, tangent) + disc.omega_rad_s * arm, damping,
                                  old_spring_m, spring_step_s, chord);
    out.force_N = Vec2{0, 0} - (f.normal_N * normal + f.tangential_N * tangent);
    out.turning_N = -f.tangential_N * lever;
    out.moment_Nm = -f.tangential_N * arm;
    out.rolling_limit_Nm = f.rolling_limit_Nm;
    out.tangential_spring_m = f.tangential_spring_m;
    out.normal_N = f.normal_N, out.tangential_N = f.tangential_N, out.arm_m = arm;
    return out;
}

WallSide find_wall_side(const DemConstants& k, std::uint32_t wall, const Disc& d) {
    const Vec2 centre{d.x_m, d.y_m};
    if (wall < k.flat_walls.size()) {
        const Vec2 normal = Vec2{0, 0} - k.flat_walls[wall].normal;
        return {normal, dot(k.flat_walls[wall].point_m - centre, normal), 0.0};
    }
    const WallDisc& other = k.wall_discs[wall - k.flat_walls.size()];
    const Vec2 to_wall = other.centre_m - centre;
    const double distance = norm(to_wall);
    return {(1.0 / distance) * to_wall, distance, other.radius_m, other.velocity_m_s};
}

}  // namespace ifedem

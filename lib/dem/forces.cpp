#include "dem/forces.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dem/pair_kernel.hpp"

namespace ifedem {
namespace {

void add_force(DiscForce& to, const DiscForce& f) {
    to.x_N += f.x_N, to.y_N += f.y_N;
    to.turning_N += f.turning_N, to.rolling_Nm += f.rolling_Nm;
}

/// A block's slots begin with those of its own discs; behind them stand those of its halo.
void add_walls(const DemConstants& k, const Block& block, State& state, const DemWorkspace& work, double spring_step_s,
               DiscForce* slots) {
    for (std::uint32_t n = block.wall_begin; n < block.wall_end; ++n) {
        const Disc& d = state.discs.disc[work.wall[n].position];
        double& spring = state.wall_contacts[n].tangential_m;
        const WallSide side = find_wall_side(k, work.wall[n].wall, d);
        const BoundaryForce f = boundary_force(k.wall, k.damping_ratio, d, side.normal, side.distance_m,
                                               side.opposite_radius_m, side.velocity_m_s, spring, spring_step_s);
        spring = f.tangential_spring_m;
        add_force(slots[work.wall[n].position - block.disc_begin], f.on_disc());
    }
}

/// Where the slot of list position 0 would be: the kernel need not subtract. Nothing there is read or written, and a
/// number may leave the array where a pointer must not.
DiscForce* first_position(DiscForce* slots, const Block& block) {
    const auto at = reinterpret_cast<std::uintptr_t>(slots) - block.disc_begin * sizeof(DiscForce);
    return reinterpret_cast<DiscForce*>(at);  // NOLINT(performance-no-int-to-ptr)
}

/// One block's forces in list order. Its halo moves out, so that its slots can serve the next block while they are in
/// the cache: all blocks' slots would be another 32 bytes a disc to fetch and to write back.
void add_block_forces(const DemConstants& k, const Block& block, State& state, DemWorkspace& work, double spring_step_s,
                      DiscForce* slots) {
    add_walls(k, block, state, work, spring_step_s, slots);
    PairBatch batch;
    batch.disc = state.discs.disc.data();
    batch.i = work.i.data(), batch.j = work.j.data();
    batch.damping_Ns_m = work.damping_Ns_m.data();
    batch.spring_m = state.pairs.tangential_m.data();
    batch.rolling_Nm = k.rolling_springs ? work.rolling_Nm.data() : nullptr;
    batch.force = first_position(slots, block);
    batch.begin = block.pair_begin, batch.end = block.pair_end;
    batch.spring_step_s = spring_step_s;
    work.pair_kernel(k.soil, batch);
    DiscForce *const halo = slots + block.size(), *const end = halo + (block.halo_end - block.halo_begin);
    std::copy(halo, end, work.halo.data() + block.halo_begin);
    std::fill(halo, end, DiscForce{});
}

/// What other blocks and the wheel hold for this one.
void merge_block(const Block& block, const DemWorkspace& work, DiscForce* slots) {
    for (std::uint32_t n = block.merge_begin; n < block.merge_end; ++n)
        add_force(slots[work.merge[n].target - block.disc_begin], work.halo[work.merge[n].halo]);
    const auto before = [](const WheelForce& f, std::uint32_t position) { return f.position < position; };
    auto at = std::lower_bound(work.wheel_force.begin(), work.wheel_force.end(), block.disc_begin, before);
    for (; at != work.wheel_force.end() && at->position < block.disc_end; ++at)
        add_force(slots[at->position - block.disc_begin], at->on_disc);
}

/// A thread's slots, 0 as every step leaves them.
DiscForce* find_slots(DemWorkspace& work, int thread) {
    auto& slots = work.thread_force[static_cast<std::size_t>(thread)];
    if (slots.size() < work.slots) slots.assign(work.slots, DiscForce{});
    return slots.data();
}

}  // namespace

void add_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s,
                const BlockVisitor& finished, const Alongside& alongside) {
    if (work.keep_forces) work.kept_force.resize(state.discs.disc.size());
    const auto finish = [&](Block& block, DiscForce* slots) {
        merge_block(block, work, slots);
        if (work.keep_forces) std::copy_n(slots, block.size(), work.kept_force.data() + block.disc_begin);
        finished(block, {slots, block.size()});
    };
    const std::size_t count = work.block.size();
    const auto first_block_of = [&](int thread, int threads) -> std::size_t {
        if (thread == threads) return count;
        const double all = static_cast<double>(count) + alongside.blocks;
        return static_cast<std::size_t>(max_of(0.0, all * thread / threads - alongside.blocks));
    };
    work.thread_force.resize(std::max(work.thread_force.size(), static_cast<std::size_t>(omp_get_max_threads())));
#pragma omp parallel
    {
        const int threads = omp_get_num_threads(), thread = omp_get_thread_num();
        const std::size_t begin = first_block_of(thread, threads), end = first_block_of(thread + 1, threads);
        if (thread == 0 && alongside.work) alongside.work();
        DiscForce* const slots = find_slots(work, thread);
        // A block waits for the blocks that reach into it: those of this thread are done when its own turn comes,
        // those of other threads after the barrier. The slots of one that waits stay, and the next one's are behind.
        std::size_t waiting = 0;
        for (std::size_t b = begin; b < end; ++b) {
            Block& block = work.block[b];
            add_block_forces(k, block, state, work, spring_step_s, slots + waiting * discs_per_block);
            if (block.first_source < begin)
                ++waiting;
            else
                finish(block, slots + waiting * discs_per_block);
        }
#pragma omp barrier
        waiting = 0;
        for (std::size_t b = begin; b < end; ++b)
            if (work.block[b].first_source < begin) finish(work.block[b], slots + waiting++ * discs_per_block);
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

#include "dem/forces.hpp"

#include <algorithm>
#include <cmath>

#include "dem/pair_kernel.hpp"

namespace ifedem {
namespace {

constexpr double squared(double a) { return a * a; }

/// One block's pairs in list order; forces go to the block's own slots.
void add_block_pairs(const DemConstants& k, const Block& block, const DiscState& discs, std::vector<double>& spring,
                     DemWorkspace& work, double spring_step_s) {
    std::fill(work.force.begin() + block.force_begin, work.force.begin() + block.force_end, DiscForce{});
    const PairBatch batch{discs.disc.data(),  work.i.data(),      work.j.data(),
                          work.slot_i.data(), work.slot_j.data(), work.damping_Ns_m.data(),
                          spring.data(),      work.force.data(),  block.pair_begin,
                          block.pair_end,     spring_step_s};
    work.pair_kernel(k.soil, batch);
}

void merge_block(const Block& block, DemWorkspace& work) {
    for (std::uint32_t n = block.merge_begin; n < block.merge_end; ++n) {
        const DiscForce& from = work.force[work.merge[n].slot];
        DiscForce& to = work.force[work.merge[n].target];
        to.x_N += from.x_N, to.y_N += from.y_N;
        to.moment_Nm += from.moment_Nm, to.rolling_limit_Nm += from.rolling_limit_Nm;
    }
}

}  // namespace

void add_pair_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s) {
    const auto blocks = static_cast<std::int64_t>(work.block.size());
#pragma omp parallel for schedule(static)
    for (std::int64_t b = 0; b < blocks; ++b)
        add_block_pairs(k, work.block[static_cast<std::size_t>(b)], state.discs, state.pairs.tangential_m, work,
                        spring_step_s);
#pragma omp parallel for schedule(static)
    for (std::int64_t b = 0; b < blocks; ++b) merge_block(work.block[static_cast<std::size_t>(b)], work);
}

BoundaryForce boundary_force(const ContactConstants& k, double damping_ratio, const Disc& disc, Vec2 normal,
                             double centre_distance_m, double opposite_radius_m, Vec2 surface_velocity_m_s,
                             double old_spring_m, double spring_step_s) {
    BoundaryForce out;
    out.overlap_m = (disc.radius_m + opposite_radius_m) - centre_distance_m;
    if (out.overlap_m <= 0) return out;
    // A straight surface is the limit of a large circle: its chord is that of the disc cut by the line.
    const double product = opposite_radius_m > 0 ? chord_product(out.overlap_m, disc.radius_m, opposite_radius_m)
                                                 : out.overlap_m * (2.0 * disc.radius_m - out.overlap_m);
    const double half_chord =
        opposite_radius_m > 0 ? 0.5 * root(max_of(product, 0.0)) / centre_distance_m : root(max_of(product, 0.0));
    const double arm = opposite_radius_m > 0 ? disc.radius_m - 0.5 * out.overlap_m : centre_distance_m;
    const Vec2 tangent{-normal.y, normal.x};
    const Vec2 u = Vec2{disc.vx_m_s, disc.vy_m_s} - surface_velocity_m_s;
    const double damping = dashpot_Ns_m(damping_ratio, k.normal_stiffness_N_m, 1.0 / disc.inverse_mass_1_kg);
    const auto f = contact_forces(k, out.overlap_m, dot(u, normal), dot(u, tangent) + disc.omega_rad_s * arm, damping,
                                  old_spring_m, spring_step_s, half_chord);
    out.force_N = Vec2{0, 0} - (f.normal_N * normal + f.tangential_N * tangent);
    out.moment_Nm = -f.tangential_N * arm;
    out.rolling_limit_Nm = f.rolling_limit_Nm;
    out.tangential_spring_m = f.tangential_spring_m;
    out.normal_N = f.normal_N, out.tangential_N = f.tangential_N, out.arm_m = arm;
    return out;
}

WallSide find_wall_side(const DemConstants& k, std::uint32_t wall, const Disc& d) {
    const Vec2 centre{d.x_m, d.y_m};
    if (!k.flat_walls.empty()) {
        const Vec2 normal = Vec2{0, 0} - k.flat_walls[wall].normal;
        return {normal, dot(k.flat_walls[wall].point_m - centre, normal), 0.0};
    }
    const Vec2 to_wall = k.wall_discs[wall].centre_m - centre;
    const double distance = norm(to_wall);
    return {(1.0 / distance) * to_wall, distance, k.wall_discs[wall].radius_m};
}

void add_wall_forces(const DemConstants& k, State& state, DemWorkspace& work, double spring_step_s) {
    for (std::size_t n = 0; n < work.wall.size(); ++n) {
        const Disc& d = state.discs.disc[work.wall[n].position];
        const std::uint32_t w = work.wall[n].wall;
        double& spring = state.wall_contacts[n].tangential_m;
        const WallSide side = find_wall_side(k, w, d);
        const BoundaryForce f = boundary_force(k.wall, k.damping_ratio, d, side.normal, side.distance_m,
                                               side.opposite_radius_m, {0, 0}, spring, spring_step_s);
        spring = f.tangential_spring_m;
        DiscForce& to = work.force[work.force_slot[work.wall[n].position]];
        to.x_N += f.force_N.x, to.y_N += f.force_N.y;
        to.moment_Nm += f.moment_Nm, to.rolling_limit_Nm += f.rolling_limit_Nm;
    }
}

double apply_rolling(RollingScheme rolling, double omega_free_rad_s, double omega_now_rad_s,
                     double largest_change_rad_s) {
    if (rolling == RollingScheme::sign) {
        // Eq 2.18 to the letter: the moment follows the sign of ω at the beginning of the step, whatever comes of it.
        if (omega_now_rad_s > 0) return omega_free_rad_s - largest_change_rad_s;
        if (omega_now_rad_s < 0) return omega_free_rad_s + largest_change_rad_s;
        return omega_free_rad_s;
    }
    const double slower = max_of(std::fabs(omega_free_rad_s) - largest_change_rad_s, 0.0);
    return omega_free_rad_s < 0 ? -slower : slower;
}

void integrate_symplectic(const DemConstants& k, State& state, DemWorkspace& work) {
    const auto blocks = static_cast<std::int64_t>(work.block.size());
    const double dt = k.step_s, fall = dt * k.gravity_m_s2;
    const double limit2 = squared(0.5 * inner_skin_m);
    const RollingScheme rolling = k.rolling;
    work.block_moved.assign(work.block.size(), 0);
#pragma omp parallel for schedule(static)
    for (std::int64_t n = 0; n < blocks; ++n) {
        const Block& block = work.block[static_cast<std::size_t>(n)];
        const DiscForce* force =
            work.force.data() + block.force_begin;  // a block's own slots come first, in disc order
        Disc* disc = state.discs.disc.data();
        const double* spin_per_moment = work.spin_per_moment.data();
        const Vec2* reference = state.pairs.inner_reference_m.data();
        bool moved = false;
        for (std::uint32_t p = block.disc_begin; p < block.disc_end; ++p, ++force) {
            Disc& d = disc[p];
            const double impulse = dt * d.inverse_mass_1_kg, spin = spin_per_moment[p];
            d.vx_m_s += impulse * force->x_N;
            d.vy_m_s += impulse * force->y_N - fall;
            d.omega_rad_s = apply_rolling(rolling, d.omega_rad_s + spin * force->moment_Nm, d.omega_rad_s,
                                          spin * force->rolling_limit_Nm);
            d.x_m += dt * d.vx_m_s;
            d.y_m += dt * d.vy_m_s;
            d.angle_rad += dt * d.omega_rad_s;
            // The search for discs that have left their skin rides along; watch_movement() then says which list is due.
            moved |= !(squared(d.x_m - reference[p].x) + squared(d.y_m - reference[p].y) <= limit2);
        }
        work.block_moved[static_cast<std::size_t>(n)] = moved ? 1 : 0;
    }
}

}  // namespace ifedem

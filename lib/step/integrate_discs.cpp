#include "step/integrate_discs.hpp"

#include <cmath>
#include <utility>

#include "dem/skins.hpp"
#include "step/move_fours.hpp"

namespace ifedem {
namespace {

/// Accelerations under the gathered forces; rolling resistance counts as what it does to ω within the step.
DiscAcceleration acceleration_of(const DemConstants& k, const Disc& d, const DiscForce& f) {
    const double dt = k.step_s;
    const double per_inertia = 2.0 * d.inverse_mass_1_kg / (d.radius_m * d.radius_m);
    const double free = d.omega_rad_s + dt * per_inertia * (d.radius_m * f.turning_N);
    const double after = apply_rolling(k.rolling, free, d.omega_rad_s, dt * per_inertia * f.rolling_Nm);
    return {d.inverse_mass_1_kg * f.x_N + k.gravity_m_s2.x, d.inverse_mass_1_kg * f.y_N + k.gravity_m_s2.y,
            (after - d.omega_rad_s) / dt, 0.0};
}

void correct(Disc& d, const DiscAcceleration& predicted_with, const DiscAcceleration& a, double dt) {
    const double half = 0.5 * dt, quarter = 0.25 * dt * dt;
    const double ax = a.x_m_s2 - predicted_with.x_m_s2, ay = a.y_m_s2 - predicted_with.y_m_s2;
    const double aw = a.angular_rad_s2 - predicted_with.angular_rad_s2;
    d.x_m += quarter * ax, d.y_m += quarter * ay, d.angle_rad += quarter * aw;
    d.vx_m_s += half * ax, d.vy_m_s += half * ay, d.omega_rad_s += half * aw;
}

void predict(Disc& d, const DiscAcceleration& a, double dt) {
    const double half2 = 0.5 * dt * dt;
    d.x_m += dt * d.vx_m_s + half2 * a.x_m_s2;
    d.y_m += dt * d.vy_m_s + half2 * a.y_m_s2;
    d.angle_rad += dt * d.omega_rad_s + half2 * a.angular_rad_s2;
    d.vx_m_s += dt * a.x_m_s2, d.vy_m_s += dt * a.y_m_s2, d.omega_rad_s += dt * a.angular_rad_s2;
}

/// Calls move(disc, its force, position) from the block's disc `first` on, and takes the forces. The search for discs
/// that have left their skin rides along; ask_for_lists() then says which list is due.
template <class F>
void move_discs(State& state, Block& block, std::span<DiscForce> force, F&& move, std::uint32_t first = 0) {
    Disc* disc = state.discs.disc.data();
    const Reference* reference = state.pairs.inner_reference.data();
    bool moved = false;
    for (std::uint32_t p = block.disc_begin + first; p < block.disc_end; ++p) {
        move(disc[p], std::exchange(force[p - block.disc_begin], DiscForce{}), p);
        moved |= has_left(disc[p], reference[p]);
    }
    block.moved = moved;
}

/// Looks at a block's discs. A disc that leaves its inner skin must be seen in that step, but as long as none is faster
/// than it was to be, the next look may wait for as many steps as the least of what is left allows. 99 % of that: sums
/// of steps of 10 pm and more are exact enough in bins of hundreds of metres.
bool watch(const MotionBatch& batch, Block& block) {
    constexpr double faster = 1.25, least_step_m = 1e-11;
    const Watch seen = watch_fours(batch);
    const double step_m = max_of(faster * seen.fastest_m_s * batch.step_s, least_step_m);
    block.calm_m_s = step_m / batch.step_s;
    block.calm_steps = static_cast<std::uint32_t>(min_of(max_of(0.99 * seen.spare_m / step_m, 0.0), 1e9));
    return seen.left;
}

/// By fours as far as they go.
std::uint32_t move_most(const DemConstants& k, State& state, const DemWorkspace& work, Block& block,
                        std::span<DiscForce> force, bool& moved) {
    if (work.vector_width < 4 || (k.rolling != RollingScheme::limit && !k.rolling_springs)) return 0;
    MotionBatch batch;
    batch.disc = state.discs.disc.data() + block.disc_begin;
    batch.force = force.data();
    batch.from = state.pairs.inner_reference.data() + block.disc_begin;
    batch.spin_per_moment = work.spin_per_moment.data() + block.disc_begin;
    batch.count = block.size();
    batch.step_s = k.step_s;
    batch.fall_x_m_s = k.step_s * k.gravity_m_s2.x, batch.fall_y_m_s = k.step_s * k.gravity_m_s2.y;
    batch.rolling_springs = k.rolling_springs;
    batch.calm_m_s = block.calm_m_s;
    if (move_fours(batch) && block.calm_steps > 0)
        --block.calm_steps;
    else
        moved = watch(batch, block);
    return batch.count - batch.count % 4;
}

void integrate_symplectic(const DemConstants& k, State& state, const DemWorkspace& work, Block& block,
                          std::span<DiscForce> force) {
    const double dt = k.step_s;
    const Vec2 fall = dt * k.gravity_m_s2;
    bool moved = false;
    const std::uint32_t done = move_most(k, state, work, block, force, moved);
    const auto travel = [=](Disc& d, const DiscForce& f) {
        const double impulse = dt * d.inverse_mass_1_kg;
        d.vx_m_s += impulse * f.x_N + fall.x;
        d.vy_m_s += impulse * f.y_N + fall.y;
        d.x_m += dt * d.vx_m_s;
        d.y_m += dt * d.vy_m_s;
        d.angle_rad += dt * d.omega_rad_s;
    };
    const double* spin_per_moment = work.spin_per_moment.data();
    const auto turn = [&](Disc& d, const DiscForce& f, std::uint32_t p) {
        const double spin = spin_per_moment[p], turning = d.radius_m * f.turning_N;
        d.omega_rad_s = k.rolling_springs ? d.omega_rad_s + spin * (turning + f.rolling_Nm)
                                          : apply_rolling(k.rolling, d.omega_rad_s + spin * turning, d.omega_rad_s,
                                                          spin * f.rolling_Nm);
        travel(d, f);
    };
    move_discs(state, block, force, turn, done);
    block.moved |= moved;
}

}  // namespace

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

void integrate_discs(const Scene& scene, State& state, const DemWorkspace& work, Block& block,
                     std::span<DiscForce> force) {
    const DemConstants& k = scene.dem;
    const double dt = k.step_s;
    DiscAcceleration* acceleration = state.discs.acceleration.data();
    switch (scene.c.integrator) {
        case Integrator::symplectic_euler:
            integrate_symplectic(k, state, work, block, force);
            return;
        case Integrator::modified_euler_one:
            move_discs(state, block, force, [&](Disc& d, const DiscForce& f, std::uint32_t p) {
                const DiscAcceleration a = acceleration_of(k, d, f);
                correct(d, acceleration[p], a, dt);
                predict(d, a, dt);
                acceleration[p] = a;
            });
            return;
        case Integrator::modified_euler_two:
            move_discs(state, block, force, [&](Disc& d, const DiscForce& f, std::uint32_t p) {
                acceleration[p] = acceleration_of(k, d, f);
                predict(d, acceleration[p], dt);
            });
            return;
    }
}

void correct_discs(const Scene& scene, State& state, Block& block, std::span<DiscForce> force) {
    const DiscAcceleration* acceleration = state.discs.acceleration.data();
    move_discs(state, block, force, [&](Disc& d, const DiscForce& f, std::uint32_t p) {
        correct(d, acceleration[p], acceleration_of(scene.dem, d, f), scene.dem.step_s);
    });
}

}  // namespace ifedem

#include "step/integrate_discs.hpp"

#include <cmath>

#include "core/pack.hpp"
#include "dem/skins.hpp"

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

/// Calls move(disc, its force, position). The search for discs that have left their skin rides along;
/// ask_for_lists() then says which list is due.
template <class F>
IFEDEM_INLINE void move_all(State& state, const DemWorkspace& work, Block& block, const F& move) {
    const DiscForce* force = work.force.data() + block.force_begin;  // a block's own slots come first, in disc order
    Disc* disc = state.discs.disc.data();
    const Reference* reference = state.pairs.inner_reference.data();
    bool moved = false;
    for (std::uint32_t p = block.disc_begin; p < block.disc_end; ++p, ++force) {
        move(disc[p], *force, p);
        moved |= has_left(disc[p], reference[p]);
    }
    block.moved = moved;
}

template <class F>
void move_plainly(State& state, const DemWorkspace& work, Block& block, const F& move) {
    move_all(state, work, block, move);
}

/// The same operations one by one, in the newer encoding with three operands: fewer moves between registers.
template <class F>
IFEDEM_AVX2 void move_with_avx2(State& state, const DemWorkspace& work, Block& block, const F& move) {
    move_all(state, work, block, move);
}

template <class F>
void move_discs(State& state, const DemWorkspace& work, Block& block, const F& move) {
    work.vector_width >= 4 ? move_with_avx2(state, work, block, move) : move_plainly(state, work, block, move);
}

void integrate_symplectic(const DemConstants& k, State& state, const DemWorkspace& work, Block& block) {
    const double dt = k.step_s;
    const Vec2 fall = dt * k.gravity_m_s2;
    const RollingScheme rolling = k.rolling;
    const double* spin_per_moment = work.spin_per_moment.data();
    const auto travel = [=](Disc& d, const DiscForce& f) {
        const double impulse = dt * d.inverse_mass_1_kg;
        d.vx_m_s += impulse * f.x_N + fall.x;
        d.vy_m_s += impulse * f.y_N + fall.y;
        d.x_m += dt * d.vx_m_s;
        d.y_m += dt * d.vy_m_s;
        d.angle_rad += dt * d.omega_rad_s;
    };
    if (k.rolling_springs)
        return move_discs(state, work, block, [=](Disc& d, const DiscForce& f, std::uint32_t p) {
            d.omega_rad_s += spin_per_moment[p] * (d.radius_m * f.turning_N + f.rolling_Nm);
            travel(d, f);
        });
    move_discs(state, work, block, [=](Disc& d, const DiscForce& f, std::uint32_t p) {
        const double spin = spin_per_moment[p];
        d.omega_rad_s = apply_rolling(rolling, d.omega_rad_s + spin * (d.radius_m * f.turning_N), d.omega_rad_s,
                                      spin * f.rolling_Nm);
        travel(d, f);
    });
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

void integrate_discs(const Scene& scene, State& state, const DemWorkspace& work, Block& block) {
    const DemConstants& k = scene.dem;
    const double dt = k.step_s;
    DiscAcceleration* acceleration = state.discs.acceleration.data();
    switch (scene.c.integrator) {
        case Integrator::symplectic_euler:
            integrate_symplectic(k, state, work, block);
            return;
        case Integrator::modified_euler_one:
            move_discs(state, work, block, [&](Disc& d, const DiscForce& f, std::uint32_t p) {
                const DiscAcceleration a = acceleration_of(k, d, f);
                correct(d, acceleration[p], a, dt);
                predict(d, a, dt);
                acceleration[p] = a;
            });
            return;
        case Integrator::modified_euler_two:
            move_discs(state, work, block, [&](Disc& d, const DiscForce& f, std::uint32_t p) {
                acceleration[p] = acceleration_of(k, d, f);
                predict(d, acceleration[p], dt);
            });
            return;
    }
}

void correct_discs(const Scene& scene, State& state, const DemWorkspace& work, Block& block) {
    const DiscAcceleration* acceleration = state.discs.acceleration.data();
    move_discs(state, work, block, [&](Disc& d, const DiscForce& f, std::uint32_t p) {
        correct(d, acceleration[p], acceleration_of(scene.dem, d, f), scene.dem.step_s);
    });
}

}  // namespace ifedem

#include "step/integrate_discs.hpp"

#include "dem/forces.hpp"

namespace ifedem {
namespace {

/// Accelerations under the gathered forces; rolling resistance counts as what it does to ω within the step.
DiscAcceleration acceleration_of(const DemConstants& k, const Disc& d, const DiscForce& f) {
    const double dt = k.step_s;
    const double per_inertia = 2.0 * d.inverse_mass_1_kg / (d.radius_m * d.radius_m);
    const double free = d.omega_rad_s + dt * per_inertia * f.moment_Nm;
    const double after = apply_rolling(k.rolling, free, d.omega_rad_s, dt * per_inertia * f.rolling_limit_Nm);
    return {d.inverse_mass_1_kg * f.x_N, d.inverse_mass_1_kg * f.y_N - k.gravity_m_s2, (after - d.omega_rad_s) / dt,
            0.0};
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

template <class F>
void for_each_disc(State& state, const DemWorkspace& work, F&& visit) {
    const auto count = static_cast<std::int64_t>(state.discs.disc.size());
#pragma omp parallel for schedule(static)
    for (std::int64_t n = 0; n < count; ++n) {
        const auto p = static_cast<std::size_t>(n);
        visit(state.discs.disc[p], state.discs.acceleration[p], work.force[work.force_slot[p]]);
    }
}

}  // namespace

void integrate_discs(const Scene& scene, State& state, DemWorkspace& work) {
    const DemConstants& k = scene.dem;
    const double dt = k.step_s;
    switch (scene.c.integrator) {
        case Integrator::symplectic_euler:
            integrate_symplectic(k, state, work);
            return;
        case Integrator::modified_euler_one:
            for_each_disc(state, work, [&](Disc& d, DiscAcceleration& old, const DiscForce& f) {
                const DiscAcceleration a = acceleration_of(k, d, f);
                correct(d, old, a, dt);
                predict(d, a, dt);
                old = a;
            });
            return;
        case Integrator::modified_euler_two:
            for_each_disc(state, work, [&](Disc& d, DiscAcceleration& old, const DiscForce& f) {
                old = acceleration_of(k, d, f);
                predict(d, old, dt);
            });
            return;
    }
}

void correct_discs(const Scene& scene, State& state, const DemWorkspace& work) {
    for_each_disc(state, work, [&](Disc& d, DiscAcceleration& old, const DiscForce& f) {
        correct(d, old, acceleration_of(scene.dem, d, f), scene.dem.step_s);
    });
}

}  // namespace ifedem

// Eqs 2.1–2.3 with 2.6–2.8 (central difference) and 2.9–2.12 (modified Euler, and the default symplectic Euler).
#include <algorithm>
#include <array>
#include <cmath>

#include "support/beams.hpp"
#include "support/collisions.hpp"
#include "support/disc_on_plane.hpp"
#include "topics.hpp"
#include "traction/control.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;
constexpr std::array all_integrators{Integrator::symplectic_euler, Integrator::modified_euler_one,
                                     Integrator::modified_euler_two};

/// Eq 2.3 with m = 1, c = 2ζω, f = ω²u as the wheel's code advances it (leapfrog), from rest at u = 1. ω = 1.
class Oscillator {
public:
    Oscillator(double omega_dt, double zeta) : dt_(omega_dt), zeta_(zeta) {
        velocity_ = 0.5 * dt_;  // u(−Δt) = u(Δt) = 1 − ½Δt² for ζ = 0: the exact discrete cosine
    }
    double advance() {
        velocity_ = advance_controlled(ControlScheme::explicit_, {}, {1, 2 * zeta_, position_, velocity_, -position_},
                                       0, dt_, pid_);
        return position_ += dt_ * velocity_;
    }
    [[nodiscard]] double before() const { return 1 - dt_ * 0.5 * dt_; }

private:
    double dt_, zeta_;
    double position_ = 1, velocity_ = 0;
    PidState pid_;
};

/// Eq 2.8 as it is printed.
double next_displacement(double u, double u_old, double zeta, double dt) {
    const double m = 1, c = 2 * zeta, f = u;
    return (-f + m / (dt * dt) * (2 * u - u_old) + c / (2 * dt) * u_old) / (m / (dt * dt) + c / (2 * dt));
}

/// Largest difference between the printed and the leapfrog form in 2000 steps, of an amplitude of 1.
double difference_of_forms(double omega_dt, double zeta) {
    Oscillator leapfrog(omega_dt, zeta);
    double u_old = leapfrog.before(), u = 1, largest = 0;
    for (int n = 0; n < 2000; ++n) {
        const double next = next_displacement(u, u_old, zeta, omega_dt);
        u_old = u, u = next;
        largest = std::fmax(largest, std::fabs(u - leapfrog.advance()));
    }
    return largest;
}

/// Angular frequency over the exact one, from the time of many zero crossings.
double measured_frequency(double omega_dt) {
    Oscillator o(omega_dt, 0);
    double u = 1, first = 0, last = 0;
    int crossings = 0;
    for (int n = 1; crossings < 2001; ++n) {
        const double next = o.advance();
        if ((u > 0) != (next > 0)) {
            last = omega_dt * (n - next / (next - u));
            if (crossings++ == 0) first = last;
        }
        u = next;
    }
    return pi * (crossings - 1) / (last - first);
}

/// |λ| of the damped oscillator: u_n² − u_{n+1} u_{n−1} changes by |λ|² a step, whatever the phase.
double measured_decay(double omega_dt, double zeta) {
    Oscillator o(omega_dt, zeta);
    double u_old = o.before(), u = 1, first = 0, last = 0;
    constexpr int steps = 20;
    for (int n = 0; n <= steps; ++n) {
        const double next = o.advance();
        last = u * u - next * u_old;
        if (n == 0) first = last;
        u_old = u, u = next;
    }
    return std::pow(last / first, 0.5 / steps);
}

/// Largest ω Δt that stays bounded, by bisection. 10⁵ steps tell a growth of 10⁻⁴ a step: 10⁻⁹ of the limit.
double measured_limit() {
    double low = 1, high = 3;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        Oscillator o(middle, 0);
        double largest = 0;
        for (int n = 0; n < 100000 && largest < 1e6; ++n) largest = std::fmax(largest, std::fabs(o.advance()));
        (largest < 1e6 ? low : high) = middle;
    }
    return low;
}

/// The same for a square quad, over the closed form of its stiffest mode. 300 steps tell 10⁻⁴ of the limit.
double measured_element_limit() {
    double low = 0.9, high = 1.1;
    for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (low + high);
        (swing_element(middle).largest < 1e5 ? low : high) = middle;
    }
    return low;
}

void measure_central_difference(Output& out) {
    double forms = 0;
    for (const double zeta : {0.0, 0.05, 0.5})
        for (const double omega_dt : {0.01, 0.5, 1.5}) forms = std::fmax(forms, difference_of_forms(omega_dt, zeta));
    out.add("central_difference_forms", forms, "-", "largest difference of u in 2000 steps; amplitude 1");
    std::vector<std::vector<std::string>> rows;
    for (const double omega_dt : {0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 1.9, 1.95}) {
        const double closed = 2 / omega_dt * std::asin(omega_dt / 2), got = measured_frequency(omega_dt);
        // The physical decay is exp(−ζ ω Δt); the scheme's is √((1 − ζ ω Δt)/(1 + ζ ω Δt)).
        constexpr double zeta = 0.2;
        const double decay = std::log(measured_decay(omega_dt, zeta)) / (-zeta * omega_dt);
        rows.push_back({number(omega_dt), number(closed - 1), number(got - 1), number(decay - 1)});
    }
    out.write_table("frequency.csv", "omega_dt,closed_error,measured_error,decay_error", rows);
    out.add("central_difference_decay", measured_decay(1, 0.2), "-", "amplitude from step to step, ω Δt = 1, ζ = 0.2");
    out.add("central_difference_frequency", measured_frequency(1), "-", "ω_num/ω at ω Δt = 1 over 1000 periods");
    out.add("central_difference_order",
            observed_order(measured_frequency(0.2), measured_frequency(0.1), measured_frequency(0.05)), "-",
            "ω Δt = 0.2, 0.1, 0.05");
    out.add("central_difference_limit", measured_limit(), "-", "largest stable ω Δt, bisection");
    out.add("element_limit", measured_element_limit(), "-",
            "largest stable step of a square quad over the closed form");
}

/// Height lost in free fall over ½ g t², less 1.
double free_fall_error(Integrator integrator, double dt) {
    DemConstants dem = make_dem(make_contact(stiffness_N_m, stiffness_N_m, 0), 0, dt, earth_gravity_m_s2);
    World w = make_world(dem, {make_disc({0, 0}, 0.0025, 0.005)}, integrator);
    if (integrator != Integrator::symplectic_euler) w.state.discs.acceleration = {{0, -earth_gravity_m_s2, 0, 0}};
    constexpr double time_s = 0.1;
    const auto steps = static_cast<std::int64_t>(std::llround(time_s / dt));
    advance(w, steps);
    return -disc_of(w, 0).y_m / (0.5 * earth_gravity_m_s2 * time_s * time_s) - 1;
}

void measure_free_fall(Output& out) {
    for (const Integrator i : {Integrator::modified_euler_one, Integrator::modified_euler_two})
        out.add(i == Integrator::modified_euler_one ? "free_fall_modified_one" : "free_fall_modified_two",
                free_fall_error(i, 1e-3), "-", "fall over ½ g t², less 1; 100 steps");
    out.add("free_fall_symplectic_order",
            observed_order(free_fall_error(Integrator::symplectic_euler, 1e-3),
                           free_fall_error(Integrator::symplectic_euler, 5e-4),
                           free_fall_error(Integrator::symplectic_euler, 2.5e-4)),
            "-", "a disc from rest: v stands half a step behind");
}

/// Angle turned over ω0 t − ½ α t², less 1, of a disc that Eq 2.18 brakes on a frictionless plane by a constant moment.
double spin_error(Integrator integrator, double dt) {
    World w = make_disc_on_plane(0, 0, 2, {0, SpinDown::omega_rad_s});
    w.scene.dem.step_s = dt;
    w.scene.c.integrator = integrator;
    if (integrator != Integrator::symplectic_euler) w.state.discs.acceleration = {{0, 0, -spin_loss_rad_s2(), 0}};
    constexpr double time_s = 0.2;
    advance(w, static_cast<std::int64_t>(std::llround(time_s / dt)));
    const double closed = SpinDown::omega_rad_s * time_s - 0.5 * spin_loss_rad_s2() * time_s * time_s;
    return disc_of(w, 0).angle_rad / closed - 1;
}

/// A constant force and a constant moment, exact for Eqs 2.9–2.12 at any step.
void measure_constant_load(Output& out) {
    std::vector<std::vector<std::string>> rows;
    for (const Integrator i : all_integrators) {
        const std::string name = name_of(i);
        for (const double dt : {1e-4, 5e-5, 2.5e-5, 1.25e-5})
            rows.push_back({name, number(1e6 * dt), number(std::fabs(free_fall_error(i, dt))),
                            number(std::fabs(spin_error(i, dt)))});
        if (i == Integrator::symplectic_euler)
            out.add("spin_order_symplectic",
                    observed_order(spin_error(i, 1e-4), spin_error(i, 5e-5), spin_error(i, 2.5e-5)), "-",
                    "of the angle turned; steps of 100, 50, 25 µs");
        else
            out.add("spin_angle_" + name, spin_error(i, 1e-4), "-", "angle over ω0 t − ½ α t², less 1; 2000 steps");
    }
    out.write_table("constant_load.csv", "integrator,step_us,fall_error,spin_error", rows);
}

/// Eqs 2.1 and 2.2 for a disc that slides down 30° at half the friction that it needs to roll.
void measure_motion_on_incline(Output& out) {
    constexpr double slope = pi / 6;
    const double friction = 0.5 * std::tan(slope) / 3;
    for (const Integrator i : all_integrators) {
        World w = make_disc_on_plane(slope, friction, 0);
        w.scene.c.integrator = i;
        if (i != Integrator::symplectic_euler) w.state.discs.acceleration.resize(1);
        const Acceleration a = run_down(w, slope, 0.1);
        const std::string name = name_of(i);
        out.add("incline_sliding_" + name, a.along, "m/s2", "30°, µ half of tan θ/3");
        out.add("incline_spinning_" + name, a.clockwise, "rad/s2", "the same; r 3 mm");
    }
}

/// Restitution of a head-on collision against the step, ζ 0.2, ends where the force does.
void measure_collision_order(Output& out, Effort effort) {
    constexpr double zeta = 0.2;
    const double exact = closed_form(zeta, ContactEnd::no_attraction).restitution;
    const int halvings = effort == Effort::full ? 6 : 4;
    std::vector<std::vector<std::string>> rows;
    for (const Integrator i : all_integrators) {
        std::vector<double> smooth, worst;
        for (int k = 0; k < halvings; ++k) {
            const double share = 0.02 / (1 << k);
            smooth.push_back(
                collide(zeta, ContactEnd::no_attraction, i, share, Entry::at_a_step).mean_restitution / exact - 1);
            worst.push_back(collide(zeta, ContactEnd::no_attraction, i, share, Entry::spread).worst_error);
            rows.push_back({name_of(i), number(share), number(std::fabs(smooth.back())), number(worst.back())});
        }
        const std::size_t n = smooth.size();
        out.add(std::string("collision_order_") + name_of(i),
                observed_order(smooth[n - 3], smooth[n - 2], smooth[n - 1]), "-",
                "of e; the contact begins exactly at a step");
        out.add(std::string("collision_order_between_steps_") + name_of(i),
                std::log2(worst[0] / worst[n - 1]) / (static_cast<double>(n) - 1), "-",
                "of the worst e of 64 collisions that begin anywhere between two steps");
    }
    out.write_table("collision_order.csv", "integrator,step_share,error,worst_error_between_steps", rows);
}

}  // namespace

void measure_integration(Output& out, Effort effort) {
    measure_central_difference(out);
    measure_free_fall(out);
    measure_constant_load(out);
    measure_motion_on_incline(out);
    measure_collision_order(out, effort);
}

}  // namespace ifedem::chapter2

// The control loops on a lumped mass against the exact solution of m ẍ + c ẋ = K_p e + K_i ∫e + K_d ė + F, e = r − x.
#include "traction/control.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "coupling/wheel_model.hpp"
#include "step/scene.hpp"

namespace ifedem {
namespace {

// Section 4.2.4: r ω = 97.6 mm/s for every slip, V = (1 − i) r ω; the speeds of the six slips are in the ledger (D146).
TEST(TravelTarget, of_a_constant_circumferential_speed) {
    Case c;
    c.wheel.tread_radius_m = 0.2675;
    c.travel.speed_m_s = 0.0976;
    c.travel.speed_of = SpeedOf::tread;
    constexpr std::array slip{-5.0, 1.0, 7.5, 22.0, 37.5, 55.0};
    constexpr std::array speed_mm_s{102.48, 96.62, 90.28, 76.13, 61.00, 43.92};
    for (std::size_t k = 0; k < slip.size(); ++k) {
        c.travel.slip_percent = slip[k];
        const TravelTarget target = travel_target(c.travel, c.wheel, 10.0);
        EXPECT_NEAR(1e3 * target.speed_m_s, speed_mm_s[k], 0.005);
        EXPECT_DOUBLE_EQ(target.omega_clockwise_rad_s, 0.0976 / 0.2675);
        // The ramp of 1 s covers half of what full speed would.
        const double travelled =
            (static_cast<double>(steps_of_stage(c, Stage::travel)) * c.time_step_s - 0.5) * target.speed_m_s;
        EXPECT_NEAR(travelled, c.travel.distance_m, c.time_step_s * target.speed_m_s);
    }
}

// ---- Exact solution -----------------------------------------------------------------------------------------------

/// (∫e, e, ė, 1): the last carries the constant part.
using Loop = std::array<double, 4>;
using Matrix = std::array<std::array<double, 4>, 4>;

Matrix multiply(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
}

/// e^(A t) by Taylor series of A t / 2^s, squared s times.
Matrix exponential(const Matrix& a, double t) {
    double size = 0;
    for (const auto& row : a)
        for (const double v : row) size = std::fmax(size, std::fabs(v * t));
    const int halvings = std::max(0, 4 + static_cast<int>(std::ceil(std::log2(size + 1e-300))));
    Matrix sum{}, term{};
    for (std::size_t i = 0; i < 4; ++i) sum[i][i] = term[i][i] = 1;
    Matrix scaled = a;
    for (auto& row : scaled)
        for (double& v : row) v *= t / std::ldexp(1.0, halvings);
    for (int n = 1; n < 20; ++n) {
        term = multiply(term, scaled);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) sum[i][j] += (term[i][j] /= n);
    }
    for (int n = 0; n < halvings; ++n) sum = multiply(sum, sum);
    return sum;
}

struct Plant {
    GainsCase gains;
    double mass = 0, damping = 0, force = 0;
};

/// Target r with constant speed and acceleration over the interval; `speed` is that at its beginning. Acceleration
/// enters ë, and through the damping also its integral, which the closed form leaves out: 0 unless the plant is
/// undamped.
Loop solve(const Plant& p, Loop begin, double speed, double acceleration, double t) {
    const double m = p.mass;
    begin[3] = acceleration - (p.force - p.damping * speed) / m;
    const Matrix a{{{0, 1, 0, 0},
                    {0, 0, 1, 0},
                    {-p.gains.integral / m, -p.gains.proportional / m, -(p.gains.derivative + p.damping) / m, 1},
                    {0, 0, 0, 0}}};
    const Matrix e = exponential(a, t);
    Loop end{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) end[i] += e[i][k] * begin[k];
    return end;
}

// ---- The code's loop ----------------------------------------------------------------------------------------------

struct Response {
    double position = 0, velocity = 0;
    PidState pid;
};

/// `target(t)` from a body at rest at 0 for `time_s`.
template <class Target>
Response run_loop(ControlScheme scheme, const Plant& p, Target&& target, double time_s, std::int64_t steps) {
    const double dt = time_s / static_cast<double>(steps);
    Response r;
    r.pid.target = target(0.0);
    for (std::int64_t n = 0; n < steps; ++n) {
        r.velocity = advance_controlled(scheme, p.gains, {p.mass, p.damping, r.position, r.velocity, p.force},
                                        target(static_cast<double>(n + 1) * dt), dt, r.pid);
        r.position += dt * r.velocity;
    }
    return r;
}

enum class Input { step, ramp, force };
constexpr double ramp_speed = 0.1;

const char* name_of(Input i) { return i == Input::step ? "step" : i == Input::ramp ? "ramp" : "force"; }
const char* name_of(ControlScheme s) { return s == ControlScheme::explicit_ ? "explicit" : "semi-implicit"; }

/// A unit step of r gives the derivative gain an impulse K_d at once; a ramp begins with ė = V.
double exact_position(const Plant& p, Input input, double t) {
    Loop begin{};
    if (input == Input::step) begin = {0, 1, -p.gains.derivative / p.mass, 1};
    if (input == Input::ramp) begin = {0, 0, ramp_speed, 1};
    const Loop end = solve(p, begin, input == Input::ramp ? ramp_speed : 0, 0, t);
    const double target = input == Input::step ? 1 : input == Input::ramp ? ramp_speed * t : 0;
    return target - end[1];
}

double measured_position(ControlScheme scheme, const Plant& p, Input input, double t, std::int64_t steps) {
    const auto target = [&](double at) {
        return input == Input::step ? 1.0 : input == Input::ramp ? ramp_speed * at : 0.0;
    };
    return run_loop(scheme, p, target, t, steps).position;
}

TEST(ClosedLoop, converges_to_the_exact_response) {
    // Gains that let the mass be seen (chapter 3's hide it behind a pole at K_d/m = 1300 per s), and chapter 3's own.
    const Plant soft{{400, 300, 60}, 10, 5, 0}, chapter3{{1e4, 1e4, 1e4}, 7.6, 0, 0};
    for (const ControlScheme scheme : {ControlScheme::semi_implicit, ControlScheme::explicit_}) {
        for (const bool is_soft : {true, false}) {
            for (const Input input : {Input::step, Input::ramp, Input::force}) {
                Plant p = is_soft ? soft : chapter3;
                p.force = input == Input::force ? 100 : 0;
                for (const double t : {0.3, 2.0, 6.0}) {
                    const double exact = exact_position(p, input, t), scale = input == Input::force
                                                                                  ? 100 / p.gains.proportional
                                                                              : input == Input::ramp ? ramp_speed
                                                                                                     : 1.0;
                    std::array<double, 3> error{};
                    const auto first = static_cast<std::int64_t>(t * 5000);
                    for (std::size_t k = 0; k < 3; ++k)
                        error[k] = (measured_position(scheme, p, input, t, first << k) - exact) / scale;
                    const double order = std::log2(std::fabs((error[0] - error[1]) / (error[1] - error[2])));
                    const double extrapolated = (4 * (2 * error[2] - error[1]) - (2 * error[1] - error[0])) / 3;
                    std::printf(
                        "%-13s %s gains, %-5s t %.1f: x %+.5f, errors %+.1e %+.1e %+.1e, order %.2f, extrapolated "
                        "%+.1e\n",
                        name_of(scheme), is_soft ? "soft     " : "chapter 3", name_of(input), t, exact, error[0],
                        error[1], error[2], order, extrapolated);
                    EXPECT_LT(std::fabs(error[2]), 2e-4);
                    EXPECT_LT(std::fabs(extrapolated), 1e-6);
                    if (std::fabs(error[2]) > 1e-9) {
                        EXPECT_NEAR(order, 1, 0.1);
                    }
                }
            }
        }
    }
}

// ---- Chapter 3's gains --------------------------------------------------------------------------------------------

/// Roots of m s³ + K_d s² + K_p s + K_i: the fast one near −K_d/m by Newton, the slow pair by division.
struct Poles {
    double fast = 0;
    double decay = 0, squared_frequency = 0;  ///< slow pair: s² + 2 decay s + (decay² + squared_frequency)
};
Poles find_poles(const GainsCase& g, double mass) {
    double s = -g.derivative / mass;
    for (int n = 0; n < 50; ++n) {
        const double f = ((mass * s + g.derivative) * s + g.proportional) * s + g.integral;
        s -= f / ((3 * mass * s + 2 * g.derivative) * s + g.proportional);
    }
    const double b = g.derivative / mass + s, c = g.proportional / mass + b * s;
    return {s, 0.5 * b, c - 0.25 * b * b};
}

TEST(Chapter3, gains_decay_as_half_the_time) {
    const WheelModel wheel = make_wheel_model(WheelCase{});
    const struct {
        const char* name;
        GainsCase gains;
        double mass;
    } loops[] = {{"drawbar, kg", ControlCase{}.drawbar, wheel.body_mass_kg},
                 {"torque, kg m2", ControlCase{}.torque, wheel.body_inertia_kg_m2}};
    for (const auto& loop : loops) {
        const Poles p = find_poles(loop.gains, loop.mass);
        std::printf("%s %.4f: poles %.0f and -%.5f +- %.5f i per s\n", loop.name, loop.mass, p.fast, p.decay,
                    std::sqrt(p.squared_frequency));
        EXPECT_NEAR(p.decay, 0.5, 1e-3);  // s² + s + 1 = 0 but for terms of s m / K_d
        EXPECT_NEAR(p.squared_frequency, 0.75, 2e-3);
    }
}

// What is left of the beginning of travel when averages are taken, 0.4 m to 0.8 m at 0.1 m/s after a ramp of 1 s: 4.5 s
// to 8.5 s.
TEST(Chapter3, transient_in_the_averaging_window) {
    const TravelCase travel;
    const WheelCase wheel;
    const WheelModel model = make_wheel_model(wheel);
    // At 1 s the soil begins to push back with the drawbar pull of the text: the loop must build up −P_d.
    Plant p{ControlCase{}.drawbar, model.body_mass_kg, 0, 0};
    const double dt = 4e-5, push_N = 43;
    Response r;
    Loop exact{0, 0, 0, 1};
    double peak = 0, target = 0, at_begin = 0;
    std::printf("drawbar loop, %g N from t = 1 s:  t, e/mm, e/peak, speed error/V, (P + F)/F, exact e/mm\n", push_N);
    for (std::int64_t n = 0; n < 212500; ++n) {
        const double t = static_cast<double>(n) * dt;
        p.force = n >= 25000 ? push_N : 0;
        target += dt * travel_target(travel, wheel, t + dt).speed_m_s;
        r.velocity = advance_controlled(ControlScheme::semi_implicit, p.gains,
                                        {p.mass, 0, r.position, r.velocity, p.force}, target, dt, r.pid);
        r.position += dt * r.velocity;
        peak = std::fmax(peak, std::fabs(r.pid.error_old));
        if (n + 1 == 25000) exact = solve(p, exact, 0, travel.speed_m_s / travel.acceleration_time_s, 1.0);
        const double now = t + dt;
        for (const double mark : {2.0, 4.5, 6.5, 8.5}) {
            if (std::fabs(now - mark) > 0.5 * dt) continue;
            Plant after = p;
            after.force = push_N;
            const Loop e = solve(after, exact, travel.speed_m_s, 0, mark - 1.0);
            std::printf("   %.1f s  %+.4f  %+.4f  %+.2e  %+.2e  %+.4f\n", mark, 1e3 * r.pid.error_old,
                        r.pid.error_old / peak, r.velocity / travel.speed_m_s - 1, (r.pid.output + push_N) / push_N,
                        1e3 * e[1]);
            EXPECT_NEAR(r.pid.error_old, e[1], 2e-3 * peak);
            EXPECT_NEAR(target - r.position, r.pid.error_old, 1e-12);
            // The envelope since the push: e^(−t/2), 17 % at 4.5 s and 2.4 % at 8.5 s, times at most 1/sin 60°.
            EXPECT_LT(std::fabs(r.pid.error_old),
                      1.16 * std::exp(-(mark - 1) / 2) * push_N / p.gains.proportional * 1.01);
            // Yet P itself follows the push at once: what is left is m ẍ.
            EXPECT_NEAR(r.pid.output, -push_N, 1e-3 * push_N);
            if (mark == 4.5) at_begin = r.pid.error_old;
        }
    }
    const double mean_speed_error = (at_begin - r.pid.error_old) / 4.0 / travel.speed_m_s;
    std::printf("   mean speed over the window is off by %+.1e of V\n", mean_speed_error);
    EXPECT_LT(std::fabs(mean_speed_error), 1e-3);
}

// ---- Limits of the schemes ----------------------------------------------------------------------------------------

double largest_position(ControlScheme scheme, const Plant& p, double dt, std::int64_t steps) {
    double largest = 0;
    Response r;
    for (std::int64_t n = 0; n < steps && std::isfinite(r.position); ++n) {
        r.velocity =
            advance_controlled(scheme, p.gains, {p.mass, p.damping, r.position, r.velocity, 1.0}, 0, dt, r.pid);
        r.position += dt * r.velocity;
        largest = std::fmax(largest, std::isfinite(r.position) ? std::fabs(r.position) : 1e300);
    }
    return largest;
}

TEST(Stability, explicit_up_to_2m_over_Kd_semi_implicit_without_limit) {
    for (const double mass : {0.03, 7.6}) {
        const Plant p{mass < 1 ? ControlCase{}.torque : ControlCase{}.drawbar, mass, 0, 0};
        const double limit = 2 * mass / p.gains.derivative,
                     fair = 1 / p.gains.proportional;  // deflection under the unit force
        const double below = largest_position(ControlScheme::explicit_, p, 0.99 * limit, 20000) / fair;
        const double above = largest_position(ControlScheme::explicit_, p, 1.01 * limit, 20000) / fair;
        std::printf("mass %.2f: explicit limit 2m/Kd = %.3e s: largest |x| %.3g of F/Kp at 0.99 of it, %.3g at 1.01\n",
                    mass, limit, below, above);
        EXPECT_LT(below, 2);
        EXPECT_GT(above, 1e6);
        for (const double times : {1.0, 10.0, 100.0, 1000.0}) {
            const double semi = largest_position(ControlScheme::semi_implicit, p, times * limit, 20000) / fair;
            std::printf("           semi-implicit at %5.0f times: %.3g\n", times, semi);
            EXPECT_LT(semi, 2);
        }
    }
}

// Both schemes are one and the same but for when the error is taken: with a large mass nothing moves and u is F of the
// gains.
TEST(Scheme, output_is_the_sum_of_the_three_terms) {
    const GainsCase g{3, 5, 7};
    for (const ControlScheme scheme : {ControlScheme::semi_implicit, ControlScheme::explicit_}) {
        PidState pid;
        pid.error_sum = 0.2, pid.error_old = 0.5, pid.target = 2.0;
        const double v = advance_controlled(scheme, g, {1e12, 0, 1.0, 0, 0}, 2.0, 0.1, pid);
        EXPECT_NEAR(pid.output, 3 * 1.0 + 5 * (0.2 + 0.1) + 7 * (1.0 - 0.5) / 0.1, 1e-9);
        EXPECT_NEAR(v, 0, 1e-9);
        EXPECT_NEAR(pid.error_sum, 0.3, 1e-9);
        EXPECT_NEAR(pid.error_old, 1.0, 1e-9);
        EXPECT_EQ(pid.target, 2.0);
    }
}

// The motion before the PID: the target is met in every step, and u is what m dv/dt + c v - F asks for.
TEST(Scheme, prescribed_motion_meets_its_target) {
    const double dt = 1e-3, mass = 2, damping = 3, force = 5;
    PidState pid;
    double x = 0, v = 0, target = 0;
    for (int n = 0; n < 100; ++n) {
        target += dt * 0.1 * (n + 1);
        const double before = v;
        v = advance_controlled(ControlScheme::prescribed, {}, {mass, damping, x, v, force}, target, dt, pid);
        x += dt * v;
        EXPECT_NEAR(x, target, 1e-15);
        EXPECT_NEAR(pid.output, mass * (v - before) / dt + 0.5 * damping * (v + before) - force, 1e-9);
    }
    EXPECT_NEAR(v, 10, 1e-9);
}

TEST(Travel, speeds_rise_with_the_ramp_and_follow_the_slip) {
    TravelCase t;
    WheelCase w;
    t.speed_m_s = 0.1, t.slip_percent = 60, t.acceleration_time_s = 1;
    EXPECT_NEAR(commanded_omega_rad_s(t, w), 0.1 / (0.15 * 0.4), 1e-15);
    t.slip_radius = SlipRadius::lug_tip;
    EXPECT_NEAR(commanded_omega_rad_s(t, w), 0.1 / (0.158 * 0.4), 1e-15);
    t.slip_percent = 0;
    EXPECT_NEAR(commanded_omega_rad_s(t, w) * 0.158, 0.1, 1e-15);
    for (const double time : {0.0, 0.25, 1.0, 7.0}) {
        EXPECT_NEAR(travel_target(t, w, time).speed_m_s, 0.1 * std::fmin(time, 1), 1e-15);
        EXPECT_NEAR(travel_target(t, w, time).omega_clockwise_rad_s, std::fmin(time, 1) * 0.1 / 0.158, 1e-15);
    }
    t.acceleration_time_s = 0;
    EXPECT_EQ(travel_target(t, w, 0).speed_m_s, 0.1);
}

}  // namespace
}  // namespace ifedem

// Integrals of contact stress and the semi-empirical wheel, against closed forms and a quadrature of its own.
#include "traction/parametric.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "traction/parametric_soil.hpp"
#include "traction/parametric_wheel.hpp"

namespace ifedem {
namespace {

constexpr double degree = pi / 180;
constexpr ContactArc tyre{0.17, 0.2675};

StressField make_field(std::function<double(double)> sigma, std::function<double(double)> tau, double entry_deg,
                       double exit_deg) {
    return {std::move(sigma), std::move(tau), entry_deg * degree, exit_deg * degree, {}};
}

void expect_close(const Integral& i, double exact, double size, const char* what) {
    EXPECT_NEAR(i.value, exact, 1e-8 * size) << what;
    EXPECT_LE(std::fabs(i.value - exact), i.error + 1e-13 * size) << what << ": the bound of the error is too small";
}

// ---- Integrals -----------------------------------------------------------------------------------------------------

TEST(StressIntegrals, of_constant_stresses_are_exact) {
    constexpr double s = 30e3, t = 8e3, a = 65 * degree, b = 105 * degree;
    const StressField field = make_field([](double) { return s; }, [](double) { return t; }, 65, 105);
    const double area = tyre.width_m * tyre.radius_m, load = area * s * (std::cos(a) - std::cos(b));
    const double lift = area * t * (std::sin(b) - std::sin(a));

    const TractiveIntegrals printed = integrate_stress(field, tyre, Sharing::printed, VerticalForm::printed);
    expect_close(printed.gross_tractive_effort_N, area * t * (std::cos(a) - std::cos(b)), load, "H");
    expect_close(printed.motion_resistance_N, -area * s * (std::sin(b) - std::sin(a)), load, "R");
    // Eq 4.3 as printed: the rear's − τ cosθ lifts where the force presses down.
    expect_close(printed.load_N, load + area * t * ((1 - std::sin(a)) - (std::sin(b) - 1)), load, "W printed");

    const TractiveIntegrals written = integrate_stress(field, tyre);
    expect_close(written.load_N, load + lift, load, "W");
    expect_close(written.gross_tractive_effort_N, area * (t * (std::cos(a) - std::cos(b)) + s * (1 - std::sin(b))),
                 load, "H with σ of the rear");
    expect_close(written.motion_resistance_N, -area * s * (1 - std::sin(a)), load, "R of the front alone");
}

// τ = t (θ − m) changes sign at m: what is before goes to R.
TEST(StressIntegrals, share_negative_shear_to_the_resistance) {
    constexpr double t = 50e3, a = 70 * degree, b = 100 * degree, m = 82 * degree;
    const StressField field =
        make_field([](double) { return 0.0; }, [](double theta) { return t * (theta - m); }, 70, 100);
    const auto antiderivative = [](double x) { return std::sin(x) - (x - m) * std::cos(x); };
    const double area = tyre.width_m * tyre.radius_m, size = area * t * 0.5;
    const TractiveIntegrals written = integrate_stress(field, tyre);
    expect_close(written.gross_tractive_effort_N, area * t * (antiderivative(b) - antiderivative(m)), size, "H");
    expect_close(written.motion_resistance_N, area * t * (antiderivative(m) - antiderivative(a)), size, "R");
    EXPECT_LT(written.motion_resistance_N.value, 0);
}

TEST(StressIntegrals, net_traction_does_not_depend_on_the_sharing) {
    const StressField field = make_field([](double x) { return 4e4 * std::sin(5 * (x - 1.1)); },
                                         [](double x) { return 1e4 * std::cos(9 * x); }, 60, 110);
    const TractiveIntegrals a = integrate_stress(field, tyre, Sharing::printed);
    const TractiveIntegrals b = integrate_stress(field, tyre, Sharing::as_written);
    EXPECT_NEAR(a.net_traction_N.value, b.net_traction_N.value, 1e-8 * a.load_N.value);
    EXPECT_GT(std::fabs(a.gross_tractive_effort_N.value - b.gross_tractive_effort_N.value), 1);
}

TEST(StressIntegrals, of_a_spline_are_those_of_what_it_passes_through) {
    const auto sigma = [](double x) { return std::exp(-50 * (x - 1.5) * (x - 1.5)); };
    std::vector<double> x, y;
    for (int k = 0; k < 1000; ++k) x.push_back((k + 0.5) * pi / 1000), y.push_back(sigma(x.back()));
    const auto spline = make_spline(x, y);
    const StressField exact{sigma, sigma, x.front(), x.back(), {}}, sampled{spline, spline, x.front(), x.back(), {}};
    const double a = integrate_stress(exact, tyre).load_N.value, b = integrate_stress(sampled, tyre).load_N.value;
    EXPECT_NEAR(b, a, 1e-7 * a);
    EXPECT_EQ(spline(0.0), 0.0);
}

// An exit of "θ = 90°" that a sum of angles has left some bits beyond bottom dead centre, where a stress that ends
// there is no more than round-off itself.
TEST(StressIntegrals, end_beside_bottom_dead_centre_by_round_off) {
    constexpr double s = 30e3, a = 65 * degree;
    for (const double beyond_rad : {0.0, 2.3e-16, 3e-15, -3e-15}) {
        const double end = 0.5 * pi + beyond_rad;
        const auto sigma = [&](double t) { return s * std::pow(std::fmax(std::cos(t) - std::cos(end), 0.0), 1.15); };
        const StressField field{sigma, [](double) { return 0.0; }, a, end, {}};
        const double exact = s * std::pow(std::cos(a), 2.15) / 2.15;  // ∫ σ sinθ dθ
        expect_close(integrate_stress(field, tyre).load_N, tyre.width_m * tyre.radius_m * exact, 1e3, "W");
    }
}

TEST(StressIntegrals, nothing_to_integrate_is_refused) {
    const auto zero = [](double) { return 0.0; };
    EXPECT_THROW((void)integrate_stress(make_field(zero, zero, 90, 90), tyre), Error);
    EXPECT_THROW((void)integrate_stress(make_field(zero, zero, 60, 90), {0, 1}), Error);
    EXPECT_THROW((void)make_spline(std::vector<double>{1, 2}, std::vector<double>{1, 2}), Error);
}

// ---- The semi-empirical wheel --------------------------------------------------------------------------------------

ParametricWheel make_wheel() {
    ParametricWheel w;
    w.arc = tyre;
    w.pressure = {1.5e6, 1.0};
    w.c1 = 0.43, w.c2 = 0.32;
    return w;
}

/// n = 1: ∫ σ, ∫ σ cosθ, ∫ σ sinθ over the whole contact in closed form; θ from bottom dead centre.
struct LinearSoil {
    double plain = 0, vertical = 0, forward = 0;
};
LinearSoil closed_form(const ParametricWheel& w, double slip, double entry) {
    const double peak = (w.c1 + w.c2 * slip) * entry, rear = w.rear_rad, c = std::cos(entry);
    const double lambda = (entry - peak) / (peak - rear), shift = entry + lambda * rear;  // θ* = shift − λ θ
    const double kr = w.pressure.modulus_Pa_mn * w.arc.radius_m;
    const auto front = [&](double x) {
        return LinearSoil{std::sin(x) - c * x, 0.5 * x + 0.25 * std::sin(2 * x) - c * std::sin(x),
                          0.5 * std::sin(x) * std::sin(x) + c * std::cos(x)};
    };
    const auto back = [&](double x) {
        const double p = shift + (1 - lambda) * x, q = shift - (1 + lambda) * x;
        return LinearSoil{-std::sin(shift - lambda * x) / lambda - c * x,
                          0.5 * (std::sin(p) / (1 - lambda) - std::sin(q) / (1 + lambda)) - c * std::sin(x),
                          0.5 * (-std::cos(p) / (1 - lambda) - std::cos(q) / (1 + lambda)) + c * std::cos(x)};
    };
    const auto between = [&](auto&& f, double from, double to) {
        const LinearSoil a = f(from), b = f(to);
        return LinearSoil{kr * (b.plain - a.plain), kr * (b.vertical - a.vertical), kr * (b.forward - a.forward)};
    };
    const LinearSoil f = between(front, peak, entry), r = between(back, rear, peak);
    return {f.plain + r.plain, f.vertical + r.vertical, f.forward + r.forward};
}

TEST(ParametricWheel, without_shear_on_linear_soil_is_the_closed_form) {
    for (const double rear_deg : {0.0, -8.0}) {
        for (const double slip : {0.0, 0.22, 0.55}) {
            ParametricWheel w = make_wheel();
            w.rear_rad = rear_deg * degree;
            const double entry = 0.5, area = tyre.width_m * tyre.radius_m;
            const LinearSoil exact = closed_form(w, slip, entry);
            const ParametricResult got = solve_wheel(w, slip, area * exact.vertical, Sharing::printed);
            EXPECT_NEAR(got.entry_rad, entry, 1e-8);
            EXPECT_NEAR(got.traction.load_N.value, area * exact.vertical, 1e-8 * area * exact.vertical);
            EXPECT_NEAR(got.traction.motion_resistance_N.value, -area * exact.forward, 1e-8 * area * exact.vertical);
            EXPECT_EQ(got.traction.gross_tractive_effort_N.value, 0);
            EXPECT_NEAR(got.sinkage_m, tyre.radius_m * (1 - std::cos(entry)), 1e-9);
        }
    }
}

// The search for the entry angle begins with a contact of a hundredth of a degree: there cos x = 1 − x²/2, so that the
// pressure goes with θ_1 to the power 2n and its sum to 2n + 1.
TEST(ParametricWheel, on_hard_soil_is_integrated_over_a_narrow_contact) {
    ParametricWheel w = make_wheel();
    w.pressure.exponent = 1.15;
    const auto load = [&](double entry) {
        return integrate_stress(wheel_stress(w, 0.375, entry), tyre, Sharing::printed).load_N.value;
    };
    EXPECT_NEAR(load(2e-6) / load(1e-6), std::pow(2.0, 2 * 1.15 + 1), 1e-6);  // narrower than the search begins
    EXPECT_NEAR(load(2e-4) / load(1e-4), std::pow(2.0, 2 * 1.15 + 1), 1e-6);
    EXPECT_NEAR(load(2e-3) / load(1e-3), std::pow(2.0, 2 * 1.15 + 1), 1e-4);
}

TEST(ParametricWheel, with_full_strength_at_once_has_the_closed_torque) {
    ParametricWheel w = make_wheel();
    w.shear = {1e3, 0.6, 0};
    const double slip = 0.3, entry = 0.6, area = tyre.width_m * tyre.radius_m;
    const LinearSoil exact = closed_form(w, slip, entry);
    // W = ∫ σ cosθ − ∫ τ sinθ in angles from bottom dead centre: the shear presses down in front.
    const double load = area * (exact.vertical + 0.6 * exact.forward + 1e3 * (1 - std::cos(entry)));
    const ParametricResult got = solve_wheel(w, slip, load, Sharing::printed);
    EXPECT_NEAR(got.entry_rad, entry, 1e-8);
    EXPECT_NEAR(got.torque_Nm, area * tyre.radius_m * (0.6 * exact.plain + 1e3 * entry), 1e-8 * got.torque_Nm);
    w.shear.displacement_m = 1e-9;  // K → 0
    const ParametricResult limit = solve_wheel(w, slip, load, Sharing::printed);
    EXPECT_NEAR(limit.torque_Nm, got.torque_Nm, 1e-5 * got.torque_Nm);
}

/// Composite Simpson rule over parts between `nodes`.
template <class F>
double simpson(F&& f, const std::vector<double>& nodes) {
    double sum = 0;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        constexpr int n = 20000;
        const double h = (nodes[k] - nodes[k - 1]) / n;
        for (int i = 0; i <= n; ++i)
            sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * f(nodes[k - 1] + h * i) * h / 3;
    }
    return sum;
}

TEST(ParametricWheel, agrees_with_another_quadrature_written_from_the_formulas) {
    ParametricWheel w = make_wheel();
    w.pressure = {3e6, 1.2};
    w.shear = {500, 0.55, 0.01};
    w.rear_rad = -10 * degree;
    const double slip = 0.22;
    const ParametricResult got = solve_wheel(w, slip, 980, Sharing::printed);
    const double r = tyre.radius_m, t1 = got.entry_rad, t2 = w.rear_rad, tm = (0.43 + 0.32 * slip) * t1;
    const auto sigma = [&](double t) {
        const double star = t > tm ? t : t1 - (t - t2) / (tm - t2) * (t1 - tm);
        return 3e6 * std::pow(std::fmax(0.0, r * (std::cos(star) - std::cos(t1))), 1.2);
    };
    const auto tau = [&](double t) {
        const double j = r * ((t1 - t) - (1 - slip) * (std::sin(t1) - std::sin(t)));
        return (500 + 0.55 * sigma(t)) * (1 - std::exp(-j / 0.01));
    };
    const double area = tyre.width_m * r;
    const std::vector<double> nodes{t2, 0, tm, t1};
    const double load = area * simpson([&](double t) { return sigma(t) * std::cos(t) - tau(t) * -std::sin(t); }, nodes);
    EXPECT_NEAR(load, 980, 1e-5);
    EXPECT_NEAR(got.traction.gross_tractive_effort_N.value,
                area * simpson([&](double t) { return tau(t) * std::cos(t); }, nodes), 1e-5);
    EXPECT_NEAR(got.traction.motion_resistance_N.value,
                -area * simpson([&](double t) { return sigma(t) * std::sin(t); }, nodes), 1e-5);
    EXPECT_NEAR(got.torque_Nm, area * r * simpson(tau, nodes), 1e-6);
}

// The sands of Wong & Reece (1967), Table 1, in inches and pounds, solved by another program with the same formulas: a
// check of the module and of its units, no measurement.
TEST(ParametricWheel, reproduces_rows_of_wong_and_reece_soils) {
    struct Row {
        double k1, k2, n, cohesion, phi_deg, width, c1, load, slip, entry_deg, peak_deg, sinkage, h, r, pull;
    };
    const Row rows[] = {
        {20, 2.5, 0.47, 0.10, 33.3, 6, 0.43, 2006, 0.100, 36.45, 16.84, 4.83, 735.9, 584.4, 151.5},
        {20, 2.5, 0.47, 0.10, 33.3, 6, 0.43, 2006, 0.221, 36.54, 18.30, 4.86, 869.9, 579.3, 290.6},
        {20, 2.5, 0.47, 0.10, 33.3, 6, 0.43, 2006, 0.500, 37.50, 22.12, 5.10, 982.2, 593.6, 388.7},
        {0, 2.0, 1.15, 0.12, 31.1, 6, 0.18, 1986, 0.221, 56.07, 14.06, 10.91, 932.8, 696.6, 236.1},
        {0, 2.0, 1.15, 0.12, 31.1, 12, 0.18, 2085, 0.221, 47.27, 11.85, 7.94, 981.3, 634.8, 346.6},
    };
    for (const Row& row : rows) {
        ParametricWheel w;
        w.arc = {row.width, 24.7};
        w.pressure = {(row.k1 + row.k2 * row.width) / std::pow(row.width, row.n), row.n};
        w.shear = {row.cohesion, std::tan(row.phi_deg * degree), 1.5};
        w.c1 = row.c1, w.c2 = 0.32;
        const ParametricResult got = solve_wheel(w, row.slip, row.load, Sharing::printed);
        EXPECT_NEAR(got.entry_rad / degree, row.entry_deg, 0.005);
        EXPECT_NEAR(got.greatest_normal_rad / degree, row.peak_deg, 0.005);
        EXPECT_NEAR(got.sinkage_m, row.sinkage, 0.005);
        EXPECT_NEAR(got.traction.gross_tractive_effort_N.value, row.h, 0.05);
        EXPECT_NEAR(got.traction.motion_resistance_N.value, -row.r, 0.05);
        EXPECT_NEAR(got.traction.net_traction_N.value, row.pull, 0.1);  // a difference of two rounded ones
    }
}

// ---- Soil parameters -----------------------------------------------------------------------------------------------

TEST(SoilFits, find_what_made_the_data) {
    const std::vector<double> z{0.004, 0.01, 0.018, 0.03};
    std::vector<double> p;
    for (const double d : z) p.push_back(2.2e6 * std::pow(d, 1.13));
    const PressureSinkage fit = fit_pressure_sinkage(z, p);
    EXPECT_NEAR(fit.modulus_Pa_mn, 2.2e6, 1e-6 * 2.2e6);
    EXPECT_NEAR(fit.exponent, 1.13, 1e-10);

    std::vector<ShearTest> tests;
    for (const double sigma : {10e3, 20e3, 40e3}) {
        ShearTest t;
        t.normal_Pa = sigma;
        for (int k = 0; k <= 4000; ++k) {
            const double j = 1e-5 * k;  // up to 40 mm, twenty K
            const double wobble = 1 + 0.2 * std::sin(0.5 * k);
            t.displacement_m.push_back(j);
            t.shear_Pa.push_back((300 + 0.52 * sigma) * (1 - std::exp(-j / 0.002)) * wobble);
        }
        tests.push_back(t);
    }
    const ShearStrength s = fit_shear_strength(tests);
    EXPECT_NEAR(s.cohesion_Pa, 300, 5);
    EXPECT_NEAR(s.friction, 0.52, 1e-3);
    EXPECT_NEAR(s.displacement_m, 0.002, 2e-5);
    for (ShearTest& t : tests)
        for (double& tau : t.shear_Pa) tau -= 600 * (1 - std::exp(-20));
    EXPECT_EQ(fit_shear_strength(tests).cohesion_Pa, 0);  // no negative cohesion
    EXPECT_THROW((void)fit_shear_strength(std::span(tests).first(1)), Error);
    EXPECT_THROW((void)fit_pressure_sinkage(std::vector<double>{0.01, -0.01}, std::vector<double>{1, 2}), Error);
    // No line goes through points of one abscissa.
    EXPECT_THROW((void)fit_pressure_sinkage(std::vector<double>{0.01, 0.01}, std::vector<double>{1, 2}), Error);
    tests.assign(2, tests.front());
    EXPECT_THROW((void)fit_shear_strength(tests), Error);
}

std::string refusal_of(const ParametricWheel& w, double load_N) {
    try {
        (void)solve_wheel(w, 0.2, load_N);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ParametricWheel, that_cannot_carry_its_load_is_refused) {
    ParametricWheel w = make_wheel();
    w.pressure.modulus_Pa_mn = 10;
    EXPECT_NE(refusal_of(w, 980).find("too soft"), std::string::npos) << refusal_of(w, 980);
    w.pressure.modulus_Pa_mn = 1e20;
    EXPECT_NE(refusal_of(w, 980).find("too hard"), std::string::npos) << refusal_of(w, 980);
    w.pressure.modulus_Pa_mn = 1e6;
    EXPECT_NE(refusal_of(w, 0).find("no load"), std::string::npos) << refusal_of(w, 0);
    w.shear.friction = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal_of(w, 980), "");
    w.shear.friction = 0;
    w.pressure.modulus_Pa_mn = 1e6;
    w.c1 = 1.2;
    EXPECT_THROW((void)solve_wheel(w, 0.2, 980), Error);
}

}  // namespace
}  // namespace ifedem

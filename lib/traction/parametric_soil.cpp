#include "traction/parametric_soil.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace ifedem {
namespace {

/// Whether there is no line through points: least squares would divide by 0.
bool are_all_equal(std::span<const double> x) {
    return std::ranges::all_of(x, [&](double v) { return v == x.front(); });
}

/// y ≈ c0 + c1 x; x not all equal.
struct Line {
    double c0 = 0, c1 = 0;
};
Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    Line line;
    double c00 = 0, c01 = 0, c11 = 0, squares = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.c0, &line.c1, &c00, &c01, &c11, &squares);
    return line;
}

}  // namespace

PressureSinkage fit_pressure_sinkage(std::span<const double> sinkage_m, std::span<const double> pressure_Pa) {
    const auto positive = [](double v) { return v > 0; };
    if (sinkage_m.size() < 2 || sinkage_m.size() != pressure_Pa.size() ||
        !std::all_of(sinkage_m.begin(), sinkage_m.end(), positive) ||
        !std::all_of(pressure_Pa.begin(), pressure_Pa.end(), positive))
        fail_input(
            fmt::format("p = k zⁿ needs two or more sinkages and pressures above 0 (there are {}). Press the "
                        "plate with more loads?",
                        sinkage_m.size()));
    if (are_all_equal(sinkage_m))
        fail_input(fmt::format("p = k zⁿ needs sinkages that differ (all are {} m). Press the plate with other loads?",
                               sinkage_m.front()));
    std::vector<double> x, y;
    for (std::size_t k = 0; k < sinkage_m.size(); ++k)
        x.push_back(std::log(sinkage_m[k])), y.push_back(std::log(pressure_Pa[k]));
    const Line line = fit_line(x, y);
    return {std::exp(line.c0), line.c1};
}

ShearCurve read_shear_curve(const ShearTest& test) {
    const auto& j = test.displacement_m;
    const auto& t = test.shear_Pa;
    if (j.size() < 4 || j.size() != t.size() || !(j.back() > j.front()))
        fail_input("a shear test needs four points or more with growing displacement. Drag the plate further?");
    const double middle = j.front() + 0.5 * (j.back() - j.front());
    const auto integrate = [&](bool late, auto&& f) {
        double sum = 0;
        for (std::size_t k = 1; k < j.size(); ++k)
            if ((j[k] > middle) == late) sum += 0.5 * (f(t[k - 1]) + f(t[k])) * (j[k] - j[k - 1]);
        return sum;
    };
    const double length = integrate(true, [](double) { return 1.0; });
    ShearCurve curve;
    curve.strength_Pa = integrate(true, [](double tau) { return tau; }) / length;
    curve.displacement_m = std::max(0.0, integrate(false, [&](double tau) { return 1.0 - tau / curve.strength_Pa; }));
    return curve;
}

ShearStrength fit_shear_strength(std::span<const ShearTest> tests) {
    if (tests.size() < 2)
        fail_input(
            fmt::format("c and tan φ need two shear tests or more (there are {}). Drag the plate under more "
                        "loads?",
                        tests.size()));
    std::vector<double> sigma, tau;
    ShearStrength s;
    for (const ShearTest& test : tests) {
        const ShearCurve curve = read_shear_curve(test);
        sigma.push_back(test.normal_Pa), tau.push_back(curve.strength_Pa);
        s.displacement_m += curve.displacement_m / static_cast<double>(tests.size());
    }
    if (are_all_equal(sigma))
        fail_input(
            fmt::format("c and tan φ need shear tests under pressures that differ (all are {} Pa). Drag the plate "
                        "under other loads?",
                        sigma.front()));
    const Line line = fit_line(sigma, tau);
    s.cohesion_Pa = line.c0, s.friction = line.c1;
    if (line.c0 < 0) {
        double c1 = 0, variance = 0, squares = 0;
        gsl_fit_mul(sigma.data(), 1, tau.data(), 1, sigma.size(), &c1, &variance, &squares);
        s.cohesion_Pa = 0, s.friction = c1;
    }
    return s;
}

}  // namespace ifedem

#include "traction/parametric_wheel.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>

#include "core/bitmath.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

double peak_rad(const ParametricWheel& w, double slip, double entry_rad) { return (w.c1 + w.c2 * slip) * entry_rad; }

double normal_Pa(const ParametricWheel& w, double slip, double entry, double at) {
    if (at > entry || at < w.rear_rad) return 0;
    const double peak = peak_rad(w, slip, entry);
    const double front = at >= peak ? at : entry - (at - w.rear_rad) / (peak - w.rear_rad) * (entry - peak);
    // cos(front) − cos(entry) as a product: of angles that are both small the difference would be round-off.
    const double depth = w.arc.radius_m * 2.0 * std::sin(0.5 * (entry + front)) * std::sin(0.5 * (entry - front));
    return depth > 0 ? w.pressure.modulus_Pa_mn * std::pow(depth, w.pressure.exponent) : 0.0;
}

double tangential_Pa(const ParametricWheel& w, double slip, double entry, double at) {
    const double j = w.arc.radius_m * ((entry - at) - (1.0 - slip) * (std::sin(entry) - std::sin(at)));
    if (at > entry || at < w.rear_rad || j == 0) return 0;
    return std::copysign(shear_stress_Pa(w.shear, normal_Pa(w, slip, entry, at), std::fabs(j)), j);
}

void check(const ParametricWheel& w, double slip) {
    const double share = w.c1 + w.c2 * slip;
    if (w.pressure.modulus_Pa_mn > 0 && w.pressure.exponent > 0 && w.rear_rad <= 0 && share > 0 && share < 1) return;
    fail_input(
        fmt::format("the wheel has no pressure to work with (k = {:.4g}, n = {:.4g}, θ_2 = {:.4g} rad, θ_m/θ_1 = "
                    "{:.4g}). Give k and n above 0, θ_2 not above 0, and c1 + c2 i between 0 and 1?",
                    w.pressure.modulus_Pa_mn, w.pressure.exponent, w.rear_rad, share));
}

/// What the root finder sees: load carried at an entry angle less the load.
struct Excess {
    const ParametricWheel& wheel;
    double slip, load_N;
    static double at(double entry, void* self) {
        const auto& e = *static_cast<Excess*>(self);
        const StressField field = wheel_stress(e.wheel, e.slip, entry);
        return integrate_stress(field, e.wheel.arc, Sharing::printed).load_N.value - e.load_N;
    }
};

struct FreeSolver {
    void operator()(gsl_root_fsolver* s) const { gsl_root_fsolver_free(s); }
};

[[noreturn]] void fail_search(const ParametricWheel& w, double slip, double load_N, int status) {
    fail_input(fmt::format(
        "the entry angle under {} N at slip {} cannot be found (GSL: {}; k = {:.4g}, n = {:.4g}, c = {:.4g} Pa, "
        "tan φ = {:.4g}, K = {:.4g} m). Check these numbers?",
        load_N, slip, gsl_strerror(status), w.pressure.modulus_Pa_mn, w.pressure.exponent, w.shear.cohesion_Pa,
        w.shear.friction, w.shear.displacement_m));
}

/// The first interval whose ends carry less and not less than the load: the load may fall again where the shear lifts
/// less than it pushes down.
struct Bracket {
    double low_rad = 0, high_rad = 0;
};
Bracket find_bracket(Excess& excess) {
    constexpr int parts = 45;
    constexpr double least = 1e-4;  // a nanometre of sinkage
    if (Excess::at(least, &excess) >= 0)
        fail_input(
            fmt::format("{} N at slip {} are carried with less than a nanometre of sinkage (the soil is too hard, or "
                        "there is no load). Check the units of k and n, and the load?",
                        excess.load_N, excess.slip));
    double low = least;
    for (int k = 1; k <= parts; ++k) {
        const double high = 0.5 * pi * k / parts;
        if (!(Excess::at(high, &excess) < 0)) return {low, high};
        low = high;
    }
    fail_input(
        fmt::format("no entry angle up to 90° carries {} N at slip {} (the soil is too soft). Check the "
                    "units of k and n?",
                    excess.load_N, excess.slip));
}

double find_entry_rad(const ParametricWheel& wheel, double slip, double load_N) {
    gsl_set_error_handler_off();
    Excess excess{wheel, slip, load_N};
    gsl_function f{&Excess::at, &excess};
    const std::unique_ptr<gsl_root_fsolver, FreeSolver> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
    const auto [low, high] = find_bracket(excess);
    int status = gsl_root_fsolver_set(solver.get(), &f, low, high);
    bool found = false;
    for (int n = 0; n < 100 && status == GSL_SUCCESS && !found; ++n) {
        status = gsl_root_fsolver_iterate(solver.get());
        const double a = gsl_root_fsolver_x_lower(solver.get()), b = gsl_root_fsolver_x_upper(solver.get());
        found = gsl_root_test_interval(a, b, 0, 1e-13) == GSL_SUCCESS;
    }
    if (status != GSL_SUCCESS || !found)
        fail_search(wheel, slip, load_N, status != GSL_SUCCESS ? status : GSL_EMAXITER);
    return gsl_root_fsolver_root(solver.get());
}

}  // namespace

double shear_stress_Pa(const ShearStrength& shear, double normal_Pa, double displacement_m) {
    const double strength = shear.cohesion_Pa + normal_Pa * shear.friction;
    if (!(shear.displacement_m > 0)) return strength;
    return strength * (1.0 - std::exp(-displacement_m / shear.displacement_m));
}

StressField wheel_stress(const ParametricWheel& wheel, double slip, double entry_rad) {
    check(wheel, slip);
    const auto forward = [](double theta) { return 0.5 * pi - theta; };
    return {[=](double theta) { return normal_Pa(wheel, slip, entry_rad, forward(theta)); },
            [=](double theta) { return tangential_Pa(wheel, slip, entry_rad, forward(theta)); },
            forward(entry_rad),
            forward(wheel.rear_rad),
            {forward(peak_rad(wheel, slip, entry_rad))}};
}

ParametricResult solve_wheel(const ParametricWheel& wheel, double slip, double load_N, Sharing sharing) {
    check(wheel, slip);
    ParametricResult result;
    result.entry_rad = find_entry_rad(wheel, slip, load_N);
    result.greatest_normal_rad = peak_rad(wheel, slip, result.entry_rad);
    result.sinkage_m = wheel.arc.radius_m * (1.0 - std::cos(result.entry_rad));
    const StressField field = wheel_stress(wheel, slip, result.entry_rad);
    result.traction = integrate_stress(field, wheel.arc, sharing);
    result.torque_Nm =
        wheel.arc.width_m * wheel.arc.radius_m * wheel.arc.radius_m * integrate_over(field, field.tangential_Pa).value;
    return result;
}

}  // namespace ifedem

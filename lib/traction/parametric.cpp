#include "traction/parametric.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bitmath.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr double bottom_rad = 0.5 * pi;
constexpr std::size_t most_intervals = 20000;
constexpr double least_piece_rad = 1e-12;

struct FreeWorkspace {
    void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
};

double call(double x, void* f) { return (*static_cast<const std::function<double(double)>*>(f))(x); }

/// `floor`: an absolute error small enough whatever the value, so that an integral that vanishes ends too.
Integral integrate_smooth(const std::function<double(double)>& f, double from, double to, double floor) {
    if (!(to > from)) return {};
    gsl_set_error_handler_off();
    const std::unique_ptr<gsl_integration_workspace, FreeWorkspace> work(
        gsl_integration_workspace_alloc(most_intervals));
    std::function<double(double)> copy = f;
    gsl_function function{call, &copy};
    Integral result;
    const int status = gsl_integration_qag(&function, from, to, floor, 1e-10, most_intervals, GSL_INTEG_GAUSS31,
                                           work.get(), &result.value, &result.error);
    // Round-off (GSL_EROUND) still leaves a value with its error; the caller sees how large that is.
    if ((status != 0 && status != GSL_EROUND) || !std::isfinite(result.value))
        fail_input(
            fmt::format("the stress cannot be integrated between {:.4g} and {:.4g} rad ({}). Is it bounded and "
                        "piecewise smooth?",
                        from, to, gsl_strerror(status)));
    return result;
}

/// Piece by piece: at bottom dead centre the forms change, at kinks the stress.
Integral integrate_arc(const StressField& field, const std::function<double(double)>& f, double floor) {
    std::vector<double> nodes{field.entry_rad, field.exit_rad};
    // An end that a sum of angles has put beside a node: a piece of no more than round-off has no room for a rule's
    // points.
    const auto add = [&](double at) {
        if (at > field.entry_rad + least_piece_rad && at < field.exit_rad - least_piece_rad) nodes.push_back(at);
    };
    add(bottom_rad);
    for (const double kink : field.kinks_rad) add(kink);
    std::sort(nodes.begin(), nodes.end());
    Integral sum;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        const Integral piece = integrate_smooth(f, nodes[k - 1], nodes[k], floor);
        sum.value += piece.value, sum.error += piece.error;
    }
    return sum;
}

Integral scale(const Integral& i, double by) { return {by * i.value, std::fabs(by) * i.error}; }
Integral sum(const Integral& a, const Integral& b) { return {a.value + b.value, a.error + b.error}; }

void check(const StressField& field, const ContactArc& arc) {
    if (arc.width_m > 0 && arc.radius_m > 0 && field.exit_rad > field.entry_rad) return;
    fail_input(
        fmt::format("there is no contact to integrate over (from {:.4g} to {:.4g} rad, width {} m, radius {} m). "
                    "Give an exit beyond the entry, width and radius above 0?",
                    field.entry_rad, field.exit_rad, arc.width_m, arc.radius_m));
}

}  // namespace

Integral integrate_over(const StressField& field, const std::function<double(double)>& f) {
    return integrate_arc(field, f, 0.0);
}

TractiveIntegrals integrate_stress(const StressField& field, const ContactArc& arc, Sharing sharing,
                                   VerticalForm vertical) {
    check(field, arc);
    const auto& sigma = field.normal_Pa;
    const auto& tau = field.tangential_Pa;
    const double area = arc.width_m * arc.radius_m;
    const Integral size = integrate_arc(
        field, [&](double t) { return std::fabs(sigma(t)) + std::fabs(tau(t)); }, 1e-300);
    const double floor = 1e-11 * size.value + 1e-300;
    const auto over_arc = [&](auto&& f) { return scale(integrate_arc(field, f, floor), area); };

    TractiveIntegrals out;
    const bool moved = sharing == Sharing::as_written;
    const auto thrust = [&](double t) { return moved ? std::fmax(tau(t), 0.0) : tau(t); };
    const auto drag = [&](double t) { return moved ? std::fmin(tau(t), 0.0) : 0.0; };
    const auto front = [&](double t) { return !moved || t < bottom_rad ? sigma(t) * std::cos(t) : 0.0; };
    const auto rear = [&](double t) { return moved && t >= bottom_rad ? sigma(t) * std::cos(t) : 0.0; };
    out.gross_tractive_effort_N = over_arc([&](double t) { return thrust(t) * std::sin(t) - rear(t); });
    out.motion_resistance_N = over_arc([&](double t) { return drag(t) * std::sin(t) - front(t); });
    out.net_traction_N = sum(out.gross_tractive_effort_N, out.motion_resistance_N);
    const double rear_sign = vertical == VerticalForm::printed ? -1.0 : 1.0;
    out.load_N = over_arc(
        [&](double t) { return sigma(t) * std::sin(t) + (t < bottom_rad ? 1.0 : rear_sign) * tau(t) * std::cos(t); });
    return out;
}

std::function<double(double)> make_spline(std::span<const double> x, std::span<const double> y) {
    if (x.size() < 3 || x.size() != y.size())
        fail_input(
            fmt::format("a spline needs three points or more (there are {}). Average over a longer window?", x.size()));
    gsl_set_error_handler_off();
    const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(gsl_interp_cspline, x.size()), gsl_spline_free);
    if (gsl_spline_init(spline.get(), x.data(), y.data(), x.size()) != 0)
        fail_input("the points of a spline do not ascend. Sort them?");
    return [spline, from = x.front(), to = x.back()](double at) {
        return at < from || at > to ? 0.0 : gsl_spline_eval(spline.get(), at, nullptr);
    };
}

}  // namespace ifedem

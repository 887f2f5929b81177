#include "step/stable_phase.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace ifedem {
namespace {

using Vector = Eigen::Vector3d;  // x, v Δt, a Δt² (the last one for modified Euler with one evaluation only)

/// One step as integrate_discs() makes it, in units of the step.
Vector step_once(Integrator integrator, double phase, double damping_ratio, const Vector& now) {
    const auto acceleration = [&](double x, double v) { return -phase * phase * x - 2 * damping_ratio * phase * v; };
    const double x = now(0), v = now(1);
    if (integrator == Integrator::symplectic_euler) {
        const double after = v + acceleration(x, v);
        return {x + after, after, 0};
    }
    if (integrator == Integrator::modified_euler_one) {
        const double a = acceleration(x, v), change = a - now(2);
        const double corrected_x = x + 0.25 * change, corrected_v = v + 0.5 * change;
        return {corrected_x + corrected_v + 0.5 * a, corrected_v + a, a};
    }
    const double a = acceleration(x, v);
    const double predicted_x = x + v + 0.5 * a, predicted_v = v + a;
    const double change = acceleration(predicted_x, predicted_v) - a;
    return {predicted_x + 0.25 * change, predicted_v + 0.5 * change, 0};
}

}  // namespace

double amplification(Integrator integrator, double phase, double damping_ratio) {
    Eigen::Matrix3d m;
    for (int k = 0; k < 3; ++k) m.col(k) = step_once(integrator, phase, damping_ratio, Vector::Unit(k));
    return Eigen::EigenSolver<Eigen::Matrix3d>(m, false).eigenvalues().cwiseAbs().maxCoeff();
}

double largest_stable_phase(Integrator integrator, double damping_ratio) {
    if (integrator == Integrator::symplectic_euler)
        return 2 * (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio);
    constexpr double stride = 0.01, most = 2.5, growth = 1e-6;
    const auto grows = [&](double phase) { return amplification(integrator, phase, damping_ratio) > 1 + growth; };
    double low = 0, high = stride;
    while (high < most && !grows(high)) low = high, high += stride;
    for (int k = 0; k < 40; ++k) (grows(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return low;
}

}  // namespace ifedem

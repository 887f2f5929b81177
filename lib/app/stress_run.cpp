#include "app/stress_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check/statistics.hpp"
#include "core/bitmath.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr std::size_t replicates = 400;

ContactArc arc_of(const Case& c) { return {c.wheel.width_m, c.wheel.tread_radius_m}; }

/// Sums over the segments of the lower half with their centres' angles.
struct SegmentTotals {
    double fx_N = 0, fy_N = 0;              ///< true vectors
    double turned_x_N = 0, turned_y_N = 0;  ///< from the radial parts
    double moment_Nm = 0, circumferential_sin_N = 0;
};
SegmentTotals add_segments(const std::vector<MeanSegment>& means) {
    SegmentTotals t;
    for (std::size_t k = 0; k + 1 < means.size(); ++k) {
        const SegmentSum& m = means[k].mean;
        const double c = std::cos(means[k].angle_rad), s = std::sin(means[k].angle_rad);
        t.fx_N += m.fx_N, t.fy_N += m.fy_N;
        t.turned_x_N += m.circumferential_N * s - m.radial_N * c;
        t.turned_y_N += m.radial_N * s + m.circumferential_N * c;
        t.moment_Nm += m.moment_Nm;
        t.circumferential_sin_N += m.circumferential_N * s;
    }
    return t;
}

void integrate_run(const std::vector<MeanSegment>& means, StressRun& r) {
    const ContactArc arc = arc_of(r.c);
    const StressCurve radial = make_stress_curve(means, arc, Decomposition::radial);
    const StressField field = make_field(radial);
    const StressField surface = make_field(make_stress_curve(means, arc, Decomposition::surface));
    const TractiveIntegrals written = integrate_stress(field, arc, Sharing::as_written);
    const TractiveIntegrals printed = integrate_stress(field, arc, Sharing::printed, VerticalForm::printed);
    r.features = find_features(radial, kernel_half_width_rad(r.c));
    r.integral_H_N = written.gross_tractive_effort_N.value;
    r.integral_P_N = written.net_traction_N.value;
    r.integral_R_N = written.motion_resistance_N.value;
    r.printed_H_N = printed.gross_tractive_effort_N.value;
    r.printed_R_N = printed.motion_resistance_N.value;
    r.load_N = written.load_N.value;
    r.load_printed_N = printed.load_N.value;
    r.load_surface_N = integrate_stress(surface, arc).load_N.value;
    r.load_surface_printed_N = integrate_stress(surface, arc, Sharing::printed, VerticalForm::printed).load_N.value;
    for (const Integral& i : {written.gross_tractive_effort_N, written.motion_resistance_N, written.net_traction_N,
                              written.load_N, printed.load_N})
        r.quadrature = std::max(r.quadrature, i.error / r.c.wheel.load_N);
}

}  // namespace

double kernel_half_width_rad(const Case& c) {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < c.soil.radii_m.size(); ++k)
        sum += 2 * c.soil.radii_m[k] * c.soil.radii_shares[k], count += c.soil.radii_shares[k];
    return sum / count / c.wheel.tread_radius_m;
}

StressRun analyse_run(const std::string& name, const Case& c, StressState stress, const SurfaceMeasure& surface,
                      std::vector<RunValue> values) {
    StressRun r;
    r.name = name, r.c = c, r.surface = surface, r.values = std::move(values);
    const std::vector<MeanSegment> means = mean_segments(stress);
    if (means.empty()) fail_input(fmt::format("{}: the hub never was in the averaging window. Travel further?", name));
    const StressBlock b = sum_blocks(stress);
    const double time_s = b.steps * c.time_step_s, load = c.wheel.load_N;
    const double torque = b.torque_Nm / b.steps, radius = b.effective_radius_m / b.steps;
    r.gross_tractive_effort_N = torque / radius;
    r.net_traction_N = -b.drawbar_N / b.steps;
    r.motion_resistance_N = r.net_traction_N - r.gross_tractive_effort_N;
    integrate_run(means, r);
    const SegmentTotals t = add_segments(means);
    r.horizontal = (r.integral_P_N - r.net_traction_N - b.impulse_x_Ns / time_s) / load;
    r.vertical = (r.load_N - load - b.impulse_y_Ns / time_s) / load;
    r.torque = (t.moment_Nm - torque + b.spin_Nms / time_s) / torque;
    r.difference_H = (r.gross_tractive_effort_N - b.spin_Nms / time_s / radius - r.printed_H_N -
                      (t.moment_Nm / radius - t.circumferential_sin_N)) /
                     load;
    r.vectors = std::hypot(t.fx_N - t.turned_x_N, t.fy_N - t.turned_y_N) / load;
    r.splines = std::max({std::fabs(r.integral_P_N - t.turned_x_N), std::fabs(r.load_N - t.turned_y_N),
                          std::fabs(r.printed_H_N - t.circumferential_sin_N)}) /
                load;
    r.stress = std::move(stress);
    return r;
}

SlipGroup analyse_slip(double slip_percent, std::vector<StressRun> runs) {
    SlipGroup g;
    g.slip_percent = slip_percent;
    g.run = std::move(runs);
    const ContactArc arc = arc_of(g.run.front().c);
    const auto average = [&](Decomposition d) {
        StressCurve sum;
        for (const StressRun& r : g.run) {
            const StressCurve c = make_stress_curve(mean_segments(r.stress), arc, d);
            if (sum.angle_rad.empty())
                sum = {c.angle_rad, std::vector<double>(c.angle_rad.size()), std::vector<double>(c.angle_rad.size())};
            for (std::size_t k = 0; k < c.angle_rad.size(); ++k) {
                sum.normal_Pa[k] += c.normal_Pa[k] / static_cast<double>(g.run.size());
                sum.tangential_Pa[k] += c.tangential_Pa[k] / static_cast<double>(g.run.size());
            }
        }
        return sum;
    };
    g.radial = average(Decomposition::radial);
    g.surface = average(Decomposition::surface);
    const double half = kernel_half_width_rad(g.run.front().c);
    g.features = find_features(g.radial, half);
    std::vector<StressState> states;
    for (const StressRun& r : g.run) states.push_back(r.stress);
    Random random{4};
    g.replicate = bootstrap_features(states, arc, Decomposition::radial, half, replicates, random);
    return g;
}

double mean_of(const SlipGroup& group, double StressRun::*member) {
    std::vector<double> values;
    for (const StressRun& r : group.run) values.push_back(r.*member);
    return mean(values);
}

Interval interval_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
    };
    return {at(0.025), at(0.975)};
}

}  // namespace ifedem

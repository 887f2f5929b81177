#include "app/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/soil.hpp"
#include "app/stress_files.hpp"
#include "app/stress_measures.hpp"
#include "check/csv.hpp"
#include "check/run.hpp"
#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "record/files.hpp"

namespace ifedem {
namespace {

constexpr double degrees = 180 / pi;

std::string curves_table(const std::vector<SlipGroup>& groups) {
    std::string text = "slip_percent,theta_deg,radial_kPa,circumferential_kPa,normal_kPa,tangential_kPa\n";
    for (const SlipGroup& g : groups) {
        if (&g != &groups.front()) text += "\n\n";  // gnuplot: an index a slip
        const double half = kernel_half_width_rad(g.run.front().c);
        const double spacing = g.radial.angle_rad[1] - g.radial.angle_rad[0];
        const auto smoothed = [&](const std::vector<double>& y) { return smooth(y, spacing, half); };
        const auto a = smoothed(g.radial.normal_Pa), b = smoothed(g.radial.tangential_Pa);
        const auto c = smoothed(g.surface.normal_Pa), d = smoothed(g.surface.tangential_Pa);
        for (std::size_t k = 0; k < a.size(); ++k)
            text += fmt::format("{:g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", g.slip_percent,
                                g.radial.angle_rad[k] * degrees, 1e-3 * a[k], 1e-3 * b[k], 1e-3 * c[k], 1e-3 * d[k]);
    }
    return text;
}

std::string angles_table(const std::vector<SlipGroup>& groups) {
    std::string text =
        "slip_percent,entry_1_deg,entry_2_deg,entry_5_deg,exit_1_deg,exit_2_deg,exit_5_deg,normal_deg,normal_low_deg,"
        "normal_high_deg,tangential_deg,tangential_low_deg,tangential_high_deg\n";
    for (const SlipGroup& g : groups) {
        text += fmt::format("{:g}", g.slip_percent);
        for (const double e : g.features.entry_rad) text += fmt::format(",{:.5g}", e * degrees);
        for (const double e : g.features.exit_rad) text += fmt::format(",{:.5g}", e * degrees);
        const auto add = [&](double CurveFeatures::*member) {
            const Interval i = interval_of(g, [&](const CurveFeatures& f) { return f.*member; });
            text +=
                fmt::format(",{:.5g},{:.5g},{:.5g}", g.features.*member * degrees, i.low * degrees, i.high * degrees);
        };
        add(&CurveFeatures::greatest_normal_rad);
        add(&CurveFeatures::greatest_tangential_rad);
        text += "\n";
    }
    return text;
}

std::string relative_peak_table(const std::vector<SlipGroup>& groups) {
    std::string text = "slip,relative_peak,low,high\n";
    for (const SlipGroup& g : groups) {
        const Interval i = interval_of(g, [](const CurveFeatures& f) { return f.relative_peak(); });
        text += fmt::format("{:g},{:.5g},{:.5g},{:.5g}\n", 0.01 * g.slip_percent, g.features.relative_peak(), i.low,
                            i.high);
    }
    return text;
}

std::string performance_table(const std::vector<SlipGroup>& groups) {
    std::string text = "slip_percent,H_N,P_N,R_N,H_integral_N,P_integral_N,R_integral_N,H_printed_N,R_printed_N\n";
    for (const SlipGroup& g : groups) {
        text += fmt::format("{:g}", g.slip_percent);
        for (const auto member : {&StressRun::gross_tractive_effort_N, &StressRun::net_traction_N,
                                  &StressRun::motion_resistance_N, &StressRun::integral_H_N, &StressRun::integral_P_N,
                                  &StressRun::integral_R_N, &StressRun::printed_H_N, &StressRun::printed_R_N})
            text += fmt::format(",{:.6g}", mean_of(g, member));
        text += "\n";
    }
    return text;
}

std::string load_table(const std::vector<SlipGroup>& groups) {
    std::string text = "slip_percent,radial_N,surface_N,radial_printed_N,surface_printed_N,load_N\n";
    for (const SlipGroup& g : groups)
        text += fmt::format("{:g},{:.6g},{:.6g},{:.6g},{:.6g},{:g}\n", g.slip_percent, mean_of(g, &StressRun::load_N),
                            mean_of(g, &StressRun::load_surface_N), mean_of(g, &StressRun::load_printed_N),
                            mean_of(g, &StressRun::load_surface_printed_N), g.run.front().c.wheel.load_N);
    return text;
}

/// The semi-empirical wheel from the least to the greatest slip.
std::string parametric_table(const std::vector<SlipGroup>& groups, const SoilParameters& soil) {
    const Case& c = groups.front().run.front().c;
    const ParametricWheel wheel = wong_reece_wheel(c, soil);
    std::string text = "slip_percent,H_N,P_N,R_N,entry_deg,normal_deg,sinkage_mm,torque_Nm\n";
    constexpr int points = 60;
    for (int k = 0; k <= points; ++k) {
        const double slip =
            groups.front().slip_percent + (groups.back().slip_percent - groups.front().slip_percent) * k / points;
        const ParametricResult r = solve_wheel(wheel, 0.01 * slip, c.wheel.load_N);
        text += fmt::format("{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g}\n", slip,
                            r.traction.gross_tractive_effort_N.value, r.traction.net_traction_N.value,
                            r.traction.motion_resistance_N.value, 90 - r.entry_rad * degrees,
                            90 - r.greatest_normal_rad * degrees, 1e3 * r.sinkage_m, r.torque_Nm);
    }
    text += "\n\n";  // gnuplot: the travels are index 1
    for (const SlipGroup& g : groups)
        text += fmt::format("{:g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", g.slip_percent,
                            mean_of(g, &StressRun::gross_tractive_effort_N), mean_of(g, &StressRun::net_traction_N),
                            mean_of(g, &StressRun::motion_resistance_N), mean_of(g, &StressRun::integral_H_N),
                            mean_of(g, &StressRun::integral_P_N), mean_of(g, &StressRun::integral_R_N));
    return text;
}

std::vector<SlipGroup> group_runs(const std::vector<std::string>& directories) {
    std::map<double, std::vector<StressRun>> by_slip;
    for (const std::string& directory : directories) {
        const Run run = read_run(directory);
        by_slip[run.c.travel.slip_percent].push_back(analyse_run(run.name, run.c, read_contact_stress(directory, run.c),
                                                                 measure_surface(directory), run.values));
    }
    std::vector<SlipGroup> groups;
    for (auto& [slip, runs] : by_slip) groups.push_back(analyse_slip(slip, std::move(runs)));
    return groups;
}

}  // namespace

void write_stress(const StressRequest& request) {
    const std::vector<SlipGroup> groups = group_runs(request.run_directories);
    const auto write = [&](const char* name, const std::string& text) {
        write_text(request.directory + "/" + name, text);
    };
    write("curves.csv", curves_table(groups));
    write("angles.csv", angles_table(groups));
    write("relative_peak.csv", relative_peak_table(groups));
    write("performance.csv", performance_table(groups));
    write("load.csv", load_table(groups));
    if (!request.soil_directory.empty())
        write("parametric.csv", parametric_table(groups, read_soil(request.soil_directory)));
    write("measurements.csv", measurements_csv(measure_stress(groups)));
}

}  // namespace ifedem

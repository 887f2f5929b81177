#include "app/points_sources.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/soil.hpp"
#include "app/stress_files.hpp"
#include "app/stress_run.hpp"
#include "traction/contact_stress_curve.hpp"

namespace ifedem {
namespace {

constexpr const char* normal_peak = "greatest_normal_stress_kPa";
constexpr const char* tangential_peak = "greatest_tangential_stress_kPa";

Values predict(const SoilParameters& soil, const Case& c) {
    const double slip = 0.01 * c.travel.slip_percent;
    const ParametricWheel wheel = wong_reece_wheel(c, soil);
    const ParametricResult r = solve_wheel(wheel, slip, c.wheel.load_N);
    const StressField field = wheel_stress(wheel, slip, r.entry_rad);
    double normal = 0, tangential = 0;
    constexpr int parts = 2000;
    for (int k = 0; k <= parts; ++k) {
        const double theta = field.entry_rad + (field.exit_rad - field.entry_rad) * k / parts;
        normal = std::max(normal, field.normal_Pa(theta));
        tangential = std::max(tangential, field.tangential_Pa(theta));
    }
    return {{"gross_tractive_effort_N", r.traction.gross_tractive_effort_N.value},
            {"net_traction_N", r.traction.net_traction_N.value},
            {"motion_resistance_N", r.traction.motion_resistance_N.value},
            {"sinkage_cm", -100 * r.sinkage_m},
            {normal_peak, 1e-3 * normal},
            {tangential_peak, 1e-3 * tangential}};
}

}  // namespace

Values measure_stress_peaks(const Run& run) {
    if (run.c.record.stress_segments == 0) return {};
    const auto means = mean_segments(read_contact_stress(run.directory, run.c));
    const ContactArc arc{run.c.wheel.width_m, run.c.wheel.tread_radius_m};
    const CurveFeatures f =
        find_features(make_stress_curve(means, arc, Decomposition::radial), kernel_half_width_rad(run.c));
    return {{normal_peak, 1e-3 * f.greatest_normal_Pa}, {tangential_peak, 1e-3 * f.greatest_tangential_Pa}};
}

ModelWithoutRuns semi_empirical_wheel(const std::string& soil_directory,
                                      const std::vector<std::string>& plate_directories) {
    const SoilParameters soil = read_soil(soil_directory);
    Work work;
    double cpu_ns = 0;
    for (const std::string& directory : plate_directories) {
        const Run plate = read_run(directory);
        const double steps = plate.number("particles") * plate.number("total_steps");
        work.disc_steps += steps;
        cpu_ns += steps * plate.number("ns_per_particle_step");
    }
    work.ns_per_disc_step = work.disc_steps > 0 ? cpu_ns / work.disc_steps : 0;
    return {
        "semi-empirical",
        fmt::format("rigid wheel of Wong & Reece on the soil of {} plate tests, whose cost counts once; each further "
                    "slip takes less than a millisecond",
                    plate_directories.size()),
        work, [soil](const Case& c) { return predict(soil, c); }};
}

}  // namespace ifedem

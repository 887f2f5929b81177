#include "app/run_info.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "core/bitmath.hpp"
#include "dem/bed.hpp"
#include "record/checkpoint.hpp"

namespace ifedem {

std::string program_version() { return IFEDEM_VERSION; }

std::string compiler_name() {
#if defined(__clang__)
    return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::vector<RunValue> describe_stage(const Case& c, const State& state, Stage stage) {
    const double largest = *std::max_element(c.soil.radii_m.begin(), c.soil.radii_m.end());
    const double surface = measure_surface_m(state.discs, c.bed.length_m, largest);
    const auto number = [](double v) { return fmt::format("{:.6g}", v); };
    std::vector<RunValue> values = {
        {"v_rms_m_s", number(rms_speed_m_s(state.discs)), "m/s"},
        {"surface_m", number(surface), "m"},
    };
    // What is within 10 r_max of a border is not soil in bulk, and in a small bed there is nothing else.
    const double margin = 10 * largest, length = c.bed.length_m;
    if (std::min(surface, length) > 2 * margin)
        values.push_back(
            {"porosity", number(measure_porosity(state.discs, length, margin, margin, surface - margin)), ""});
    double area = 0;
    for (const Disc& d : state.discs.disc) area += pi * d.radius_m * d.radius_m;
    values.push_back({"porosity_whole", number(1 - area / (length * surface)), ""});
    if (stage == Stage::sinkage)
        values.push_back({"sinkage_m", number(state.wheel.rim.position_m.y - state.touch_position_m.y), "m"});
    return values;
}

double peak_memory_MB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

std::vector<RunValue> describe_run(const Case& c, const State& state, int threads) {
    std::vector<RunValue> values = {
        {"case", c.name, ""},
        {"version", program_version(), ""},
        {"results_version", fmt::format("{}", results_version), ""},
        {"compiler", compiler_name(), ""},
        {"threads", fmt::format("{}", threads), ""},
        {"peak_memory_MB", fmt::format("{:.1f}", peak_memory_MB()), "MB"},
        {"total_steps", fmt::format("{}", state.progress.total_steps), ""},
    };
    return values;
}

}  // namespace ifedem

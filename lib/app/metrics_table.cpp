#include "app/metrics_table.hpp"

#include <fmt/format.h>

#include "check/metrics.hpp"
#include "check/run.hpp"
#include "record/results.hpp"

namespace ifedem {

void write_metrics(const std::vector<std::string>& run_directories, const std::string& out_path) {
    constexpr double full_travel_m = 0.8;  // what averaging_window() speaks of
    std::string text = "run";
    for (const MetricInfo& m : metric_table()) text += fmt::format(",{}", m.name);
    text += ",drawbar_deviation_N\n";
    for (const std::string& directory : run_directories) {
        const Run run = read_run(directory);
        const bool own = run.c.record.stress_segments > 0;  // a window of its own, in places of the hub
        const double scale = own ? 1 : run.c.travel.distance_m / full_travel_m;
        const Window whole = averaging_window(run.c);
        const RunMetrics metrics = measure(run, {scale * whole.from_m, scale * whole.to_m});
        text += run.name;
        for (const MetricInfo& m : metric_table()) text += fmt::format(",{:.5g}", metrics.*m.member);
        text += fmt::format(",{:.4g}\n", metrics.drawbar_deviation_N);
    }
    write_file_atomically(out_path, text);
}

}  // namespace ifedem

#include "app/metrics_table.hpp"

#include <fmt/format.h>

#include "check/metrics.hpp"
#include "check/run.hpp"
#include "record/files.hpp"

namespace ifedem {

void write_metrics(const std::vector<std::string>& run_directories, const std::string& out_path) {
    std::string text = "run";
    for (const MetricInfo& m : metric_table()) text += fmt::format(",{}", m.name);
    text += "\n";
    for (const std::string& directory : run_directories) {
        const Run run = read_run(directory);
        const RunMetrics metrics = measure(run, compared_window(run.c));
        text += run.name;
        for (const MetricInfo& m : metric_table()) text += fmt::format(",{:.5g}", metrics.*m.member);
        text += "\n";
    }
    write_file_atomically(out_path, text);
}

}  // namespace ifedem

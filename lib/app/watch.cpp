#include "app/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "app/progress_line.hpp"
#include "model/case.hpp"
#include "step/scene.hpp"

namespace ifedem {
namespace {

/// Share of a run's travel that its series shows; 1 once run.csv is written.
double share_done(const std::string& directory) {
    if (std::filesystem::exists(directory + "/run.csv")) return 1.0;
    std::ifstream file(directory + "/series.csv", std::ios::ate);
    if (!file || !std::filesystem::exists(directory + "/case.toml")) return 0.0;
    const auto size = static_cast<std::streamoff>(file.tellg());
    file.seekg(std::max<std::streamoff>(0, size - 4096));
    std::string line, last;
    while (std::getline(file, line))
        if (!line.empty()) last = line;
    try {
        const Case c = read_case(directory + "/case.toml");
        const double total = static_cast<double>(steps_of_stage(c, Stage::travel)) * c.time_step_s;
        return std::stod(last) / total;
    } catch (const std::exception&) {
        return 0.0;  // only the head is there yet
    }
}

}  // namespace

void watch_runs(const WatchRequest& request) {
    const auto begin = std::chrono::steady_clock::now();
    const pid_t parent = getppid();
    double first = -1;
    while (getppid() == parent) {
        double sum = 0;
        std::size_t complete = 0;
        for (const std::string& d : request.directories) {
            const double share = share_done(d);
            sum += share;
            complete += share >= 1.0 ? 1 : 0;
        }
        if (first < 0) first = sum;
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const auto all = static_cast<double>(request.directories.size());
        const std::string left =
            sum > first ? to_duration(elapsed * (all - sum) / (sum - first)) + " left" : "preparing beds";
        fmt::print(stderr, "{} of {} runs done, {:.0f} % of the travel, {}\n", complete, request.directories.size(),
                   100 * sum / all, left);
        if (complete == request.directories.size()) return;
        for (int s = 0; s < 40 && getppid() == parent; ++s) std::this_thread::sleep_for(std::chrono::milliseconds(250));
    }
}

}  // namespace ifedem

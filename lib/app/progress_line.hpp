#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace ifedem {

/// Says how far a run is: a bar that renews itself on a terminal, otherwise a line every few seconds.
class ProgressLine {
public:
    ProgressLine(std::string label, std::uint64_t total_steps, bool quiet);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    void show(std::uint64_t steps_done, const std::string& note);

private:
    using Clock = std::chrono::steady_clock;
    std::string label_;
    std::uint64_t total_, first_ = ~0ULL;
    bool quiet_, terminal_, written_ = false;
    Clock::time_point begin_, next_;
};

/// "1 h 02 min", "3 min 20 s", "12 s".
[[nodiscard]] std::string to_duration(double seconds);

}  // namespace ifedem

#include "app/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace ifedem {

std::string to_duration(double seconds) {
    const auto s = std::lround(seconds);
    if (s >= 3600) return fmt::format("{} h {:02d} min", s / 3600, s / 60 % 60);
    if (s >= 60) return fmt::format("{} min {:02d} s", s / 60, s % 60);
    return fmt::format("{} s", s);
}

ProgressLine::ProgressLine(std::string label, std::uint64_t total_steps, bool quiet)
    : label_(std::move(label)),
      total_(total_steps),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      begin_(Clock::now()),
      next_(begin_) {}

ProgressLine::~ProgressLine() {
    if (written_ && terminal_) std::fputc('\n', stderr);
}

void ProgressLine::show(std::uint64_t steps_done, const std::string& note) {
    const auto now = Clock::now();
    if (first_ == ~0ULL) first_ = steps_done;
    if (quiet_ || now < next_) return;
    next_ = now + (terminal_ ? std::chrono::milliseconds(250) : std::chrono::seconds(5));
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double rate = elapsed > 0 ? static_cast<double>(steps_done - first_) / elapsed : 0;
    const double share = static_cast<double>(steps_done) / static_cast<double>(total_ > 0 ? total_ : 1);
    const std::string left = rate > 0 ? to_duration(static_cast<double>(total_ - steps_done) / rate) : "…";
    if (terminal_) {
        constexpr int width = 30;
        const int full = static_cast<int>(share * width);
        fmt::print(stderr, "\r\033[K{} [{:█<{}}{:·<{}}] {:3.0f} %  {:.0f} steps/s  {} left  {}", label_, "", full, "",
                   width - full, 100 * share, rate, left, note);
    } else {
        fmt::print(stderr, "{}: {:.0f} %, {:.0f} steps/s, {} left, {}\n", label_, 100 * share, rate, left, note);
    }
    std::fflush(stderr);
    written_ = true;
}

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

namespace ifedem {

/// Runs this program once for each list of arguments, at most `jobs` at a time, in order, and returns their exit
/// statuses. SIGTERM and SIGINT are passed on to the children and nothing more is started; what was not started has
/// status −1.
[[nodiscard]] std::vector<int> run_children(const std::vector<std::vector<std::string>>& calls, int jobs);

/// The signal that run_children() met, 0 if none.
[[nodiscard]] int signal_of_children();

/// Says that the same command goes on; returns 128 + that signal, for the shell.
[[nodiscard]] int report_signal();

}  // namespace ifedem

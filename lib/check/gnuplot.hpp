#pragma once
#include <string>
#include <utility>
#include <vector>

namespace ifedem {

/// Runs `gnuplot` on a script with string variables set before it, from any directory. Throws Error(io) if gnuplot is
/// missing, fails, or leaves no file at `output`.
void run_gnuplot(const std::string& script, const std::vector<std::pair<std::string, std::string>>& variables,
                 const std::string& output);

}  // namespace ifedem

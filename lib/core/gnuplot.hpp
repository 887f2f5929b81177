#pragma once
#include <string>
#include <vector>

namespace ifedem {

/// A gnuplot string: in single quotes, those within it doubled, on one line.
[[nodiscard]] std::string quote_for_gnuplot(const std::string& text);

/// Runs `gnuplot` without the user's own settings and without a shell, so that no path needs escaping for one. What it
/// prints goes to the file `log`, if that is named. Returns its exit status; 127: it cannot be started, 126: it was
/// killed.
[[nodiscard]] int execute_gnuplot(std::vector<std::string> arguments, const std::string& log = {});

}  // namespace ifedem

#include "check/gnuplot.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/gnuplot.hpp"

namespace ifedem {

void run_gnuplot(const std::string& script, const std::vector<std::pair<std::string, std::string>>& variables,
                 const std::string& output) {
    // A script loads another by its name beside it, or by its path from the top of the tree that both are in.
    const std::filesystem::path folder = std::filesystem::absolute(script).parent_path();
    std::string settings =
        fmt::format("set loadpath {} {}; output = {}", quote_for_gnuplot(folder.string()),
                    quote_for_gnuplot(folder.parent_path().parent_path().string()), quote_for_gnuplot(output));
    for (const auto& [name, value] : variables) settings += fmt::format("; {} = {}", name, quote_for_gnuplot(value));
    std::error_code ignored;
    std::filesystem::remove(output, ignored);
    const int status = execute_gnuplot({"-e", settings, script});
    if (status == 127) fail_io("Cannot start gnuplot (not installed?). Install the package gnuplot-nox?");
    if (status != 0 || !std::filesystem::exists(output))
        fail_io(fmt::format("gnuplot failed on {} (status {}). Read its message above?", script, status));
}

}  // namespace ifedem

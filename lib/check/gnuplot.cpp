#include "check/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "core/error.hpp"

namespace ifedem {
namespace {

/// A gnuplot string: single quotes are doubled.
std::string quote(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        out += c;
        if (c == '\'') out += c;
    }
    return out + "'";
}

/// Without a shell, so that no path needs escaping for one. Returns the exit status, 127 if the program is missing.
int execute(std::vector<std::string> arguments) {
    std::vector<char*> raw;
    for (auto& a : arguments) raw.push_back(a.data());
    raw.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        execvp(raw[0], raw.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return 126;
    return WEXITSTATUS(status);
}

}  // namespace

void run_gnuplot(const std::string& script, const std::vector<std::pair<std::string, std::string>>& variables,
                 const std::string& output) {
    std::string settings = fmt::format("output = {}", quote(output));
    for (const auto& [name, value] : variables) settings += fmt::format("; {} = {}", name, quote(value));
    std::error_code ignored;
    std::filesystem::remove(output, ignored);
    const int status = execute({"gnuplot", "-e", settings, script});
    if (status == 127) fail_io("Cannot start gnuplot (not installed?). Install the package gnuplot-nox.");
    if (status != 0 || !std::filesystem::exists(output))
        fail_io(fmt::format("gnuplot failed on {} (status {}). Read its message above.", script, status));
}

}  // namespace ifedem

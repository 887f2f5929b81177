#include "app/find_run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "check/run.hpp"
#include "core/error.hpp"
#include "record/checkpoint.hpp"
#include "step/stages.hpp"

namespace ifedem {
namespace {

std::string text_without_name(Case c) {
    c.name.clear();
    return to_toml(c);
}

/// A directory that cannot be read holds no run that one could use.
bool holds_run(const std::filesystem::path& directory, const std::string& wanted) {
    if (!std::filesystem::exists(directory / "run.csv")) return false;
    try {
        if (text_without_name(read_case((directory / "case.toml").string())) != wanted) return false;
        for (const RunValue& v : read_values((directory / "run.csv").string()))
            if (v.name == "results_version") return v.value == std::to_string(results_version);
    } catch (const Error&) {
    }
    return false;
}

}  // namespace

std::string find_run(const FindRequest& request) {
    const Case c = read_case(request.case_path, request.overrides);
    const std::string wanted = text_without_name(c);
    std::string found = "-";
    for (const std::string& directory : request.directories)
        if (found == "-" && holds_run(directory, wanted)) found = directory;
    const double travel = count_disc_steps(c, Stage::travel);
    return fmt::format("{:.6g} {:.6g} {}", count_disc_steps(c) - travel, travel, found);
}

}  // namespace ifedem

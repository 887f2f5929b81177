#include "app/find_run.hpp"

#include <fmt/format.h>

#include "app/run_set.hpp"
#include "step/stages.hpp"

namespace ifedem {

std::string find_run(const FindRequest& request) {
    const Case c = read_case(request.case_path, request.overrides);
    std::string found = "-";
    for (const std::string& directory : request.directories)
        if (found == "-" && holds_finished_run(directory, c)) found = directory;
    const double travel = count_disc_steps(c, Stage::travel);
    return fmt::format("{:.6g} {:.6g} {}", count_disc_steps(c) - travel, travel, found);
}

}  // namespace ifedem

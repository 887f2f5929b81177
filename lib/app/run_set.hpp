#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"

namespace ifedem {

/// A run that is wanted: what a child is told, and the case that both make of it.
struct WantedRun {
    std::string case_path;
    std::vector<Override> settings;
    std::string directory;
    Case c;
};

/// Throws Error(bad_input) if the settings give no case.
[[nodiscard]] WantedRun want_run(const std::string& case_path, std::vector<Override> settings, std::string directory);

/// " --set key=value" of each, for a command that is shown to be repeated; quoted where a shell would take it apart.
[[nodiscard]] std::string show_settings(const std::vector<Override>& settings);

/// A finished run by this results version, of this case whatever its name? What cannot be read is none.
[[nodiscard]] bool holds_finished_run(const std::string& directory, const Case& c);

struct RunSetOptions {
    std::string stage_cache = "build/stages";
    int jobs = 1;  ///< runs at the same time
};

/// Makes all runs by children of this program and returns their exit statuses. Stages that runs share are made first,
/// each once; what is complete is kept, what was interrupted goes on. After a signal (signal_of_children()) what was
/// not started has status −1.
[[nodiscard]] std::vector<int> make_runs(const std::vector<WantedRun>& runs, const RunSetOptions& options);

}  // namespace ifedem

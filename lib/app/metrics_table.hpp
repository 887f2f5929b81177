#pragma once
#include <string>
#include <vector>

namespace ifedem {

/// Writes one line a run with its window means (the chapter's window, scaled to the run's own travel): for comparing
/// variants.
void write_metrics(const std::vector<std::string>& run_directories, const std::string& out_path);

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

namespace ifedem {

struct ReportRequest {
    std::string
        claims_path;  ///< reproductions/chapterN/claims.csv; figures.csv, choices.csv and scripts stand beside it
    std::vector<std::string> run_dirs;  ///< run directories, and one with stiffness_summary.csv
    std::string out_dir;                ///< build/reports/chapterN
    std::string title;                  ///< "" for "Chapter N"
    std::string command;                ///< what made the report, for its last section; "" leaves the line out
};

/// Writes index.html (self-contained), report.md, checks.csv, runs.csv and figures/ into `out_dir`.
/// Throws Error(bad_input) for faulty claims or runs, Error(io) if a file or gnuplot fails.
void write_report(const ReportRequest& request);

}  // namespace ifedem

#pragma once
#include <string>
#include <vector>

namespace ifedem {

struct GuideRequest {
    std::vector<std::string> point_dirs;  ///< what `ifedem points` wrote, one a chapter
    std::string plain = "whole";
    std::string out_dir;
    std::string templates;  ///< directory of report.html and report.css
    std::string command;
};

/// One page over the charts of all chapters: how to read them, and what each second buys. Writes index.html, report.md
/// and points.csv, all chapters' points in one. Throws Error(bad_input) if a directory lacks its points.
void write_points_guide(const GuideRequest& request);

}  // namespace ifedem

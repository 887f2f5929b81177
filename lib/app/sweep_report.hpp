#pragma once
#include <string>
#include <vector>

#include "check/metrics.hpp"
#include "model/case.hpp"

namespace ifedem {

/// One run of a sweep.
struct SweepPoint {
    double load_N = 0;
    double slip_percent = 0;
    Case c;
    std::string name;    ///< its directory within the sweep's
    int status = 0;      ///< of the program; 0: complete
    RunMetrics metrics;  ///< NaN where there is none
    std::string note;    ///< why there is none
};

/// What a point is measured over: the last half of the travel.
[[nodiscard]] Window sweep_window(const Case& c);

/// Fills in metrics and notes, draws each run's contact sheet and animation, and writes sweep.csv, figures/ and
/// index.html. `command` is what made it, for the reader.
void write_sweep_report(const std::string& directory, std::vector<SweepPoint>& points, const std::string& command);

}  // namespace ifedem

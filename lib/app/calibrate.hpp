#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"
#include "soil_tests/sand_tests.hpp"

namespace ifedem {

enum class Knobs { leave, turn };  ///< turn: all tests again with each key changed that the quantities may answer to

struct CalibrateRequest {
    std::string case_path;
    std::string directory;
    std::vector<Override> overrides;
    int realisations = 3;
    int jobs = 1;            ///< tests at the same time
    double stress_kPa = 10;  ///< run_sand_test()
    Effort effort = Effort::full;
    Knobs knobs = Knobs::leave;
};

/// Measures a case's sand in the lab's tests and writes measurements.csv, realisations.csv, figures/, index.html and
/// report.md, and with Knobs::turn knobs.csv. Throws Error(bad_input), before anything is written, for a faulty case, a
/// sand without weight or a step beyond a certain limit.
void calibrate(const CalibrateRequest& request);

}  // namespace ifedem

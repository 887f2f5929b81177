#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "dem/bed.hpp"
#include "step/frozen_mode.hpp"
#include "step/stable_phase.hpp"
#include "support/failing_runs.hpp"

namespace ifedem::maps {

enum class Effort { full, quick };

/// The tables of one directory, and its measurements.csv.
struct Output {
    std::string directory;
    Effort effort = Effort::full;
    std::string measurements;
    /// One line of measurements.csv; `note` says what was done.
    void measured(const std::string& name, double value, const std::string& units, const std::string& note);
    void write(const std::string& file, const std::string& text) const;
};

void map_contacts(Output& out);  ///< step against ζ and coordination, three integrators; temperature of a bed
void map_elements(Output& out);  ///< part, mesh, ν; locking; inversion under load
void map_control(Output& out);   ///< planes of the PID, hub node and rim, wind-up
void map_rolling(Output& out);   ///< sign against limit
void map_coupling(Output& out);  ///< disc through a segment, in a corner, stiffness ratio
void map_scenes(Output& out);    ///< low gravity, slips, loads, bins
void map_cost(Output& out);      ///< of the checks

}  // namespace ifedem::maps

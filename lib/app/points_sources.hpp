#pragma once
#include <string>
#include <vector>

#include "check/points.hpp"

namespace ifedem {

// What the chart of cost against error takes from chapter 4: beyond lib/check, which knows runs only.

/// Peaks of normal and tangential contact stress of a run (kPa, radial decomposition), if it averaged contact forces.
[[nodiscard]] Values measure_stress_peaks(const Run& run);

/// The semi-empirical wheel on the soil of `ifedem soil`, at the cost of the plate tests that it rests on: its own
/// integrals take less than a millisecond.
[[nodiscard]] ModelWithoutRuns semi_empirical_wheel(const std::string& soil_directory,
                                                    const std::vector<std::string>& plate_directories);

}  // namespace ifedem

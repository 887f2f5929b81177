#pragma once
#include <string>

namespace ifedem {

/// Of the soil surface at the end of a travel, behind and ahead of the tyre.
struct SurfaceMeasure {
    double rough_behind_m = 0, rough_ahead_m = 0;      ///< standard deviation of the height about its line
    double highest_behind_m = 0, highest_ahead_m = 0;  ///< over the mean height ahead
};
[[nodiscard]] SurfaceMeasure measure_surface(const std::string& run_directory);

}  // namespace ifedem

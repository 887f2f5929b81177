#pragma once
#include <limits>
#include <string>

namespace ifedem {

/// Of the soil surface at the end of a travel, behind and ahead of the tyre; NaN where there is too little of it.
struct SurfaceMeasure {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    double rough_behind_m = unknown, rough_ahead_m = unknown;      ///< standard deviation of the height about its line
    double highest_behind_m = unknown, highest_ahead_m = unknown;  ///< over the mean height ahead
};
[[nodiscard]] SurfaceMeasure measure_surface(const std::string& run_directory);

}  // namespace ifedem

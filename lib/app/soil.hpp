#pragma once
#include <string>
#include <vector>

#include "model/case.hpp"
#include "traction/parametric_soil.hpp"

namespace ifedem {

struct SoilRequest {
    std::vector<std::string> run_directories;  ///< of plates (wheel.shape = "plate") under several loads
    std::string directory;
};

/// What plate tests say about the soil.
struct SoilParameters {
    PressureSinkage pressure;
    ShearStrength shear;
};

/// Fits the parameters of the semi-empirical wheel and writes measurements.csv, plate.csv
/// (pressure_kPa,sinkage_mm,fit_mm) and shear.csv (normal_kPa,displacement_mm,shear_kPa,fit_kPa).
void write_soil(const SoilRequest& request);

/// Back from a directory's measurements.csv.
[[nodiscard]] SoilParameters read_soil(const std::string& directory);

/// The semi-empirical wheel of a case; c1, c2 and θ_2 = 0 as Wong & Reece found for compact sand, so that nothing in it
/// knows the travels.
[[nodiscard]] ParametricWheel wong_reece_wheel(const Case& c, const SoilParameters& soil);

}  // namespace ifedem

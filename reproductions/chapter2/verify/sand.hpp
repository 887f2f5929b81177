#pragma once
#include <vector>

namespace ifedem::chapter2 {

/// Plane-strain constants of chapter 3's sand, from secant moduli of one small sample: confined compression to 3 %, and
/// biaxial compression at 10 kPa to half its peak.
struct ElasticConstants {
    double young_Pa = 0, poisson = 0;
};
[[nodiscard]] ElasticConstants elastic_constants(int seed);

/// b − a, seed by seed.
[[nodiscard]] std::vector<double> paired(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ifedem::chapter2

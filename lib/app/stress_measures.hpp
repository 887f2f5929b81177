#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/stress_run.hpp"

namespace ifedem {

// What chapter 4 says about a set of travels, as numbers.

/// A line of measurements.csv.
struct StressMeasure {
    std::string name;
    double value = 0;
    std::string units;
    double scatter = 0;
    std::size_t n = 1;
    std::string note;
    std::optional<double> uncertainty{};  ///< 95 % half-width where it is not the realisations' U
};
[[nodiscard]] std::vector<StressMeasure> measure_stress(const std::vector<SlipGroup>& groups);

}  // namespace ifedem

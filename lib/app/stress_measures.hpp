#pragma once
#include <vector>

#include "app/stress_run.hpp"
#include "check/measurements.hpp"

namespace ifedem {

// What chapter 4 says about a set of travels, as numbers.

[[nodiscard]] std::vector<Measurement> measure_stress(const std::vector<SlipGroup>& groups);

}  // namespace ifedem

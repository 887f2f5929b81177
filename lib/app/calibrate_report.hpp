#pragma once
#include <string>
#include <vector>

#include "app/calibrate.hpp"

namespace ifedem {

/// A sand, or that sand with one key changed, in all realisations.
struct SandVariant {
    std::string key;     ///< what was changed; "" for the sand itself
    std::string change;  ///< "× 0.5"
    Case c;
    std::vector<SandTests> tests;  ///< by realisation
};

/// A quantity's realisations, in its units.
[[nodiscard]] std::vector<double> read_values(const SandVariant& variant, const SandQuantity& quantity);

/// What each changed key does to each quantity, realisation by realisation: knobs.csv,
/// name,key,change,before,after,difference,half_width,units,n. The sand itself is the first of `variants`.
[[nodiscard]] std::string knob_table(const std::vector<SandVariant>& variants);

/// figures/, index.html and report.md. Without knobs of its own the report shows those of chapter 3's sand.
void write_calibration_report(const CalibrateRequest& request, const std::vector<SandVariant>& variants);

}  // namespace ifedem

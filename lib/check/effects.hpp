#pragma once
#include <string>
#include <vector>

#include "check/campaign.hpp"

namespace ifedem {

/// Compares variants with the default: for every variant, condition and metric (H, P_d, R, z) the mean difference over
/// realisations with its 95 % half-width. The half-width comes from the differences themselves where there are at least
/// three, else from the scatter of the default's runs.
/// A variant run's name is WHAT-…; its partner among the defaults has the same planet, load, slip, seed and lug phase.
/// A travel shorter than the text's is compared over the same share of its way, and so is its partner. Throws
/// Error(bad_input) if a variant has no partner.
[[nodiscard]] std::vector<Effect> measure_effects(const std::vector<std::string>& default_dirs,
                                                  const std::vector<std::string>& variant_dirs);

/// "contact.damping_ratio 0.2 → 0.1": keys that differ, but for those that make a realisation or a condition.
[[nodiscard]] std::string describe_changes(const Case& from, const Case& to);

/// Writes DIR/effects.csv, and DIR/measurements.csv with a line "WHAT:planet:sSLIP:metric" for each, so that claims can
/// name them.
void write_effects(const std::vector<std::string>& default_dirs, const std::vector<std::string>& variant_dirs,
                   const std::string& directory);

[[nodiscard]] std::vector<Effect> read_effects(const std::string& path);

/// row,label and effect and half-width of H, P_d, R and z, for the effects under one condition; nothing if there are
/// none.
[[nodiscard]] std::optional<std::string> effects_data(const std::vector<Effect>& effects, const std::string& gravity,
                                                      double slip_percent);

}  // namespace ifedem

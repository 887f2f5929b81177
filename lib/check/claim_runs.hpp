#pragma once
#include <optional>
#include <string>

#include "check/campaign.hpp"
#include "check/claims.hpp"
#include "check/trend.hpp"

namespace ifedem {

// What a claim selects from a campaign.

/// Something that cannot be computed, with the reason.
struct Missing {
    std::string reason;
};

/// "sinkage_cm" for "abs:sinkage_cm".
[[nodiscard]] std::string without_prefix(const std::string& metric);

/// The window mean that a claim is about; the claim must have one.
[[nodiscard]] const MetricInfo& metric_of(const Claim& claim);

/// "B3 + B6, Earth, 50 + 170 N, slip 0–70 %".
[[nodiscard]] std::string wanted_runs(const Claim& claim, std::size_t side);

/// The values of the claim's metric on one of its curves, absolute ones for abs:.
[[nodiscard]] ValuesBySlip collect_curve(const Campaign& campaign, const Claim& claim, const Curve& curve);

}  // namespace ifedem

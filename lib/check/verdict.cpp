#include "check/verdict.hpp"

#include <array>
#include <cmath>

namespace ifedem {
namespace {

constexpr std::array<std::string_view, verdict_count> names{"match", "unresolved", "differs-explained",
                                                            "not-reproduced", "not-computable"};

}  // namespace

std::string_view to_text(Verdict verdict) { return names[static_cast<std::size_t>(verdict)]; }

std::optional<Verdict> parse_verdict(std::string_view text) {
    for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k] == text) return static_cast<Verdict>(k);
    return std::nullopt;
}

bool is_worse(Verdict outcome, Verdict expected) { return outcome > expected; }

Finding compare_within_uncertainty(double error, double uncertainty, double uncertainty_limit) {
    // Written so that a NaN error is outside and an unknown (infinite) uncertainty never passes as known.
    if (!(std::abs(error) <= uncertainty)) return Finding::outside;
    return uncertainty <= uncertainty_limit ? Finding::within : Finding::too_uncertain;
}

Finding compare_within_tolerance(double error, double uncertainty, double tolerance) {
    if (!(std::abs(error) <= tolerance)) return Finding::outside;
    return uncertainty <= tolerance ? Finding::within : Finding::too_uncertain;
}

Finding compare_side(double margin, double uncertainty) {
    if (margin > uncertainty) return Finding::within;
    return margin >= -uncertainty ? Finding::too_uncertain : Finding::outside;
}

Finding compare_with_bound(double excess, double uncertainty) {
    if (excess <= 0) return Finding::within;
    return std::isfinite(uncertainty) && excess <= uncertainty ? Finding::too_uncertain : Finding::outside;
}

Verdict decide(Finding finding, Evidence evidence) {
    switch (finding) {
        case Finding::within:
            return Verdict::match;
        case Finding::too_uncertain:
            return Verdict::unresolved;
        case Finding::outside:
            break;
    }
    return evidence == Evidence::given ? Verdict::differs_explained : Verdict::not_reproduced;
}

}  // namespace ifedem

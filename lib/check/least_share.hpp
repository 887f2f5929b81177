#pragma once
#include <cmath>
#include <functional>

namespace ifedem {

enum class Trial {
    kept,
    refused,
    pointless,  ///< not made: it would save next to nothing
};

/// The least share of something that still does: halves it as long as that is kept, takes a quarter off after the first
/// refusal, and ends at the second or where a trial is pointless. Greedy: what was refused is not tried again, so a
/// quantity that comes back at a still smaller share stays unseen. 1 if nothing was kept.
[[nodiscard]] inline double find_least_share(const std::function<Trial(double share)>& try_share) {
    double share = 1;
    for (const double step : {0.5, 0.75}) {
        const auto next = [&] { return std::round(1000 * share * step) / 1000; };  // short in names and tables
        Trial trial = Trial::kept;
        while ((trial = try_share(next())) == Trial::kept) share = next();
        if (trial == Trial::pointless) break;
    }
    return share;
}

}  // namespace ifedem

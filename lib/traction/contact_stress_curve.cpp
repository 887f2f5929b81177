#include "traction/contact_stress_curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"

namespace ifedem {
namespace {

/// Index and height of the greatest value, refined by the parabola through it and its neighbours.
struct Peak {
    double place = 0;  ///< in points from the first
    double value = 0;
};
Peak find_peak(std::span<const double> y) {
    const auto k = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
    Peak peak{static_cast<double>(k), y[k]};
    if (k == 0 || k + 1 == y.size()) return peak;
    const double bend = y[k - 1] - 2 * y[k] + y[k + 1];
    if (!(bend < 0)) return peak;
    const double shift = 0.5 * (y[k - 1] - y[k + 1]) / bend;
    peak.place += shift;
    peak.value -= 0.25 * (y[k - 1] - y[k + 1]) * shift;
    return peak;
}

/// Where y, walked outwards from its peak, falls below the limit, between points. Stray contacts of thrown grains
/// further out do not count.
double find_fall(std::span<const double> y, double peak_place, std::ptrdiff_t step, double limit) {
    const auto n = static_cast<std::ptrdiff_t>(y.size());
    auto k = static_cast<std::ptrdiff_t>(std::lround(peak_place));
    while (k + step >= 0 && k + step < n && y[static_cast<std::size_t>(k + step)] >= limit) k += step;
    if (k + step < 0 || k + step >= n) return static_cast<double>(k);
    const double inside = y[static_cast<std::size_t>(k)], outside = y[static_cast<std::size_t>(k + step)];
    return static_cast<double>(k) + static_cast<double>(step) * (inside - limit) / (inside - outside);
}

double spacing_of(const StressCurve& c) { return c.angle_rad[1] - c.angle_rad[0]; }

/// Blocks added up as they are drawn.
StressState draw_blocks(std::span<const StressState> realisations, Random& random) {
    StressState sum;
    const std::size_t stride = realisations[0].segment.size() / realisations[0].block.size();
    sum.block.resize(1);
    sum.segment.resize(stride);
    const auto draw = [&](std::size_t count) { return static_cast<std::size_t>(random.below(count)); };
    for (std::size_t r = 0; r < realisations.size(); ++r) {
        const StressState& run = realisations[draw(realisations.size())];
        for (std::size_t b = 0; b < run.block.size(); ++b) {
            const std::size_t drawn = draw(run.block.size());
            sum.block[0].steps += run.block[drawn].steps;
            for (std::size_t k = 0; k < stride; ++k) add(sum.segment[k], run.segment[drawn * stride + k]);
        }
    }
    return sum;
}

}  // namespace

StressCurve make_stress_curve(std::span<const MeanSegment> segments, const ContactArc& arc,
                              Decomposition decomposition) {
    StressCurve curve;
    const double count = static_cast<double>(segments.size()) - 1;  // without the one for the upper half
    const double area = arc.width_m * arc.radius_m * pi / count;
    for (const MeanSegment& s : segments.first(segments.size() - 1)) {
        const bool radial = decomposition == Decomposition::radial;
        curve.angle_rad.push_back(s.angle_rad);
        curve.normal_Pa.push_back((radial ? s.mean.radial_N : s.mean.normal_N) / area);
        curve.tangential_Pa.push_back((radial ? s.mean.circumferential_N : s.mean.tangential_N) / area);
    }
    return curve;
}

std::vector<double> smooth(std::span<const double> values, double spacing_rad, double half_width_rad) {
    const auto n = static_cast<std::ptrdiff_t>(values.size());
    const auto reach = static_cast<std::ptrdiff_t>(half_width_rad / spacing_rad);
    std::vector<double> weight;
    for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
        const double x = static_cast<double>(d) * spacing_rad / half_width_rad;
        weight.push_back(1.0 - x * x);
    }
    std::vector<double> out(values.size());
    for (std::ptrdiff_t k = 0; k < n; ++k) {
        double sum = 0, total = 0;
        for (std::ptrdiff_t d = std::max(-reach, -k); d <= std::min(reach, n - 1 - k); ++d) {
            const double w = weight[static_cast<std::size_t>(d + reach)];
            sum += w * values[static_cast<std::size_t>(k + d)];
            total += w;
        }
        out[static_cast<std::size_t>(k)] = total > 0 ? sum / total : values[static_cast<std::size_t>(k)];
    }
    return out;
}

double CurveFeatures::relative_peak() const { return (0.5 * pi - greatest_normal_rad) / (0.5 * pi - entry_rad[1]); }

CurveFeatures find_features(const StressCurve& curve, double half_width_rad) {
    const double spacing = spacing_of(curve);
    const std::vector<double> normal = smooth(curve.normal_Pa, spacing, half_width_rad);
    const std::vector<double> tangential = smooth(curve.tangential_Pa, spacing, half_width_rad);
    const auto angle = [&](double place) { return curve.angle_rad[0] + place * spacing; };
    const Peak sigma = find_peak(normal), tau = find_peak(tangential);
    CurveFeatures f;
    f.greatest_normal_Pa = sigma.value, f.greatest_normal_rad = angle(sigma.place);
    f.greatest_tangential_Pa = tau.value, f.greatest_tangential_rad = angle(tau.place);
    f.least_tangential_Pa = *std::min_element(tangential.begin(), tangential.end());
    for (std::size_t s = 0; s < entry_shares.size(); ++s) {
        const double limit = entry_shares[s] * sigma.value;
        f.entry_rad[s] = angle(find_fall(normal, sigma.place, -1, limit));
        f.exit_rad[s] = angle(find_fall(normal, sigma.place, 1, limit));
    }
    return f;
}

StressField make_field(const StressCurve& curve) {
    return {make_spline(curve.angle_rad, curve.normal_Pa),
            make_spline(curve.angle_rad, curve.tangential_Pa),
            curve.angle_rad.front(),
            curve.angle_rad.back(),
            {}};
}

std::vector<CurveFeatures> bootstrap_features(std::span<const StressState> realisations, const ContactArc& arc,
                                              Decomposition decomposition, double half_width_rad,
                                              std::size_t replicates, Random& random) {
    std::vector<CurveFeatures> all;
    for (std::size_t n = 0; n < replicates; ++n)
        all.push_back(find_features(
            make_stress_curve(mean_segments(draw_blocks(realisations, random)), arc, decomposition), half_width_rad));
    return all;
}

}  // namespace ifedem

#include "dem/bed.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>

#include "core/bitmath.hpp"
#include "core/random.hpp"
#include "dem/edit_discs.hpp"

namespace ifedem {
namespace {

/// `count` radii in the given shares, exact to one disc, in random order.
std::vector<double> draw_radii(const SoilCase& soil, std::int64_t count, Random& random) {
    const double total = std::accumulate(soil.radii_shares.begin(), soil.radii_shares.end(), 0.0);
    std::vector<double> radii;
    double share = 0;
    for (std::size_t k = 0; k < soil.radii_m.size(); ++k) {
        share += soil.radii_shares[k];
        const auto upto = static_cast<std::size_t>(std::floor(static_cast<double>(count) * share / total + 0.5));
        radii.resize(std::max(upto, radii.size()), soil.radii_m[k]);
    }
    shuffle(radii, random);
    return radii;
}

}  // namespace

DiscState generate_bed(const Case& c) {
    Random random{static_cast<std::uint64_t>(c.bed.seed)};
    const std::vector<double> radii = draw_radii(c.soil, c.bed.disc_count, random);
    const double largest = *std::max_element(c.soil.radii_m.begin(), c.soil.radii_m.end());
    const double shift = 0.05 * largest, pitch = 2 * largest + 2 * shift;
    const double row_height = std::sqrt(0.75) * pitch;
    const auto a_row = std::max<std::size_t>(1, static_cast<std::size_t>(c.bed.length_m / pitch - 0.5));
    DiscState bed;
    for (std::size_t n = 0; n < radii.size(); ++n) {
        const std::size_t row = n / a_row, column = n % a_row;
        const double indent = row % 2 == 0 ? 0.5 : 1.0;
        Disc d;
        d.radius_m = radii[n];
        d.x_m = (static_cast<double>(column) + indent) * pitch + shift * (2 * random.uniform() - 1);
        d.y_m = 0.5 * pitch + static_cast<double>(row) * row_height + shift * (2 * random.uniform() - 1);
        d.inverse_mass_1_kg = 1.0 / (pi * d.radius_m * d.radius_m * c.soil.thickness_m * c.soil.density_kg_m3);
        bed.disc.push_back(d);
        bed.id.push_back(static_cast<std::uint32_t>(n));
    }
    if (c.integrator != Integrator::symplectic_euler) bed.acceleration.resize(bed.disc.size());
    return bed;
}

std::vector<std::uint32_t> sort_by_top(const DiscState& discs) {
    std::vector<std::uint32_t> order(discs.disc.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto top = [&](std::uint32_t p) { return discs.disc[p].y_m + discs.disc[p].radius_m; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto tops = std::strong_order(top(a), top(b));  // NaN too has its place in it
        return tops != 0 ? tops < 0 : discs.id[a] < discs.id[b];
    });
    return order;
}

void level_surface(State& state, std::size_t count) {
    if (count >= state.discs.disc.size()) return;
    const std::vector<std::uint32_t> order = sort_by_top(state.discs);
    std::vector<char> stays(order.size(), 0);
    for (std::size_t n = 0; n < count; ++n) stays[order[n]] = 1;
    keep_discs(stays, state);
}

double highest_top_m(const DiscState& discs) {
    double top = 0;
    for (const Disc& d : discs.disc) top = std::max(top, d.y_m + d.radius_m);
    return top;
}

double measure_porosity(const DiscState& discs, double length_m, double margin_m, double bottom_m, double top_m) {
    // A disc inside counts whole; one that the rectangle cuts, by horizontal slices.
    constexpr int slices = 400;
    const double left = margin_m, right = length_m - margin_m;
    double area = 0;
    for (const Disc& d : discs.disc) {
        const double r = d.radius_m;
        if (d.x_m - r >= left && d.x_m + r <= right && d.y_m - r >= bottom_m && d.y_m + r <= top_m) {
            area += pi * r * r;
            continue;
        }
        for (int s = 0; s < slices; ++s) {
            const double y = d.radius_m * ((s + 0.5) * 2.0 / slices - 1.0);
            if (d.y_m + y < bottom_m || d.y_m + y > top_m) continue;
            const double half = std::sqrt(d.radius_m * d.radius_m - y * y);
            const double width = std::min(right, d.x_m + half) - std::max(left, d.x_m - half);
            if (width > 0) area += width * 2 * d.radius_m / slices;
        }
    }
    return 1.0 - area / ((right - left) * (top_m - bottom_m));
}

double measure_surface_m(const DiscState& discs, double length_m, double largest_radius_m) {
    const auto columns = std::max<std::size_t>(1, static_cast<std::size_t>(length_m / (4 * largest_radius_m)));
    std::vector<double> top(columns, 0.0);
    for (const Disc& d : discs.disc) {
        const double at = d.x_m / length_m * static_cast<double>(columns);
        const auto c = static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(columns - 1)));
        top[c] = std::max(top[c], d.y_m + d.radius_m);
    }
    return std::accumulate(top.begin(), top.end(), 0.0) / static_cast<double>(columns);
}

double rms_speed_m_s(const DiscState& discs) {
    double sum = 0;
    for (const Disc& d : discs.disc) sum += d.vx_m_s * d.vx_m_s + d.vy_m_s * d.vy_m_s;
    return discs.disc.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(discs.disc.size()));
}

}  // namespace ifedem

#include "soil_tests/compression.hpp"

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"
#include "dem/bed.hpp"

namespace ifedem {
namespace {

enum Wall : std::size_t { bottom, left, right, top };

const FlatWall& wall(const SandCell& cell, Wall w) { return cell.sample.world().scene.dem.flat_walls[w]; }

}  // namespace

double SandCell::width_m() const { return wall(*this, right).point_m.x - wall(*this, left).point_m.x; }
double SandCell::height_m() const { return wall(*this, top).point_m.y - wall(*this, bottom).point_m.y; }
double SandCell::axial_Pa() const {
    const auto& f = sample.wall_force_N();
    return 0.5 * (f[bottom] + f[top]) / (width_m() * thickness_m);
}
double SandCell::lateral_Pa() const {
    const auto& f = sample.wall_force_N();
    return 0.5 * (f[left] + f[right]) / (height_m() * thickness_m);
}

SandCell make_cell(const Case& sand, std::int64_t discs) {
    Case c = soil_of(sand);
    c.gravity_m_s2 = 0;
    c.bed.disc_count = discs;
    c.bed.length_m = std::sqrt(static_cast<double>(discs)) * (2 * largest_radius_m(c)) * 1.05;
    const DiscState filled = generate_bed(c);
    DemConstants dem = make_dem_constants(c, c.contact.consolidation_friction_soil, 0);
    const double height = highest_top_m(filled);
    dem.flat_walls.push_back({{0, height}, {0, -1}});
    return {Sample(dem, filled.disc), c.soil.thickness_m, c.contact.friction_soil};
}

double servo_m(const DemConstants& dem, double thickness_m, double stress_Pa, double wanted_Pa) {
    constexpr double share = 0.2, fastest_m_s = 0.05;
    if (stress_Pa < 0.05 * wanted_Pa) return fastest_m_s * dem.step_s;
    const double spacing_m = dem.smallest_radius_m + dem.largest_radius_m;
    const double way = share * (wanted_Pa - stress_Pa) * thickness_m * spacing_m / dem.soil.normal_stiffness_N_m;
    return std::clamp(way, -fastest_m_s * dem.step_s, fastest_m_s * dem.step_s);
}

void consolidate(SandCell& cell, double stress_Pa, double duration_s) {
    const DemConstants& dem = cell.sample.world().scene.dem;
    cell.sample.step();
    const auto steps = std::llround(duration_s / dem.step_s);
    for (long long n = 0; n < steps; ++n) {
        const double up = servo_m(dem, cell.thickness_m, cell.axial_Pa(), stress_Pa);
        const double in = servo_m(dem, cell.thickness_m, cell.lateral_Pa(), stress_Pa);
        cell.sample.step({up, in, in, up});
    }
}

BiaxialCurve shear(SandCell& cell, double lateral_Pa, double largest_strain) {
    constexpr double rate_1_s = 0.1, strain_a_point = 5e-4;
    const DemConstants& dem = cell.sample.world().scene.dem;
    cell.sample.set_friction(cell.friction, 0);
    const double height = cell.height_m(), volume = height * cell.width_m();
    const auto steps = static_cast<int>(largest_strain / rate_1_s / dem.step_s);
    const auto interval = static_cast<int>(std::lround(strain_a_point / rate_1_s / dem.step_s));
    BiaxialCurve curve;
    curve.lateral_Pa = lateral_Pa;
    double axial = 0, lateral = 0;
    for (int n = 1; n <= steps; ++n) {
        const double down = 0.5 * rate_1_s * dem.step_s * height;
        const double in = servo_m(dem, cell.thickness_m, cell.lateral_Pa(), lateral_Pa);
        cell.sample.step({down, in, in, down});
        axial += cell.axial_Pa() / interval, lateral += cell.lateral_Pa() / interval;
        if (n % interval != 0) continue;
        curve.strain.push_back(1 - cell.height_m() / height - 0.5 * strain_a_point);  // where the means belong
        curve.ratio.push_back(axial / lateral);
        curve.volumetric.push_back(1 - cell.height_m() * cell.width_m() / volume);
        axial = lateral = 0;
    }
    return curve;
}

double friction_angle_deg(double stress_ratio) { return std::asin((stress_ratio - 1) / (stress_ratio + 1)) * 180 / pi; }

Strength read_strength(const BiaxialCurve& c) {
    constexpr std::size_t half = 5;
    std::size_t peak = half;
    double highest = 0;
    for (std::size_t k = half; k + half < c.ratio.size(); ++k) {
        double mean = 0;
        for (std::size_t j = k - half; j <= k + half; ++j) mean += c.ratio[j] / (2 * half + 1);
        if (mean > highest) highest = mean, peak = k;
    }
    Strength s;
    s.peak_deg = friction_angle_deg(highest);
    const std::size_t last = c.ratio.size() / 5;
    double end = 0;
    for (std::size_t k = c.ratio.size() - last; k < c.ratio.size(); ++k) end += c.ratio[k] / static_cast<double>(last);
    s.end_deg = friction_angle_deg(end);
    const std::size_t from = peak > 2 * half ? peak - 2 * half : 0, to = std::min(peak + 2 * half, c.strain.size() - 1);
    const double rate = (c.volumetric[to] - c.volumetric[from]) / (c.strain[to] - c.strain[from]);
    s.dilatancy_deg = std::asin(-rate / (2 - rate)) * 180 / pi;
    std::size_t k = 0;
    while (k + 1 < peak && c.ratio[k] - 1 < 0.5 * (highest - 1)) ++k;
    s.secant_Pa = (c.ratio[k] - 1) * c.lateral_Pa / c.strain[k];
    return s;
}

Compression compress(const Case& sand, const SampleSize& size, double start_Pa) {
    constexpr double largest_strain = 0.03, rate_1_s = 0.05, strain_a_point = 5e-4;
    Compression result;
    result.start_Pa = start_Pa;
    SandCell cell = make_cell(sand, size.discs);
    consolidate(cell, start_Pa, size.consolidation_s);
    const DemConstants& dem = cell.sample.world().scene.dem;
    result.lattice_Pa =
        std::sqrt(3.0) / 4 * (3 * dem.soil.normal_stiffness_N_m + dem.soil.tangential_stiffness_N_m) / cell.thickness_m;
    cell.sample.set_friction(cell.friction, 0);
    const double height = cell.height_m();
    const auto steps = static_cast<int>(largest_strain / rate_1_s / dem.step_s);
    const auto interval = static_cast<int>(std::lround(strain_a_point / rate_1_s / dem.step_s));
    double mean_Pa = 0;
    for (int n = 1; n <= steps; ++n) {
        const double down = 0.5 * rate_1_s * dem.step_s * height;
        cell.sample.step({down, 0, 0, down});
        mean_Pa += cell.axial_Pa() / interval;
        if (n % interval != 0) continue;
        result.strain.push_back(1 - cell.height_m() / height - 0.5 * strain_a_point);  // where the mean belongs
        result.stress_Pa.push_back(mean_Pa);
        mean_Pa = 0;
    }
    return result;
}

}  // namespace ifedem

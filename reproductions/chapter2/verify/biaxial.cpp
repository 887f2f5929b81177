// The sand as a material: biaxial compression and confined compression of a sample between smooth walls.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "check/statistics.hpp"
#include "dem/bed.hpp"
#include "sand.hpp"
#include "support/wheel_scenes.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;
enum Wall : std::size_t { bottom, left, right, top, wall_count };

/// A square of sand, walls without friction, no gravity. Prepared as the bed is: without friction.
struct Cell {
    Sample sample;
    double thickness_m = 0;
    double friction = 0;

    [[nodiscard]] double width_m() const { return wall(right).point_m.x - wall(left).point_m.x; }
    [[nodiscard]] double height_m() const { return wall(top).point_m.y - wall(bottom).point_m.y; }
    [[nodiscard]] double axial_Pa() const {
        const auto& f = sample.wall_force_N();
        return 0.5 * (f[bottom] + f[top]) / (width_m() * thickness_m);
    }
    [[nodiscard]] double lateral_Pa() const {
        const auto& f = sample.wall_force_N();
        return 0.5 * (f[left] + f[right]) / (height_m() * thickness_m);
    }

private:
    [[nodiscard]] const FlatWall& wall(Wall w) const { return sample.world().scene.dem.flat_walls[w]; }
};

struct SampleSize {
    std::int64_t discs = 0;
    int steps = 0;  ///< of isotropic consolidation
};
SampleSize size_of(Effort effort) { return effort == Effort::full ? SampleSize{2000, 25000} : SampleSize{800, 15000}; }

Cell make_cell(int seed, std::int64_t count) {
    Case c;
    c.gravity_m_s2 = 0;
    c.bed.disc_count = count, c.bed.seed = seed;
    c.bed.length_m = std::sqrt(static_cast<double>(count)) * 0.006 * 1.05;
    const State filled = make_initial_state(c);
    DemConstants dem = make_dem_constants(c, 0, 0);
    double height = 0;
    for (const Disc& d : filled.discs.disc) height = std::max(height, d.y_m + d.radius_m);
    dem.flat_walls.push_back({{0, height}, {0, -1}});
    return {Sample(dem, filled.discs.disc), c.soil.thickness_m, c.contact.friction_soil};
}

/// How far a wall goes towards the sample in this step so that its stress becomes `wanted`: a fifth of the way that
/// the springs of its contacts ask for; at 0.05 m/s where hardly anything touches it.
double servo(double stress_Pa, double wanted_Pa, double thickness_m, double step_s) {
    constexpr double stiffness_N_m = 1e5, spacing_m = 0.005, share = 0.2, fastest_m_s = 0.05;
    if (stress_Pa < 0.05 * wanted_Pa) return fastest_m_s * step_s;
    const double way = share * (wanted_Pa - stress_Pa) * thickness_m * spacing_m / stiffness_N_m;
    return std::clamp(way, -fastest_m_s * step_s, fastest_m_s * step_s);
}

/// Isotropic stress by all four walls, without friction.
void consolidate(Cell& cell, double stress_Pa, int steps) {
    const double dt = cell.sample.world().scene.dem.step_s;
    cell.sample.step();
    for (int n = 0; n < steps; ++n) {
        const double up = servo(cell.axial_Pa(), stress_Pa, cell.thickness_m, dt);
        const double in = servo(cell.lateral_Pa(), stress_Pa, cell.thickness_m, dt);
        cell.sample.step({up, in, in, up});
    }
}

/// A biaxial test: bottom and top approach at a constant rate, the sides keep their stress.
struct Curve {
    std::vector<double> strain, ratio, volumetric;  ///< axial strain; σ1/σ3; volume lost over the first
    double lateral_Pa = 0;
};

constexpr double lateral_Pa = 1e4;  ///< about the wheel's mean pressure: 170 N on 0.1 m × 0.17 m

Curve shear(Cell& cell, double rolling, double largest_strain) {
    constexpr double rate_1_s = 0.1;
    const double dt = cell.sample.world().scene.dem.step_s;
    cell.sample.set_friction(cell.friction, 0);
    cell.sample.set_rolling(rolling);
    const double height = cell.height_m(), volume = height * cell.width_m();
    const auto steps = static_cast<int>(largest_strain / rate_1_s / dt);
    constexpr int interval = 125;  // 0.05 % of strain: each point is a mean over it
    Curve curve;
    curve.lateral_Pa = lateral_Pa;
    double axial = 0, lateral = 0;
    for (int n = 1; n <= steps; ++n) {
        const double down = 0.5 * rate_1_s * dt * height;
        const double in = servo(cell.lateral_Pa(), lateral_Pa, cell.thickness_m, dt);
        cell.sample.step({down, in, in, down});
        axial += cell.axial_Pa() / interval, lateral += cell.lateral_Pa() / interval;
        if (n % interval != 0) continue;
        curve.strain.push_back(1 - cell.height_m() / height);
        curve.ratio.push_back(axial / lateral);
        curve.volumetric.push_back(1 - cell.height_m() * cell.width_m() / volume);
        axial = lateral = 0;
    }
    return curve;
}

struct Strength {
    double peak_deg = 0, end_deg = 0, dilatancy_deg = 0, secant_Pa = 0;
};

double friction_angle_deg(double ratio) { return std::asin((ratio - 1) / (ratio + 1)) * 180 / pi; }

/// Angles from running means over 0.5 % of strain; the modulus E50 from the first crossing of half the peak deviator.
Strength read_strength(const Curve& c) {
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

void measure_biaxial(Output& out, Effort effort) {
    const bool full = effort == Effort::full;
    const std::vector<double> levels = full ? std::vector{0.0, 0.5, 1.0, 2.0} : std::vector{0.0, 1.0};
    const int seeds = full ? 5 : 2;
    std::vector<std::vector<std::string>> curves, rows;
    std::vector<std::vector<double>> peaks;
    for (const double level : levels) {
        std::vector<double> peak, end, dilatancy, secant;
        std::vector<Curve> all;
        for (int seed = 1; seed <= seeds; ++seed) {
            Cell cell = make_cell(seed, size_of(effort).discs);
            consolidate(cell, lateral_Pa, size_of(effort).steps);
            all.push_back(shear(cell, level, full ? 0.15 : 0.05));
            const Strength s = read_strength(all.back());
            peak.push_back(s.peak_deg), end.push_back(s.end_deg);
            dilatancy.push_back(s.dilatancy_deg), secant.push_back(1e-6 * s.secant_Pa);
        }
        const std::string at = fmt::format("_alpha_{:g}", level);
        out.add("sand_friction_peak" + at, peak, "deg", "biaxial, 10 kPa, µ 0.6, full chord × α");
        out.add("sand_friction_end" + at, end, "deg", "mean of the last fifth of the strain");
        out.add("sand_dilatancy" + at, dilatancy, "deg", "at the peak");
        out.add("sand_secant_modulus" + at, secant, "MPa", "deviator over axial strain at half the peak");
        peaks.push_back(peak);
        for (std::size_t k = 0; k < all[0].strain.size(); k += 2) {
            double ratio = 0, volumetric = 0;
            for (const Curve& c : all) ratio += c.ratio[k] / seeds, volumetric += c.volumetric[k] / seeds;
            curves.push_back({number(level), number(100 * all[0].strain[k]), number(ratio), number(100 * volumetric)});
        }
        rows.push_back({number(level), number(mean(peak)), number(standard_deviation(peak)), number(mean(end)),
                        number(standard_deviation(end)), number(mean(dilatancy)), number(standard_deviation(dilatancy)),
                        number(mean(secant)), number(standard_deviation(secant))});
    }
    out.write_table("biaxial_curves.csv", "alpha,strain_percent,stress_ratio,volumetric_percent", curves);
    out.write_table("biaxial.csv", "alpha,peak_deg,peak_s,end_deg,end_s,dilatancy_deg,dilatancy_s,secant_MPa,secant_s",
                    rows);
    out.add_difference("sand_friction_rise", paired(peaks.front(), peaks[levels.size() == 4 ? 2 : 1]), "deg",
                       "peak friction angle at α = 1 less that at α = 0, seed by seed");
}

struct Compression {
    std::vector<double> strain, stress_Pa;
    double lattice_Pa = 0;  ///< (√3/4)(3 K_n + K_s)/t: the triangular lattice of the same springs
    double start_Pa = 0;
    [[nodiscard]] double secant_Pa() const { return (stress_Pa.back() - start_Pa) / strain.back(); }
};

/// Confined compression to 3 %: the sides stand, bottom and top approach.
Compression compress(int seed, const SampleSize& size) {
    constexpr double largest_strain = 0.03, rate_1_s = 0.05;
    Compression result;
    result.start_Pa = 500;
    Cell cell = make_cell(seed, size.discs);
    consolidate(cell, result.start_Pa, size.steps);
    const DemConstants& dem = cell.sample.world().scene.dem;
    result.lattice_Pa =
        std::sqrt(3.0) / 4 * (3 * dem.soil.normal_stiffness_N_m + dem.soil.tangential_stiffness_N_m) / cell.thickness_m;
    cell.sample.set_friction(cell.friction, 0);
    const double height = cell.height_m();
    const auto steps = static_cast<int>(largest_strain / rate_1_s / dem.step_s);
    constexpr int interval = 250;
    double mean_Pa = 0;
    for (int n = 1; n <= steps; ++n) {
        const double down = 0.5 * rate_1_s * dem.step_s * height;
        cell.sample.step({down, 0, 0, down});
        mean_Pa += cell.axial_Pa() / interval;
        if (n % interval != 0) continue;
        result.strain.push_back(1 - cell.height_m() / height);
        result.stress_Pa.push_back(mean_Pa);
        mean_Pa = 0;
    }
    return result;
}

/// Secant modulus at 3 %, as chapter 5 reads it.
void measure_confined_sand(Output& out, Effort effort) {
    std::vector<double> modulus, share;
    std::vector<std::vector<std::string>> rows;
    for (int seed = 1; seed <= (effort == Effort::full ? 5 : 2); ++seed) {
        const Compression c = compress(seed, size_of(effort));
        modulus.push_back(1e-6 * c.secant_Pa());
        share.push_back(c.secant_Pa() / c.lattice_Pa);
        for (std::size_t k = 0; k < c.strain.size(); ++k)
            rows.push_back({std::to_string(seed), number(100 * c.strain[k]), number(1e-3 * c.stress_Pa[k])});
    }
    out.write_table("confined.csv", "seed,strain_percent,stress_kPa", rows);
    out.add("sand_confined_modulus", modulus, "MPa", "secant at 3 %, from 0.5 kPa; chapter 3's springs");
    out.add("sand_confined_share", share, "-", "of the triangular lattice's");
}

}  // namespace

ElasticConstants elastic_constants(int seed) {
    const SampleSize size = size_of(Effort::quick);
    const double confined_Pa = compress(seed, size).secant_Pa();
    Cell cell = make_cell(seed, size.discs);
    consolidate(cell, lateral_Pa, size.steps);
    const double biaxial_Pa = read_strength(shear(cell, 1, 0.05)).secant_Pa;
    // Confined: E (1 − ν)/((1 + ν)(1 − 2ν)). Biaxial in plane strain: E/(1 − ν²). Their ratio gives ν.
    const double ratio = biaxial_Pa / confined_Pa;
    const double poisson = ratio < 1 ? (std::sqrt(1 - ratio) - (1 - ratio)) / ratio : 0.0;
    return {biaxial_Pa * (1 - poisson * poisson), poisson};
}

void measure_sand(Output& out, Effort effort) {
    measure_confined_sand(out, effort);
    measure_biaxial(out, effort);
}

}  // namespace ifedem::chapter2

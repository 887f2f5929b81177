// The sand as a material: biaxial compression and confined compression of a sample between smooth walls.
#include "sand.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check/statistics.hpp"
#include "soil_tests/compression.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

SampleSize size_of(Effort effort) { return effort == Effort::full ? SampleSize{2000, 1.0} : SampleSize{800, 0.6}; }

constexpr double lateral_Pa = 1e4;  ///< about the wheel's mean pressure: 170 N on 0.1 m × 0.17 m

Case sand_of(int seed) {
    Case c;
    c.bed.seed = seed;
    return c;
}

/// Consolidated with rolling resistance as the case has it, sheared with α = `rolling`.
BiaxialCurve compress_biaxial(int seed, const SampleSize& size, double rolling, double largest_strain) {
    SandCell cell = make_cell(sand_of(seed), size.discs);
    consolidate(cell, lateral_Pa, size.consolidation_s);
    cell.sample.set_rolling(rolling);
    return shear(cell, lateral_Pa, largest_strain);
}

void measure_biaxial(Output& out, Effort effort) {
    const bool full = effort == Effort::full;
    const std::vector<double> levels = full ? std::vector{0.0, 0.5, 1.0, 2.0} : std::vector{0.0, 1.0};
    const int seeds = full ? 5 : 2;
    std::vector<std::vector<std::string>> curves, rows;
    std::vector<std::vector<double>> peaks;
    for (const double level : levels) {
        std::vector<double> peak, end, dilatancy, secant;
        std::vector<BiaxialCurve> all;
        for (int seed = 1; seed <= seeds; ++seed) {
            all.push_back(compress_biaxial(seed, size_of(effort), level, full ? 0.15 : 0.05));
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
            for (const BiaxialCurve& c : all) ratio += c.ratio[k] / seeds, volumetric += c.volumetric[k] / seeds;
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

/// Secant modulus at 3 %, as chapter 5 reads it.
void measure_confined_sand(Output& out, Effort effort) {
    std::vector<double> modulus, share;
    std::vector<std::vector<std::string>> rows;
    for (int seed = 1; seed <= (effort == Effort::full ? 5 : 2); ++seed) {
        const Compression c = compress(sand_of(seed), size_of(effort), 500);
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
    const double confined_Pa = compress(sand_of(seed), size, 500).secant_Pa();
    const double biaxial_Pa = read_strength(compress_biaxial(seed, size, 1, 0.05)).secant_Pa;
    // Confined: E (1 − ν)/((1 + ν)(1 − 2ν)). Biaxial in plane strain: E/(1 − ν²). Their ratio gives ν.
    const double ratio = biaxial_Pa / confined_Pa;
    const double poisson = ratio < 1 ? (std::sqrt(1 - ratio) - (1 - ratio)) / ratio : 0.0;
    return {biaxial_Pa * (1 - poisson * poisson), poisson};
}

std::vector<double> paired(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> difference;
    for (std::size_t k = 0; k < a.size(); ++k) difference.push_back(b[k] - a[k]);
    return difference;
}

void measure_sand(Output& out, Effort effort) {
    measure_confined_sand(out, effort);
    measure_biaxial(out, effort);
}

}  // namespace ifedem::chapter2

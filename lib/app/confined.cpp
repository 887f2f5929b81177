#include "app/confined.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "check/measurements.hpp"
#include "core/error.hpp"
#include "model/case.hpp"
#include "record/files.hpp"
#include "step/confined_compression.hpp"
#include "step/soil_pattern.hpp"

namespace ifedem {
namespace {

constexpr double largest_strain = 0.03, speed_m_s = 0.01;
constexpr int points = 30;

/// One way of preparing the discs.
struct Variant {
    const char* name;
    double mass_factor = 0;
    ConfinedCompression result;
    PatternReport pattern;
};

std::string curves(const std::vector<Variant>& variants) {
    std::string text = "preparation,strain,discs_Pa,discs_mean_Pa,element_Pa\n";
    for (const Variant& v : variants)
        for (const ConfinedPoint& p : v.result.point)
            fmt::format_to(std::back_inserter(text), "{},{:.6g},{:.6g},{:.6g},{:.6g}\n", v.name, p.strain, p.discs_Pa,
                           p.discs_mean_Pa, p.element_Pa);
    return text;
}

std::string stresses(const std::vector<Variant>& variants) {
    std::string text = "preparation,x_m,y_m,radius_m,stress_y_Pa\n";
    for (const Variant& v : variants)
        for (std::size_t p = 0; p < v.result.disc.size(); ++p)
            fmt::format_to(std::back_inserter(text), "{},{:.6f},{:.6f},{:.6f},{:.6g}\n", v.name, v.result.disc[p].x_m,
                           v.result.disc[p].y_m, v.result.disc[p].radius_m, v.result.stress[p].y_Pa);
    return text;
}

std::string measurements(const std::vector<Variant>& variants) {
    std::vector<Measurement> found;
    for (const Variant& v : variants) {
        const ConfinedPoint& end = v.result.point.back();
        const auto row = [&](const char* what, double value, const char* unit, const char* note) {
            found.push_back({fmt::format("{}_{}", what, v.name), value, unit, 0, 1, note});
        };
        row("confined_young", 1e-6 * v.result.young_Pa, "MPa", "Eq 5.9; gradient of the mean stress (Eq 5.10)");
        row("confined_young_of_lid", 1e-6 * v.result.young_of_lid_Pa, "MPa", "Eq 5.9; gradient of the lid's stress");
        row("confined_discs", 1e-3 * end.discs_Pa, "kPa", "the lid on the discs at 3 %");
        row("confined_discs_mean", 1e-3 * end.discs_mean_Pa, "kPa", "Eq 5.10 over the block at 3 %");
        row("confined_element", 1e-3 * end.element_Pa, "kPa", "one element with Table 5-2 at 3 %");
        row("pattern_fraction", v.pattern.solid_fraction, "-", "solid fraction of the block");
        row("pattern_density", v.pattern.bulk_density_kg_m3, "kg/m3", "bulk density of the block");
        row("pattern_overlap", 1e6 * v.pattern.mean_overlap_m, "um", "mean overlap of the prepared discs");
    }
    return measurements_csv(found);
}

}  // namespace

void write_confined(const ConfinedRequest& request) {
    const Case c = read_case(request.case_path);
    if (c.elements.columns == 0)
        fail_input(
            fmt::format("{}: there are no soil elements (elements.columns is 0, so there is no block to press). "
                        "Give the case some?",
                        request.case_path));
    std::vector<Variant> variants{{"text", c.elements.pattern_mass_factor, {}, {}}, {"full", 1.0, {}, {}}};
    for (Variant& v : variants) {
        Case as_prepared = c;
        as_prepared.elements.pattern_mass_factor = v.mass_factor;
        const std::vector<Disc> pattern = prepare_pattern(as_prepared);
        v.pattern = report_pattern(c, pattern);
        v.result = compress_confined(c, pattern, largest_strain, points, speed_m_s);
        const ConfinedPoint& end = v.result.point.back();
        fmt::print(
            "{}: {} discs, fraction {:.4f}; E = {:.3f} MPa (lid: {:.3f}); at 3 %: discs {:.1f} kPa (Eq 5.10: {:.1f}), "
            "element {:.2f} kPa\n",
            v.name, pattern.size(), v.pattern.solid_fraction, 1e-6 * v.result.young_Pa, 1e-6 * v.result.young_of_lid_Pa,
            1e-3 * end.discs_Pa, 1e-3 * end.discs_mean_Pa, 1e-3 * end.element_Pa);
    }
    std::filesystem::create_directories(request.directory);
    write_file_atomically(request.directory + "/confined.csv", curves(variants));
    write_file_atomically(request.directory + "/stress.csv", stresses(variants));
    write_file_atomically(request.directory + "/measurements.csv", measurements(variants));
}

}  // namespace ifedem

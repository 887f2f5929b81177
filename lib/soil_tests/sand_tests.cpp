#include "soil_tests/sand_tests.hpp"

#include <cmath>
#include <limits>

#include "core/bitmath.hpp"
#include "soil_tests/world.hpp"

namespace ifedem {
namespace {

struct Sizes {
    std::int64_t porosity_discs, repose_discs, plate_discs;
    double porosity_length_m;
    SampleSize cell, box;
    double biaxial_strain, box_way;
};
constexpr Sizes full_sizes{4000, 800, 3000, 0.5, {2000, 1.0}, {2000, 0.3}, 0.15, 0.08};
constexpr Sizes quick_sizes{700, 300, 600, 0.12, {400, 0.6}, {400, 0.1}, 0.15, 0.06};

double plate_pressure_Pa(const SandTests& t) {
    const PressureSinkage p = read_pressure_sinkage(t.plate);
    return p.modulus_Pa_mn * std::pow(0.01, p.exponent);
}

const std::array<SandQuantity, 12> quantities{{
    {"porosity", "Porosity", "bed", "-", 1, &TargetCase::porosity, [](const SandTests& t) { return t.porosity; }},
    {"repose_angle", "Angle of repose", "heap", "deg", 1, &TargetCase::repose_angle_deg,
     [](const SandTests& t) { return t.repose.angle_deg; }},
    {"confined_modulus", "Confined modulus", "confined compression", "MPa", 1e-6, &TargetCase::confined_modulus_Pa,
     [](const SandTests& t) { return t.confined.secant_Pa(); }},
    {"friction_angle", "Friction angle, peak", "biaxial compression", "deg", 1, &TargetCase::friction_angle_deg,
     [](const SandTests& t) { return read_strength(t.biaxial).peak_deg; }},
    {"residual_angle", "Friction angle, end", "biaxial compression", "deg", 1, &TargetCase::residual_angle_deg,
     [](const SandTests& t) { return read_strength(t.biaxial).end_deg; }},
    {"dilatancy_angle", "Dilatancy, peak", "biaxial compression", "deg", 1, &TargetCase::dilatancy_angle_deg,
     [](const SandTests& t) { return read_strength(t.biaxial).dilatancy_deg; }},
    {"secant_modulus", "Secant modulus E_50", "biaxial compression", "MPa", 1e-6, &TargetCase::secant_modulus_Pa,
     [](const SandTests& t) { return read_strength(t.biaxial).secant_Pa; }},
    {"shear_cohesion", "Cohesion c", "direct shear", "kPa", 1e-3, &TargetCase::shear_cohesion_Pa,
     [](const SandTests& t) { return read_shear_strength(t).cohesion_Pa; }},
    {"shear_angle", "Friction angle φ", "direct shear", "deg", 1, &TargetCase::shear_angle_deg,
     [](const SandTests& t) { return std::atan(read_shear_strength(t).friction) * 180 / pi; }},
    {"shear_displacement", "Shear displacement K", "direct shear", "mm", 1e3, &TargetCase::shear_displacement_m,
     [](const SandTests& t) { return read_shear_strength(t).displacement_m; }},
    {"plate_pressure", "k: pressure at 1 cm", "plate sinkage", "kPa", 1e-3, &TargetCase::plate_pressure_Pa,
     plate_pressure_Pa},
    {"plate_exponent", "Exponent n", "plate sinkage", "-", 1, &TargetCase::plate_exponent,
     [](const SandTests& t) { return read_pressure_sinkage(t.plate).exponent; }},
}};

}  // namespace

void run_sand_test(SandTest test, const Case& sand, Effort effort, double stress_Pa, SandTests& result) {
    const double size = largest_radius_m(sand) / 0.003;
    const Sizes& s = effort == Effort::full ? full_sizes : quick_sizes;
    const SampleSize cell_size{s.cell.discs, size * s.cell.consolidation_s};
    const auto shear_box = [&](double stress) {
        return shear_directly(sand, {s.box.discs, size * s.box.consolidation_s}, stress, s.box_way);
    };
    switch (test) {
        case SandTest::porosity:
            result.porosity = measure_bulk_porosity(sand, s.porosity_discs, size * s.porosity_length_m);
            break;
        case SandTest::repose:
            result.repose = spill(sand, scale_repose(sand, s.repose_discs));
            break;
        case SandTest::confined:
            result.confined = compress(sand, cell_size, 0.05 * stress_Pa);
            break;
        case SandTest::biaxial: {
            SandCell cell = make_cell(sand, cell_size.discs);
            consolidate(cell, stress_Pa, cell_size.consolidation_s);
            result.biaxial = shear(cell, stress_Pa, s.biaxial_strain);
            break;
        }
        case SandTest::box_low:
            result.box[0] = shear_box(0.5 * stress_Pa);
            break;
        case SandTest::box_middle:
            result.box[1] = shear_box(stress_Pa);
            break;
        case SandTest::box_high:
            result.box[2] = shear_box(2 * stress_Pa);
            break;
        case SandTest::plate:
            result.plate = press_plate(sand, s.plate_discs);
            break;
    }
}

std::span<const SandQuantity> sand_quantities() { return quantities; }

ShearStrength read_shear_strength(const SandTests& tests) { return fit_shear_strength(tests.box); }

PressureSinkage read_pressure_sinkage(const PlatePress& plate) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> z, p;
    for (std::size_t k = plate.sinkage_m.size() / 10; k < plate.sinkage_m.size(); ++k)
        if (plate.pressure_Pa[k] > 0) z.push_back(plate.sinkage_m[k]), p.push_back(plate.pressure_Pa[k]);
    return z.size() < 2 ? PressureSinkage{nothing, nothing} : fit_pressure_sinkage(z, p);
}

}  // namespace ifedem

#include "app/soil.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check/csv.hpp"
#include "check/measurements.hpp"
#include "check/run.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr const char* modulus_name = "soil_pressure_modulus";
constexpr const char* exponent_name = "soil_pressure_exponent";
constexpr const char* cohesion_name = "soil_cohesion";
constexpr const char* friction_name = "soil_friction";
constexpr const char* displacement_name = "soil_shear_displacement";

struct PlateTest {
    double pressure_Pa = 0, sinkage_m = 0;
    ShearTest shear;
};

PlateTest read_plate(const std::string& directory) {
    const Run run = read_run(directory);
    if (run.c.wheel.shape != WheelShape::plate)
        fail_input(fmt::format("{} is no plate test (wheel.shape is not \"plate\"). Leave it out?", directory));
    const auto sinkage = parse_number(run.text("sinkage_sinkage_m"));
    if (!sinkage) fail_input(fmt::format("{}/run.csv tells no sinkage_sinkage_m. Run the case again?", directory));
    const double area = run.c.wheel.plate_length_m * run.c.wheel.width_m;
    PlateTest t{run.c.wheel.load_N / area, -*sinkage, {}};
    t.shear.normal_Pa = t.pressure_Pa;
    const auto& x = run.travel.at("wheel_x_m");
    const auto& pull = run.travel.at("drawbar_pull_N");
    for (std::size_t k = 0; k < x.size(); ++k) {
        t.shear.displacement_m.push_back(x[k] - x[0]);
        t.shear.shear_Pa.push_back(pull[k] / area);
    }
    return t;
}

std::string plate_table(const std::vector<PlateTest>& tests, const PressureSinkage& p) {
    std::string text = "pressure_kPa,sinkage_mm,fit_mm\n";
    for (const PlateTest& t : tests)
        text += fmt::format("{:.5g},{:.5g},{:.5g}\n", 1e-3 * t.pressure_Pa, 1e3 * t.sinkage_m,
                            1e3 * std::pow(t.pressure_Pa / p.modulus_Pa_mn, 1 / p.exponent));
    return text;
}

std::string shear_table(const std::vector<PlateTest>& tests, const ShearStrength& s) {
    std::string text = "normal_kPa,displacement_mm,shear_kPa,fit_kPa\n";
    for (const PlateTest& t : tests) {
        if (&t != &tests.front()) text += "\n\n";  // gnuplot: an index a plate
        for (std::size_t k = 0; k < t.shear.shear_Pa.size(); ++k) {
            const double j = t.shear.displacement_m[k];
            text += fmt::format("{:.5g},{:.5g},{:.5g},{:.5g}\n", 1e-3 * t.shear.normal_Pa, 1e3 * j,
                                1e-3 * t.shear.shear_Pa[k], 1e-3 * shear_stress_Pa(s, t.shear.normal_Pa, j));
        }
    }
    return text;
}

}  // namespace

void write_soil(const SoilRequest& request) {
    std::vector<PlateTest> tests;
    for (const std::string& directory : request.run_directories) tests.push_back(read_plate(directory));
    std::vector<double> z, p;
    std::vector<ShearTest> shear;
    for (const PlateTest& t : tests) z.push_back(t.sinkage_m), p.push_back(t.pressure_Pa), shear.push_back(t.shear);
    const PressureSinkage pressure = fit_pressure_sinkage(z, p);
    const ShearStrength strength = fit_shear_strength(shear);
    const std::size_t n = tests.size();
    const Measurement found[] = {{modulus_name, pressure.modulus_Pa_mn, "Pa/m^n", 0, n,
                                  "k of p = k z^n, plates pressed in slowly; n counts the loads"},
                                 {exponent_name, pressure.exponent, "-", 0, n, "n of p = k z^n"},
                                 {cohesion_name, strength.cohesion_Pa, "Pa", 0, n, "c, plates dragged"},
                                 {friction_name, strength.friction, "-", 0, n, "tan φ"},
                                 {displacement_name, strength.displacement_m, "m", 0, n, "K of Janosi & Hanamoto"}};
    write_text(request.directory + "/measurements.csv", measurements_csv(found));
    write_text(request.directory + "/plate.csv", plate_table(tests, pressure));
    write_text(request.directory + "/shear.csv", shear_table(tests, strength));
    fmt::print("p = {:.4g} kPa (z/cm)^{:.3f}, c = {:.3g} kPa, tan φ = {:.3f}, K = {:.2f} mm\n",
               1e-3 * pressure.modulus_Pa_mn * std::pow(0.01, pressure.exponent), pressure.exponent,
               1e-3 * strength.cohesion_Pa, strength.friction, 1e3 * strength.displacement_m);
}

SoilParameters read_soil(const std::string& directory) {
    const std::string path = directory + "/measurements.csv";
    const std::vector<Measurement> measured = read_measurements(path);
    const auto find = [&](const char* name) {
        for (const Measurement& m : measured)
            if (m.name == name) return m.value;
        fail_input(fmt::format("{} holds no {}. Make it with `ifedem soil`?", path, name));
    };
    return {{find(modulus_name), find(exponent_name)},
            {find(cohesion_name), find(friction_name), find(displacement_name)}};
}

ParametricWheel wong_reece_wheel(const Case& c, const SoilParameters& soil) {
    ParametricWheel wheel;
    wheel.arc = {c.wheel.width_m, c.wheel.tread_radius_m};
    wheel.pressure = soil.pressure, wheel.shear = soil.shear;
    wheel.c1 = 0.43, wheel.c2 = 0.32;
    return wheel;
}

}  // namespace ifedem

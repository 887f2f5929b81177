#pragma once
#include <array>
#include <span>
#include <string>

#include "soil_tests/compression.hpp"
#include "soil_tests/plate_press.hpp"
#include "soil_tests/repose.hpp"
#include "soil_tests/shear_box.hpp"

namespace ifedem {

// All tests on one sand, and what they say of it in numbers.

enum class Effort { quick, full };  ///< quick: a few hundred discs, shorter ways

/// One realisation of all tests; the seed is the case's.
struct SandTests {
    double porosity = 0;
    Repose repose;
    Compression confined;
    BiaxialCurve biaxial;
    std::array<ShearTest, 3> box;  ///< under half, all and twice the stress
    PlatePress plate;
};

enum class SandTest { porosity, repose, confined, biaxial, box_low, box_middle, box_high, plate };
inline constexpr std::array every_sand_test{SandTest::box_low,  SandTest::box_middle, SandTest::box_high,
                                            SandTest::plate,    SandTest::biaxial,    SandTest::porosity,
                                            SandTest::confined, SandTest::repose};  ///< the longest first

/// Does one test and fills in its member alone, so that tests of one realisation may run side by side. `stress_Pa` is
/// the lateral stress of the biaxial test and the middle one of direct shear; confined compression starts from a
/// twentieth of it. Sizes and times are those of chapter 2's topics on chapter 3's sand, and scale with the radii.
void run_sand_test(SandTest test, const Case& sand, Effort effort, double stress_Pa, SandTests& result);

/// A number that the tests give, in the unit that a report shows.
struct SandQuantity {
    std::string name;   ///< as in [target], without unit
    std::string title;  ///< "Friction angle, peak"
    std::string test;   ///< "biaxial compression"
    std::string units;
    double per_si = 1;  ///< value in `units` over that in SI
    double TargetCase::*target = nullptr;
    double (*read)(const SandTests&) = nullptr;  ///< in SI and degrees; NaN where the tests say nothing
};
[[nodiscard]] std::span<const SandQuantity> sand_quantities();

/// c, tan φ and K through the three tests in the box.
[[nodiscard]] ShearStrength read_shear_strength(const SandTests& tests);

/// p = k zⁿ through what the plate met beyond a tenth of its way, where it met anything.
[[nodiscard]] PressureSinkage read_pressure_sinkage(const PlatePress& plate);

}  // namespace ifedem

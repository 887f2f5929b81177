#pragma once
#include "soil_tests/compression.hpp"
#include "traction/parametric_soil.hpp"

namespace ifedem {

/// Direct shear: a box twice as long as high, its walls, floor and lid of the sand's largest discs, without gravity.
/// The lid carries `normal_Pa`; then the upper half goes forward at a twentieth of the length a second, to
/// `largest_displacement` lengths. Ledges outside both halves keep the sand in. A point is a mean over a thousandth of
/// the length; stresses are those on the lower half over the box's own length, and ShearTest::normal_Pa is the mean
/// over the second half, since the walls' friction carries some of the lid's load.
[[nodiscard]] ShearTest shear_directly(const Case& sand, const SampleSize& size, double normal_Pa,
                                       double largest_displacement);

}  // namespace ifedem

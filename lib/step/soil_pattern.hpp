#pragma once
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// What came of the preparation of a block's discs.
struct PatternReport {
    double solid_fraction = 0;
    double bulk_density_kg_m3 = 0;
    double largest_overlap_m = 0, mean_overlap_m = 0;  ///< of the contacts within
};

/// The discs of one block (section 5.1.5), at rest, relative to its lower left corner: poured shoulder to shoulder into
/// a box of the block's length, settled without friction for elements.pattern_s with elements.pattern_mass_factor of
/// their mass; of these the elements.pattern_discs with the lowest tops stay; a lid comes down to the block's height in
/// the first half of a second time elements.pattern_s. The step is the case's times the root of the mass factor: the
/// same stability, and the text's 5·10⁻⁷ s for a travel at 5·10⁻⁶ s. Full masses are given back.
[[nodiscard]] std::vector<Disc> prepare_pattern(const Case& c);

[[nodiscard]] PatternReport report_pattern(const Case& c, const std::vector<Disc>& pattern);

}  // namespace ifedem

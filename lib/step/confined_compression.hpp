#pragma once
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"
#include "step/fields.hpp"

namespace ifedem {

/// One point of Fig 5-8; compression < 0, as the text has it.
struct ConfinedPoint {
    double strain = 0;
    double discs_Pa = 0;       ///< σ_y of the lid on the discs
    double discs_mean_Pa = 0;  ///< Σ_y of Eq 5.10 over the block's volume
    double element_Pa = 0;     ///< σ_y at the centroid of one element with elements.material
};

struct ConfinedCompression {
    std::vector<ConfinedPoint> point;
    std::vector<Disc> disc;          ///< at the end
    std::vector<DiscStress> stress;  ///< of each (Fig 5-9)
    double young_Pa = 0;             ///< Eq 5.9 with E' the gradient of the mean stress (Eq 5.10) over strain
    double young_of_lid_Pa = 0;  ///< with that of the stress on the lid, which friction of the side walls makes larger
};

/// Section 5.1.6: the block's discs between walls with the friction of travel, pressed by a lid to
/// `largest_strain` in `points` equal parts at `speed_m_s`.
[[nodiscard]] ConfinedCompression compress_confined(const Case& c, const std::vector<Disc>& pattern,
                                                    double largest_strain, int points, double speed_m_s);

}  // namespace ifedem

#pragma once
#include <vector>

#include "step/scene.hpp"

namespace ifedem {

/// Per disc, in list order, for pictures.
struct DiscFields {
    std::vector<float> speed_m_s;
    std::vector<float> pressure_Pa;  ///< −½ tr σ of Eq 5.10 from the springs of disc–disc contacts; compression > 0
};
[[nodiscard]] DiscFields measure_fields(const Scene& scene, const State& state, const Workspace& work);

/// Mean stress of a disc, Eq 5.10: (1/V) Σ r F over its contacts with discs, walls, wheel and elements, from their
/// springs (no dashpots). Compression < 0. r runs from the disc's centre to the contact point (contact_arm_m()).
struct DiscStress {
    double x_Pa = 0, y_Pa = 0, xy_Pa = 0;  ///< σ_x, σ_y and the mean of σ_xy and σ_yx
};
/// Per disc, in list order.
[[nodiscard]] std::vector<DiscStress> measure_stress(const Scene& scene, const State& state, const Workspace& work);

}  // namespace ifedem

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

}  // namespace ifedem

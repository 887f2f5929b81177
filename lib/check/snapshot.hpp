#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/vec2.hpp"

namespace ifedem {

/// What a picture of the soil and the wheel needs, at one time of a run.
struct Snapshot {
    struct DiscShape {
        Vec2 centre_m;
        double radius_m = 0;
        double speed_m_s = 0;  ///< colours the disc
    };
    std::vector<DiscShape> discs;
    std::vector<std::vector<Vec2>> elements;  ///< polygons of the wheel, open (the last corner is joined to the first)
};

/// Writes snapshot_discs.csv (x_m,y_m,radius_m,speed_m_s) and snapshot_wheel.csv (element,x_m,y_m). Throws Error(io).
void write_snapshot(const std::string& run_directory, const Snapshot& snapshot);

/// Nothing if the run has none.
[[nodiscard]] std::optional<Snapshot> read_snapshot(const std::string& run_directory);

}  // namespace ifedem

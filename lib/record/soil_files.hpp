#pragma once
#include <array>
#include <string>
#include <vector>

#include "model/state.hpp"

namespace ifedem {

struct Scene;      // step/scene.hpp
struct Workspace;  // step/scene.hpp

/// All conversions so far: step, block, kind, whether refused, attached discs, and stock before and after.
[[nodiscard]] std::string conversions_csv(const SoilState& soil);

/// "what,x_m,y_m,radius_m,stress_x_Pa,stress_y_Pa,stress_xy_Pa": mean stress of every disc (Eq 5.10) and stress at the
/// centroid of every soil element (no radius). Compression < 0.
[[nodiscard]] std::string stress_csv(const Scene& scene, const State& state, const Workspace& work);

// soil.csv of a run directory stands beside the frames of results.h5: a line for every element ("element", block, four
// corners) and every attached disc ("attached", block, centre, radius) at each frame's time.

/// Begins the file anew, without frames. Throws Error(io).
void start_soil_frames(const std::string& directory);

/// Appends the lines of one frame; they are on the disk when it returns. Throws Error(io).
void add_soil_frame(const std::string& directory, const SoilState& soil, double time_s, std::uint32_t columns);

/// For a run that goes on from an earlier time: what is later goes, and a line that was cut short. Throws Error(io),
/// also if the file is missing.
void drop_soil_frames_after(const std::string& directory, double time_s);

/// Elements and attached discs as drawn.
struct SoilOutline {
    struct Circle {
        Vec2 centre_m;
        double radius_m = 0;
    };
    std::vector<std::array<Vec2, 4>> element_m;
    std::vector<Circle> attached;
};

/// Those of the frame at `time_s`; empty if the run has no soil.csv.
[[nodiscard]] SoilOutline read_soil_outline(const std::string& directory, double time_s);

}  // namespace ifedem

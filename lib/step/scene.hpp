#pragma once
#include "coupling/soil_elements.hpp"
#include "coupling/wheel_contact.hpp"
#include "coupling/wheel_model.hpp"
#include "dem/dem_constants.hpp"
#include "dem/dem_workspace.hpp"
#include "model/case.hpp"
#include "model/state.hpp"
#include "step/profile.hpp"

namespace ifedem {

/// Everything constant of one stage.
struct Scene {
    Case c;
    Stage stage = Stage::consolidation;
    DemConstants dem;
    WheelModel wheel;
    SoilModel soil;
    [[nodiscard]] bool has_wheel() const { return stage != Stage::consolidation; }
    [[nodiscard]] bool has_soil_elements() const { return soil.columns > 0; }
};

[[nodiscard]] Scene make_scene(const Case& c, Stage stage);

/// Everything that is made from scene and state and never saved.
struct Workspace {
    DemWorkspace dem;
    WheelWorkspace wheel;
    SoilWorkspace soil;
    Profile profile;
};

[[nodiscard]] Workspace make_workspace(const Scene& scene, State& state);

/// Steps of a stage, rounded to the nearest whole one.
[[nodiscard]] std::uint64_t steps_of_stage(const Case& c, Stage stage);

/// Discs in an unsettled bed, no wheel: the beginning of consolidation.
[[nodiscard]] State make_initial_state(const Case& c);

/// Turns the end of one stage into the beginning of the next: levels the surface if the case asks for it and places the
/// wheel just above the soil (sinkage), or starts the control loops afresh (travel).
void begin_stage(const Scene& scene, State& state);

}  // namespace ifedem

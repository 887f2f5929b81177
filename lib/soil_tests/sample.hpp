#pragma once
#include <vector>

#include "soil_tests/world.hpp"

namespace ifedem {

/// Discs between flat walls that move: what a test on a sample of sand needs and the program's bins do not.
///
/// A wall moves by its point alone; contacts see no wall velocity, which is right for smooth walls that are slow
/// against the dashpots. Neighbour lists look at the movement of discs only, so they are made here with every wall
/// advanced by `margin_m`, and made anew before a wall has gone that far.
class Sample {
public:
    static constexpr double margin_m = 2e-5;

    Sample(const DemConstants& dem, std::vector<Disc> discs);

    /// Moves the walls to their points in `world().scene.dem` plus `shift_m` along their normals, then makes a step.
    /// Wall forces are those of that step.
    void step(const std::vector<double>& shift_m);
    void step();

    /// Normal force on each flat wall in the last step, > 0 when the sample pushes it.
    [[nodiscard]] const std::vector<double>& wall_force_N() const { return wall_force_N_; }
    /// Where friction changes, as at the end of a preparation. Springs stay.
    void set_friction(double soil, double wall);
    void set_rolling(double full_chords);

    [[nodiscard]] SoilWorld& world() { return world_; }
    [[nodiscard]] const SoilWorld& world() const { return world_; }

private:
    void measure_walls();

    SoilWorld world_;
    std::vector<double> moved_m_;  ///< since the last rebuild, largest of the walls' paths
    std::vector<double> wall_force_N_;
};

}  // namespace ifedem

#pragma once
#include <array>
#include <vector>

#include "support/dem_scenes.hpp"

namespace ifedem::chapter2 {

/// Discs between walls that move: what a test on a sample of sand needs and the program's bins do not.
///
/// A wall moves by its point alone; contacts see no wall velocity, which is right for walls that are slow against the
/// dashpots. Neighbour lists look at the movement of discs only, so they are made here with every wall advanced by
/// `margin_m`, and made anew before a wall has gone that far.
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

    [[nodiscard]] scene::World& world() { return world_; }
    [[nodiscard]] const scene::World& world() const { return world_; }

private:
    void measure_walls();

    scene::World world_;
    std::vector<double> moved_m_;  ///< since the last rebuild, largest of the walls' paths
    std::vector<double> wall_force_N_;
};

/// Plane-strain constants of chapter 3's sand, from secant moduli of one small sample: confined compression to 3 %, and
/// biaxial compression at 10 kPa to half its peak.
struct ElasticConstants {
    double young_Pa = 0, poisson = 0;
};
[[nodiscard]] ElasticConstants elastic_constants(int seed);

/// b − a, seed by seed.
[[nodiscard]] std::vector<double> paired(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ifedem::chapter2

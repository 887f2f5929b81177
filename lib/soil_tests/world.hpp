#pragma once
#include <cstdint>
#include <vector>

#include "step/scene.hpp"

namespace ifedem {

/// A simulation of discs between walls, kept together.
struct SoilWorld {
    Scene scene;
    State state;
    Workspace work;
};

/// `discs` between the walls of `dem`, numbered from 0; the smallest and largest radius become theirs.
[[nodiscard]] SoilWorld make_soil_world(DemConstants dem, std::vector<Disc> discs);

void advance(SoilWorld& world, std::int64_t steps);

/// What the soil tests take of a case: gravity, step, discs, contacts and seed. Bed, wheel and stages are the tests'.
[[nodiscard]] Case soil_of(const Case& c);

/// How long lasts what takes `duration_s` with chapter 3's sand on Earth: falls last as √(size/gravity).
[[nodiscard]] double duration_of_fall_s(const Case& sand, double duration_s);

/// Steps of `duration_s`, to the nearest whole one.
[[nodiscard]] std::int64_t steps_of(const Case& sand, double duration_s);

/// Half-way between the smallest and the largest radius.
[[nodiscard]] double middle_radius_m(const Case& sand);
[[nodiscard]] double largest_radius_m(const Case& sand);

/// Porosity in the bulk of a bed that the program has consolidated: ten largest radii away from floor, sides and
/// surface, over `length_m`.
[[nodiscard]] double measure_bulk_porosity(const Case& sand, std::int64_t discs, double length_m);

}  // namespace ifedem

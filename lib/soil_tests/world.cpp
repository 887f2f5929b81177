#include "soil_tests/world.hpp"

#include <algorithm>
#include <cmath>

#include "dem/bed.hpp"
#include "step/step.hpp"

namespace ifedem {

SoilWorld make_soil_world(DemConstants dem, std::vector<Disc> discs) {
    SoilWorld w;
    const auto [smallest, largest] = std::ranges::minmax_element(discs, {}, &Disc::radius_m);
    dem.smallest_radius_m = smallest->radius_m, dem.largest_radius_m = largest->radius_m;
    w.scene.dem = std::move(dem);
    w.state.discs.disc = std::move(discs);
    for (std::uint32_t n = 0; n < w.state.discs.disc.size(); ++n) w.state.discs.id.push_back(n);
    w.work = make_workspace(w.scene, w.state);
    return w;
}

void advance(SoilWorld& world, std::int64_t steps) {
    for (std::int64_t n = 0; n < steps; ++n) step(world.scene, world.state, world.work);
}

Case soil_of(const Case& c) {
    Case sand;
    sand.name = c.name;
    sand.gravity_m_s2 = c.gravity_m_s2, sand.time_step_s = c.time_step_s;
    sand.soil = c.soil, sand.contact = c.contact;
    sand.bed.seed = c.bed.seed;
    return sand;
}

double duration_of_fall_s(const Case& sand, double duration_s) {
    const double size = largest_radius_m(sand) / 0.003, gravity = sand.gravity_m_s2 / 9.81;
    return duration_s * std::sqrt(size / gravity);
}

std::int64_t steps_of(const Case& sand, double duration_s) { return std::llround(duration_s / sand.time_step_s); }

double middle_radius_m(const Case& sand) {
    const auto [smallest, largest] = std::ranges::minmax(sand.soil.radii_m);
    return 0.5 * (smallest + largest);
}

double largest_radius_m(const Case& sand) { return std::ranges::max(sand.soil.radii_m); }

double measure_bulk_porosity(const Case& sand, std::int64_t discs, double length_m) {
    Case c = soil_of(sand);
    c.bed.disc_count = discs, c.bed.length_m = length_m;
    SoilWorld w;
    w.scene = make_scene(c, Stage::consolidation);
    w.state = make_initial_state(c);
    w.work = make_workspace(w.scene, w.state);
    advance(w, steps_of(c, duration_of_fall_s(c, c.stages.consolidation_s)));
    const double margin = 10 * w.scene.dem.largest_radius_m;
    const double surface = measure_surface_m(w.state.discs, length_m, w.scene.dem.largest_radius_m);
    return measure_porosity(w.state.discs, length_m, margin, margin, surface - margin);
}

}  // namespace ifedem

// Porosity of the consolidated bed: three radii 3:2:1 by number, no friction, no rolling resistance that matters.
#include <cmath>

#include "dem/bed.hpp"
#include "support/wheel_scenes.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

/// Ten largest radii away from floor, surface and sides.
double bulk_porosity(std::int64_t seed) {
    Case c;
    c.bed.disc_count = 4000, c.bed.length_m = 0.5, c.bed.seed = seed;
    World w = begin(c);
    advance(w, static_cast<std::int64_t>(steps_of_stage(c, Stage::consolidation)));
    const double margin = 10 * w.scene.dem.largest_radius_m;
    const double surface = measure_surface_m(w.state.discs, c.bed.length_m, w.scene.dem.largest_radius_m);
    return measure_porosity(w.state.discs, c.bed.length_m, margin, margin, surface - margin);
}

}  // namespace

void measure_packing(Output& out, Effort effort) {
    std::vector<double> porosity, fraction;
    std::vector<std::vector<std::string>> rows;
    for (int seed = 1; seed <= (effort == Effort::full ? 10 : 3); ++seed) {
        porosity.push_back(bulk_porosity(seed));
        fraction.push_back(1 - porosity.back());
        rows.push_back({std::to_string(seed), number(porosity.back())});
    }
    out.write_table("packing.csv", "seed,porosity", rows);
    out.add("packing_porosity", porosity, "-", "bulk of 4000 discs in 0.5 m after 1 s of consolidation");
    out.add("packing_fraction", fraction, "-", "1 − porosity");
}

}  // namespace ifedem::chapter2

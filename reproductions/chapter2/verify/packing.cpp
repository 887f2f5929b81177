// Porosity of the consolidated bed: three radii 3:2:1 by number, no friction, no rolling resistance that matters.
#include "soil_tests/world.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {

void measure_packing(Output& out, Effort effort) {
    std::vector<double> porosity, fraction;
    std::vector<std::vector<std::string>> rows;
    for (int seed = 1; seed <= (effort == Effort::full ? 10 : 3); ++seed) {
        Case c;
        c.bed.seed = seed;
        porosity.push_back(measure_bulk_porosity(c, 4000, 0.5));
        fraction.push_back(1 - porosity.back());
        rows.push_back({std::to_string(seed), number(porosity.back())});
    }
    out.write_table("packing.csv", "seed,porosity", rows);
    out.add("packing_porosity", porosity, "-", "bulk of 4000 discs in 0.5 m after 1 s of consolidation");
    out.add("packing_fraction", fraction, "-", "1 − porosity");
}

}  // namespace ifedem::chapter2

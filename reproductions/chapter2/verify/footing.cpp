// Section 2.2's layered soil: discs over plane-strain elements, under a rigid cylinder that sinks by its load, against
// discs all the way down. The elements take the modulus that a sample of the same sand shows in confined compression.
#include <cmath>

#include "sand.hpp"
#include "support/wheel_scenes.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

struct Bin {
    std::int64_t discs = 0;  ///< all the way down
    double depth_m = 0, length_m = 0, consolidation_s = 0, sinkage_s = 0;
    double confined_Pa = 0;  ///< of the elements
};

Case make_bin(const Bin& bin, bool layered, int seed) {
    Case c;
    c.bed.length_m = bin.length_m, c.bed.seed = seed;
    c.bed.disc_count = layered ? bin.discs / 2 : bin.discs;
    c.travel.start_x_m = 0.5 * bin.length_m;
    c.stages.consolidation_s = bin.consolidation_s, c.stages.sinkage_s = bin.sinkage_s;
    c.wheel.body = WheelBody::rigid;
    c.wheel.lug_pairs = 0;
    if (layered) {
        c.elements.columns = static_cast<std::int64_t>(std::llround(bin.length_m / 0.06));
        c.elements.rows = 2;
        c.elements.block_length_m = bin.length_m / static_cast<double>(c.elements.columns);
        c.elements.block_height_m = 0.25 * bin.depth_m;
        const double poisson = c.elements.material.poisson = 0.3;  // chapter 5's
        c.elements.material.young_Pa = bin.confined_Pa * (1 + poisson) * (1 - 2 * poisson) / (1 - poisson);
    }
    return c;
}

/// Sinkage since the first touch against time.
std::vector<double> sink(const Case& c, std::int64_t points) {
    World w = begin(c);
    advance(w, static_cast<std::int64_t>(steps_of_stage(c, Stage::consolidation)));
    enter(w, c, Stage::sinkage);
    std::vector<double> sinkage_mm;
    const auto steps = static_cast<std::int64_t>(steps_of_stage(c, Stage::sinkage));
    for (std::int64_t k = 0; k < points; ++k) {
        advance(w, steps / points);
        sinkage_mm.push_back(1e3 * (w.state.touch_position_m.y - w.state.wheel.rim.position_m.y));
    }
    return sinkage_mm;
}

/// The cylinder rides up and down on the springs of the bed: the second half is some six periods.
double mean_of_second_half(const std::vector<double>& values) {
    double sum = 0;
    const std::size_t from = values.size() / 2;
    for (std::size_t k = from; k < values.size(); ++k) sum += values[k] / static_cast<double>(values.size() - from);
    return sum;
}

}  // namespace

void measure_footing(Output& out, Effort effort) {
    const double modulus_Pa = 0.5 * (confined_modulus_Pa(1) + confined_modulus_Pa(2));
    const Bin bin = effort == Effort::full ? Bin{10000, 0.235, 0.9, 0.8, 1.2, modulus_Pa}
                                           : Bin{3000, 0.105, 0.6, 0.4, 0.3, modulus_Pa};
    constexpr std::int64_t points = 100;
    std::vector<double> discs, layered, ratio;
    std::vector<std::vector<std::string>> rows;
    for (int seed = 1; seed <= (effort == Effort::full ? 3 : 1); ++seed) {
        const std::vector<double> all = sink(make_bin(bin, false, seed), points),
                                  half = sink(make_bin(bin, true, seed), points);
        discs.push_back(mean_of_second_half(all));
        layered.push_back(mean_of_second_half(half));
        ratio.push_back(layered.back() / discs.back());
        for (std::size_t k = 0; k < all.size(); ++k)
            rows.push_back({std::to_string(seed), number(bin.sinkage_s * static_cast<double>(k + 1) / points),
                            number(all[k]), number(half[k])});
    }
    out.write_table("footing.csv", "seed,time_s,discs_mm,layered_mm", rows);
    out.add("footing_sinkage_discs", discs, "mm",
            "rigid cylinder, radius 0.15 m, 170 N; mean of the second half of 1.2 s");
    out.add("footing_sinkage_layered", layered, "mm", "lower half of the bin elements");
    out.add("footing_ratio", ratio, "-", "layered over discs, by seed");
}

}  // namespace ifedem::chapter2

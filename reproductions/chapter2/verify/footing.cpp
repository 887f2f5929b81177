// Section 2.2's layered soil: discs over plane-strain elements, under a rigid cylinder that sinks by its load, against
// discs all the way down. The elements take both constants from tests on the same sand: with chapter 5's ν of 0.3 and
// the confined modulus alone they would be a quarter too soft in shear.
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
    ElasticConstants sand;  ///< of the elements
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
        c.elements.material.young_Pa = bin.sand.young_Pa, c.elements.material.poisson = bin.sand.poisson;
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
    const ElasticConstants one = elastic_constants(1), two = elastic_constants(2);
    const ElasticConstants sand{0.5 * (one.young_Pa + two.young_Pa), 0.5 * (one.poisson + two.poisson)};
    out.add("sand_young_modulus", 1e-6 * sand.young_Pa, "MPa", "of confined and biaxial secant moduli, two samples");
    out.add("sand_poisson", sand.poisson, "-", "of the ratio of both");
    const Bin bin =
        effort == Effort::full ? Bin{10000, 0.235, 0.9, 0.8, 1.2, sand} : Bin{3000, 0.105, 0.6, 0.4, 0.3, sand};
    constexpr std::int64_t points = 100;
    std::vector<double> discs, layered, excess;
    std::vector<std::vector<std::string>> rows;
    for (int seed = 1; seed <= (effort == Effort::full ? 32 : 1); ++seed) {
        const std::vector<double> all = sink(make_bin(bin, false, seed), points),
                                  half = sink(make_bin(bin, true, seed), points);
        discs.push_back(mean_of_second_half(all));
        layered.push_back(mean_of_second_half(half));
        excess.push_back(layered.back() / discs.back() - 1);
        for (std::size_t k = 0; k < all.size(); ++k)
            rows.push_back({std::to_string(seed), number(bin.sinkage_s * static_cast<double>(k + 1) / points),
                            number(all[k]), number(half[k])});
    }
    out.write_table("footing.csv", "seed,time_s,discs_mm,layered_mm", rows);
    out.add("footing_sinkage_discs", discs, "mm",
            "rigid cylinder, radius 0.15 m, 170 N; mean of the second half of 1.2 s");
    out.add("footing_sinkage_layered", layered, "mm", "lower half of the bin elements");
    out.add_difference("footing_excess", excess, "-", "layered over discs, less 1, by seed");
}

}  // namespace ifedem::chapter2

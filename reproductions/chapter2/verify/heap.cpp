// Angle of repose: how it answers to friction, rolling resistance, density and stiffness.
#include <cmath>

#include "check/trend.hpp"
#include "sand.hpp"
#include "soil_tests/repose.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

struct Heap {
    double friction = 0.6, rolling = 1;  ///< µ everywhere; full chords
    double density = 1, stiffness = 1;   ///< over chapter 3's
    double size = 1, damping = 0.2;      ///< radii over chapter 3's, the column stays; ζ
};

Repose make_heap(const Heap& heap, int seed, std::int64_t count) {
    Case c;
    ReposeScene scene = scale_repose(c, count);
    scene.discs = std::llround(static_cast<double>(count) / (heap.size * heap.size));
    c.bed.seed = seed;
    for (double& r : c.soil.radii_m) r *= heap.size;
    c.contact.damping_ratio = heap.damping;
    c.soil.density_kg_m3 *= heap.density;
    c.contact.normal_stiffness_N_m *= heap.stiffness, c.contact.tangential_stiffness_N_m *= heap.stiffness;
    c.contact.rolling_factor = heap.rolling;
    c.contact.friction_soil = c.contact.friction_wall = heap.friction;
    return spill(c, scene);
}

struct Sweep {
    const char* name;
    double Heap::*member;
    std::vector<double> levels;
    double rolling = 1;
    bool constant_arm = false;  ///< the rolling arm keeps its length where Eq 2.18's grows with the disc
};

}  // namespace

void measure_heap(Output& out, Effort effort) {
    const bool full = effort == Effort::full;
    const int seeds = full ? 5 : 2;
    const std::int64_t count = full ? 800 : 500;
    const std::vector<double> densities = full ? std::vector{0.5, 2.0} : std::vector{1.0, 2.0};
    const std::vector<double> stiffnesses = full ? std::vector{0.3, 3.0} : std::vector{1.0, 3.0};
    const std::vector<double> sizes = full ? std::vector{0.7, 1.4} : std::vector{1.0, 1.4};
    // ζ = 0.05 is for the figure: some heaps run out there.
    const std::vector<double> dampings = full ? std::vector{0.1, 0.05, 0.7} : std::vector{0.1, 0.7};
    // Density, stiffness and size twice: without rolling resistance, and with that of Eq 2.18, whose arm grows with the
    // load.
    const std::vector<Sweep> sweeps{
        {"sliding", &Heap::friction, full ? std::vector{0.1, 0.2, 0.4, 0.6, 0.8} : std::vector{0.1, 0.6}},
        {"rolling", &Heap::rolling, full ? std::vector{0.0, 0.5, 1.0, 2.0} : std::vector{0.0, 2.0}},
        {"density", &Heap::density, densities, 0},
        {"stiffness", &Heap::stiffness, stiffnesses, 0},
        {"damping", &Heap::damping, dampings, 0},
        {"size", &Heap::size, sizes, 0},
        {"density_chord", &Heap::density, densities},
        {"stiffness_chord", &Heap::stiffness, stiffnesses},
        {"size_chord", &Heap::size, sizes},
        {"size_arm", &Heap::size, sizes, 1, true}};
    std::vector<std::vector<std::string>> rows, shape;
    for (const Sweep& sweep : sweeps) {
        const bool friction = sweep.member == &Heap::friction || sweep.member == &Heap::rolling;
        std::vector<std::vector<double>> angles;
        for (const double level : sweep.levels) {
            Heap heap;
            heap.rolling = sweep.rolling;
            heap.*sweep.member = level;
            if (sweep.constant_arm) heap.rolling /= heap.size;
            std::vector<double> at_level;
            for (int seed = 1; seed <= seeds; ++seed) {
                const Repose r = make_heap(heap, seed, count);
                at_level.push_back(r.angle_deg);
                rows.push_back({sweep.name, number(level), number(r.angle_deg)});
                const bool ends = level == sweep.levels.front() || level == sweep.levels.back();
                if (seed != 1 || !ends || !friction) continue;
                for (const Disc& d : r.discs)
                    shape.push_back({std::string(sweep.name) + (level == sweep.levels.front() ? "-low" : "-high"),
                                     number(d.x_m), number(d.y_m), number(d.radius_m)});
            }
            angles.push_back(at_level);
        }
        const std::string what = "angle at the highest level less that at the lowest, seed by seed";
        out.add_difference(std::string("repose_change_") + sweep.name, paired(angles.front(), angles.back()), "deg",
                           what);
        if (!full || !friction) continue;
        ValuesBySlip by_level;
        for (std::size_t k = 0; k < angles.size(); ++k) by_level[sweep.levels[k]] = angles[k];
        const TrendResult trend = judge_monotonic(trend_points(by_level, pool(by_level)), 1);
        out.add(std::string("repose_departure_") + sweep.name, trend.error_over_tolerance.value_or(INFINITY), "-",
                "largest departure of a level from the isotonic fit, over its U");
    }
    out.write_table("repose.csv", "sweep,level,angle_deg", rows);
    out.write_table("heaps.csv", "heap,x_m,y_m,radius_m", shape);
}

}  // namespace ifedem::chapter2

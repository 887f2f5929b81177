// Angle of repose: a column of sand whose right wall is taken away from the top downwards, one wall disc at a time, so
// that the sand spills slowly. (Taking the wall away at once measures the run-out of a collapse instead.)
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/trend.hpp"
#include "dem/bed.hpp"
#include "dem/neighbour_lists.hpp"
#include "sand.hpp"
#include "support/wheel_scenes.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

struct Heap {
    double friction = 0.6, rolling = 1;  ///< µ everywhere; full chords
    double density = 1, stiffness = 1;   ///< over chapter 3's
    double size = 1, damping = 0.2;      ///< radii over chapter 3's, the column stays; ζ
};

constexpr double column_m = 0.12, floor_m = 0.8, wall_radius_m = 0.003;

/// Floor, both ends, and last the gate from bottom to top.
std::vector<WallDisc> make_heap_walls(double height_m) {
    std::vector<WallDisc> walls;
    const auto rows = static_cast<int>(height_m / (2 * wall_radius_m));
    for (double x = 0; x < floor_m; x += 2 * wall_radius_m) walls.push_back({{x, -wall_radius_m}, wall_radius_m});
    for (int k = 0; k < rows; ++k) walls.push_back({{-wall_radius_m, (2 * k + 1) * wall_radius_m}, wall_radius_m});
    for (int k = 0; k < 10; ++k) walls.push_back({{floor_m, (2 * k + 1) * wall_radius_m}, wall_radius_m});
    for (int k = 0; k < rows; ++k)
        walls.push_back({{column_m + wall_radius_m, (2 * k + 1) * wall_radius_m}, wall_radius_m});
    return walls;
}

/// Slope of the surface between 15 and 85 % of its height, by least squares over columns of two largest diameters.
double surface_angle_deg(const DiscState& discs) {
    constexpr double width = 4 * wall_radius_m;
    std::map<int, double> top;
    for (const Disc& d : discs.disc) {
        double& t = top[static_cast<int>(d.x_m / width)];
        t = std::max(t, d.y_m + d.radius_m);
    }
    double highest = 0;
    for (const auto& [column, height] : top) highest = std::max(highest, height);
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [column, height] : top) {
        if (height < 0.15 * highest || height > 0.85 * highest) continue;
        const double x = (column + 0.5) * width;
        n += 1, sx += x, sy += height, sxx += x * x, sxy += x * height;
    }
    return -std::atan((n * sxy - sx * sy) / (n * sxx - sx * sx)) * 180 / pi;
}

struct Result {
    double angle_deg = 0;
    DiscState discs;
};

Result make_heap(const Heap& heap, int seed, std::int64_t count) {
    Case c;
    const double discs = static_cast<double>(count) / (heap.size * heap.size);
    c.bed.disc_count = std::llround(discs), c.bed.length_m = column_m, c.bed.seed = seed;
    for (double& r : c.soil.radii_m) r *= heap.size;
    c.contact.damping_ratio = heap.damping;
    c.soil.density_kg_m3 *= heap.density;
    c.contact.normal_stiffness_N_m *= heap.stiffness, c.contact.tangential_stiffness_N_m *= heap.stiffness;
    c.contact.rolling_factor = heap.rolling;
    const double height = 1.3 * static_cast<double>(count) * pi * 0.0025 * 0.0025 / column_m / 0.8;
    const State filled = make_initial_state(c);
    DemConstants dem = make_dem_constants(c, heap.friction, heap.friction);
    dem.flat_walls.clear();
    dem.wall_discs = make_heap_walls(height + 0.03);
    World w = make_world(dem, filled.discs.disc);
    advance(w, 12500);  // 0.5 s
    const std::size_t gate_begin =
        w.scene.dem.wall_discs.size() - static_cast<std::size_t>((height + 0.03) / (2 * wall_radius_m));
    while (w.scene.dem.wall_discs.size() > gate_begin) {
        w.scene.dem.wall_discs.pop_back();
        w.work.dem.rebuild_outer = true;  // the lists must forget it
        advance(w, 1250);                 // 0.05 s a disc of 6 mm
    }
    advance(w, 15000);
    return {surface_angle_deg(w.state.discs), w.state.discs};
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
                const Result r = make_heap(heap, seed, count);
                at_level.push_back(r.angle_deg);
                rows.push_back({sweep.name, number(level), number(r.angle_deg)});
                const bool ends = level == sweep.levels.front() || level == sweep.levels.back();
                if (seed != 1 || !ends || !friction) continue;
                for (const Disc& d : r.discs.disc)
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

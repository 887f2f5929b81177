#include "soil_tests/repose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/bitmath.hpp"
#include "dem/bed.hpp"
#include "soil_tests/world.hpp"

namespace ifedem {
namespace {

std::size_t gate_rows(const ReposeScene& s) { return static_cast<std::size_t>(s.gate_m / (2 * s.wall_radius_m)); }

/// Floor, both ends, and last the gate from bottom to top.
std::vector<WallDisc> make_walls(const ReposeScene& s) {
    const double r = s.wall_radius_m;
    std::vector<WallDisc> walls;
    const auto rows = static_cast<int>(gate_rows(s));
    for (double x = 0; x < s.floor_m; x += 2 * r) walls.push_back({{x, -r}, r});
    for (int k = 0; k < rows; ++k) walls.push_back({{-r, (2 * k + 1) * r}, r});
    for (int k = 0; k < 10; ++k) walls.push_back({{s.floor_m, (2 * k + 1) * r}, r});
    for (int k = 0; k < rows; ++k) walls.push_back({{s.column_m + r, (2 * k + 1) * r}, r});
    return walls;
}

/// Least squares over columns of two largest diameters.
double surface_angle_deg(const std::vector<Disc>& discs, double wall_radius_m) {
    const double width = 4 * wall_radius_m;
    std::map<int, double> top;
    for (const Disc& d : discs) {
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
    if (n < 2) return std::numeric_limits<double>::quiet_NaN();
    return -std::atan((n * sxy - sx * sy) / (n * sxx - sx * sx)) * 180 / pi;
}

}  // namespace

ReposeScene scale_repose(const Case& sand, std::int64_t discs) {
    const double size = largest_radius_m(sand) / 0.003, middle = middle_radius_m(sand);
    ReposeScene s{discs, size * 0.12, size * 0.8, size * 0.003, 0, duration_of_fall_s(sand, 0.05)};
    s.gate_m = 1.3 * static_cast<double>(discs) * pi * middle * middle / s.column_m / 0.8 + 10 * s.wall_radius_m;
    return s;
}

Repose spill(const Case& sand, const ReposeScene& scene) {
    Case c = soil_of(sand);
    c.bed.disc_count = scene.discs, c.bed.length_m = scene.column_m;
    DemConstants dem = make_dem_constants(c, c.contact.friction_soil, c.contact.friction_wall);
    dem.flat_walls.clear();
    dem.wall_discs = make_walls(scene);
    SoilWorld w = make_soil_world(dem, generate_bed(c).disc);
    advance(w, steps_of(c, 10 * scene.pace_s));
    std::vector<WallDisc>& walls = w.scene.dem.wall_discs;
    const std::size_t gate_begin = walls.size() - gate_rows(scene);
    while (walls.size() > gate_begin) {
        walls.pop_back();
        w.work.dem.rebuild_outer = true;  // the lists must forget it
        advance(w, steps_of(c, scene.pace_s));
    }
    advance(w, steps_of(c, 12 * scene.pace_s));
    return {surface_angle_deg(w.state.discs.disc, scene.wall_radius_m), w.state.discs.disc};
}

}  // namespace ifedem

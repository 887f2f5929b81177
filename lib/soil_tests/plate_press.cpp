#include "soil_tests/plate_press.hpp"

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"
#include "dem/bed.hpp"
#include "soil_tests/wall_bodies.hpp"

namespace ifedem {
namespace {

enum Body : std::uint32_t { bin, plate };

/// A bin 2.6 times as long as the sand in it is high.
WallBodies settle_bed(const Case& sand, std::int64_t discs, double& length_m) {
    Case c = soil_of(sand);
    c.bed.walls = WallKind::discs;
    c.bed.disc_count = discs;
    const double middle = middle_radius_m(c);
    length_m = c.bed.length_m = std::sqrt(2.6 * static_cast<double>(discs) * pi * middle * middle / 0.85);
    const DemConstants dem =
        make_dem_constants(c, c.contact.consolidation_friction_soil, c.contact.consolidation_friction_wall);
    WallBodies bodies(dem, generate_bed(c).disc, std::vector<std::uint32_t>(dem.wall_discs.size(), bin));
    bodies.advance(steps_of(c, duration_of_fall_s(c, c.stages.consolidation_s)));
    bodies.set_friction(c.contact.friction_soil, c.contact.friction_wall);
    return bodies;
}

/// Its lower side just above the sand, in the middle of the bin; sides higher than it will sink. Returns its width.
double add_plate(WallBodies& bodies, double length_m) {
    const DemConstants& dem = bodies.world().scene.dem;
    const double r = dem.smallest_radius_m;
    const auto columns = std::llround(0.2 * length_m / (2 * r));
    const double width = static_cast<double>(2 * columns) * r, left = 0.5 * (length_m - width);
    double top = 0;
    for (const Disc& d : bodies.world().state.discs.disc)
        if (d.x_m > left - 2 * r && d.x_m < left + width + 2 * r) top = std::max(top, d.y_m + d.radius_m);
    const auto at = [&](long long column, long long row) {
        return WallDisc{{left + static_cast<double>(2 * column + 1) * r, top + static_cast<double>(2 * row + 1) * r},
                        r};
    };
    for (long long k = 0; k < columns; ++k) bodies.add(at(k, 0), plate);
    for (long long row = 1; row < columns / 2; ++row)
        for (const long long column : {0LL, columns - 1}) bodies.add(at(column, row), plate);
    return width;
}

}  // namespace

PlatePress press_plate(const Case& sand, std::int64_t discs) {
    double length_m = 0;
    WallBodies bodies = settle_bed(sand, discs, length_m);
    PlatePress test;
    test.width_m = add_plate(bodies, length_m);
    const double way = 0.25 * test.width_m;
    constexpr int points = 100;
    const std::int64_t interval = steps_of(sand, duration_of_fall_s(sand, 0.01));
    const double step = way / points / static_cast<double>(interval);
    bodies.set_velocity(plate, {0, -step / sand.time_step_s});
    bodies.step();
    for (std::int64_t n = 0; n < points * interval && !(bodies.force_N(plate).y > 0); ++n) bodies.step();
    for (int p = 0; p < points; ++p) {
        double force = 0;
        for (std::int64_t n = 0; n < interval; ++n) {
            bodies.step();
            force += bodies.force_N(plate).y;
        }
        test.sinkage_m.push_back((p + 0.5) * way / points);
        test.pressure_Pa.push_back(force / static_cast<double>(interval) / (test.width_m * sand.soil.thickness_m));
    }
    test.discs = bodies.world().state.discs.disc;
    return test;
}

}  // namespace ifedem

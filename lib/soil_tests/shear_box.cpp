#include "soil_tests/shear_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "dem/bed.hpp"
#include "soil_tests/wall_bodies.hpp"

namespace ifedem {
namespace {

enum Body : std::uint32_t { lower, upper, lid };

struct Box {
    WallBodies bodies;
    double length_m = 0, radius_m = 0, thickness_m = 0;
    std::size_t side_begin = 0, side_end = 0;  ///< wall discs of both sides, in rows of two from below

    /// Lower side of the lid.
    [[nodiscard]] double lid_m() const { return bodies.world().scene.dem.wall_discs[side_end].centre_m.y - radius_m; }
    [[nodiscard]] double pressure_Pa(Body body, double sign) const {
        return sign * bodies.force_N(body).y / (length_m * thickness_m);
    }
};

/// Loose between floor, sides and a lid on top; all walls but the lid are one body.
Box fill_box(const Case& sand, std::int64_t discs) {
    Case c = soil_of(sand);
    c.gravity_m_s2 = 0;
    c.bed.disc_count = discs;
    const double r = largest_radius_m(c), middle = middle_radius_m(c);
    const auto columns =
        std::llround(std::sqrt(2 * static_cast<double>(discs) * pi * middle * middle / 0.85) / (2 * r));
    c.bed.length_m = 2 * r * static_cast<double>(columns);
    const DiscState filled = generate_bed(c);
    const double height = highest_top_m(filled);
    DemConstants dem =
        make_dem_constants(c, c.contact.consolidation_friction_soil, c.contact.consolidation_friction_wall);
    dem.flat_walls.clear();
    std::vector<WallDisc>& walls = dem.wall_discs;
    std::vector<std::uint32_t> body;
    const auto add = [&](double x, double y, Body b) { walls.push_back({{x, y}, r}), body.push_back(b); };
    for (long long k = 0; k < columns; ++k) add(static_cast<double>(2 * k + 1) * r, -r, lower);
    const std::size_t side_begin = walls.size();
    const auto rows = static_cast<int>(std::ceil(height / (2 * r)));
    for (int k = 0; k < rows; ++k)
        for (const double x : {-r, c.bed.length_m + r}) add(x, (2 * k + 1) * r, lower);
    const std::size_t side_end = walls.size();
    for (long long k = 0; k < columns; ++k) add(static_cast<double>(2 * k + 1) * r, height + r, lid);
    return {WallBodies(dem, filled.disc, body), c.bed.length_m, r, c.soil.thickness_m, side_begin, side_end};
}

/// The lid's speed downwards.
double lid_speed_m_s(const Box& box, double normal_Pa) {
    const DemConstants& dem = box.bodies.world().scene.dem;
    return servo_m(dem, box.thickness_m, box.pressure_Pa(lid, 1), normal_Pa) / dem.step_s;
}

void press(Box& box, double normal_Pa) {
    box.bodies.set_velocity(lid, {0, -lid_speed_m_s(box, normal_Pa)});
    box.bodies.step();
}

/// Until the sand carries the lid, and then for the given time.
void consolidate(Box& box, double normal_Pa, std::int64_t steps) {
    std::int64_t carried = 0;
    while (carried < steps) {
        press(box, normal_Pa);
        if (carried > 0 || box.pressure_Pa(lid, 1) > 0.9 * normal_Pa) ++carried;
        if (box.lid_m() < 2 * box.radius_m)
            throw Error(
                ExitCode::health,
                fmt::format("the sand does not carry the lid of the shear box (at {:g} Pa it reaches the floor). "
                            "Lower the time step, or --stress?",
                            normal_Pa));
    }
}

/// Cuts the sides half-way up the sand, and gives each half a ledge as long as the way to go.
void cut(Box& box, double way_m) {
    const double r = box.radius_m;
    const auto below = static_cast<std::size_t>(std::lround(0.25 * box.lid_m() / r));
    for (std::size_t w = box.side_begin + 2 * below; w < box.side_end; ++w) box.bodies.assign(w, upper);
    const double split = 2 * r * static_cast<double>(below);
    for (double s = 3 * r; s < way_m + 4 * r; s += 2 * r) {
        box.bodies.add({{box.length_m + s, split - r}, r}, lower);
        box.bodies.add({{-s, split + r}, r}, upper);
    }
}

}  // namespace

ShearTest shear_directly(const Case& sand, const SampleSize& size, double normal_Pa, double largest_displacement) {
    constexpr double rate_1_s = 0.05, share_a_point = 1e-3;
    Box box = fill_box(sand, size.discs);
    consolidate(box, normal_Pa, steps_of(sand, size.consolidation_s));
    cut(box, largest_displacement * box.length_m);
    box.bodies.set_friction(sand.contact.friction_soil, sand.contact.friction_wall);
    const double speed = rate_1_s * box.length_m, area = box.length_m * box.thickness_m;
    const std::int64_t interval = steps_of(sand, share_a_point / rate_1_s);
    const auto points = static_cast<int>(std::lround(largest_displacement / share_a_point)), earlier = points / 2;
    ShearTest test;
    test.displacement_m.push_back(0), test.shear_Pa.push_back(0);
    box.bodies.set_velocity(upper, {speed, 0});
    for (int p = 0; p < points; ++p) {
        double shear = 0, normal = 0;
        for (std::int64_t n = 0; n < interval; ++n) {
            box.bodies.set_velocity(lid, {speed, -lid_speed_m_s(box, normal_Pa)});
            box.bodies.step();
            shear += box.bodies.force_N(lower).x / area;
            normal += box.pressure_Pa(lower, -1);
        }
        const auto steps = static_cast<double>(interval);
        test.displacement_m.push_back((p + 0.5) * share_a_point * box.length_m);
        test.shear_Pa.push_back(shear / steps);
        if (p >= earlier) test.normal_Pa += normal / steps / (points - earlier);
    }
    return test;
}

}  // namespace ifedem

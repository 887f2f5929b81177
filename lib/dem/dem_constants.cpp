#include "dem/dem_constants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifedem {
namespace {

ContactConstants make_contact(const ContactCase& c, double friction) {
    ContactConstants k;
    k.normal_stiffness_N_m = c.normal_stiffness_N_m;
    k.tangential_stiffness_N_m = c.tangential_stiffness_N_m;
    k.inverse_tangential_stiffness_m_N = 1.0 / c.tangential_stiffness_N_m;
    k.friction = friction;
    k.damping_ratio_of_ratios = std::sqrt(c.tangential_stiffness_N_m / c.normal_stiffness_N_m);
    k.rolling_chords = c.rolling_factor * (c.rolling_chord == RollingChord::full ? 1.0 : 0.5);
    k.smallest_normal_N = c.contact_end == ContactEnd::no_attraction ? 0.0 : -std::numeric_limits<double>::infinity();
    return k;
}

/// Discs of the largest radius shoulder to shoulder along floor and sides, their inner tangent on the flat wall's line.
std::vector<WallDisc> make_wall_discs(double length_m, double height_m, double radius_m) {
    std::vector<WallDisc> discs;
    const auto columns = static_cast<int>(std::ceil(length_m / (2 * radius_m)));
    const auto rows = static_cast<int>(std::ceil(height_m / (2 * radius_m)));
    const double spacing = length_m / columns;
    for (int k = 0; k < columns; ++k) discs.push_back({{(k + 0.5) * spacing, -radius_m}, radius_m});
    for (int k = 0; k < rows; ++k) discs.push_back({{-radius_m, (2 * k + 1) * radius_m}, radius_m});
    for (int k = 0; k < rows; ++k) discs.push_back({{length_m + radius_m, (2 * k + 1) * radius_m}, radius_m});
    return discs;
}

}  // namespace

DemConstants make_dem_constants(const Case& c, double friction_soil, double friction_wall) {
    DemConstants k;
    k.soil = make_contact(c.contact, friction_soil);
    k.wall = make_contact(c.contact, friction_wall);
    k.wheel = make_contact(c.contact, c.contact.friction_wheel);
    k.damping_ratio = c.contact.damping_ratio;
    k.gravity_m_s2 = {0, -c.gravity_m_s2};
    k.step_s = c.time_step_s;
    k.smallest_radius_m = *std::min_element(c.soil.radii_m.begin(), c.soil.radii_m.end());
    k.largest_radius_m = *std::max_element(c.soil.radii_m.begin(), c.soil.radii_m.end());
    k.rolling = c.contact.rolling_scheme;
    if (c.bed.walls == WallKind::flat) {
        k.flat_walls = {{{0, 0}, {0, 1}}, {{0, 0}, {1, 0}}, {{c.bed.length_m, 0}, {-1, 0}}};
    } else {
        const double disc_area = 4 * k.largest_radius_m * k.largest_radius_m * static_cast<double>(c.bed.disc_count);
        k.wall_discs = make_wall_discs(c.bed.length_m, 1.2 * disc_area / c.bed.length_m, k.largest_radius_m);
    }
    return k;
}

}  // namespace ifedem

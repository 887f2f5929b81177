#include "step/confined_compression.hpp"

#include <cmath>

#include "core/bitmath.hpp"
#include "fem/elements.hpp"
#include "step/step.hpp"

namespace ifedem {
namespace {

/// On the last flat wall.
double lid_force_N(const Scene& scene, const State& state, const Workspace& work) {
    const auto lid = static_cast<std::uint32_t>(scene.dem.flat_walls.size() - 1);
    double sum = 0;
    for (const WallCandidate& w : work.dem.wall) {
        if (w.wall != lid) continue;
        const Disc& d = state.discs.disc[w.position];
        sum += scene.dem.wall.normal_stiffness_N_m *
               max_of(0.0, d.radius_m - find_wall_side(scene.dem, lid, d).distance_m);
    }
    return sum;
}

/// One element between the same walls, its top moved down by `strain` of its height.
double element_stress_Pa(const ElementsCase& e, double strain) {
    const double l = e.block_length_m, h = e.block_height_m, now = h * (1 - strain);
    return quad_stress_Pa(e.material, PlaneState::strain, {{{0, 0}, {l, 0}, {l, h}, {0, h}}},
                          {{{0, 0}, {l, 0}, {l, now}, {0, now}}})[1];
}

double mean_vertical_Pa(const std::vector<Disc>& disc, const std::vector<DiscStress>& stress, double area_m2) {
    double sum = 0;
    for (std::size_t p = 0; p < disc.size(); ++p) sum += stress[p].y_Pa * pi * disc[p].radius_m * disc[p].radius_m;
    return sum / area_m2;
}

/// Slope of a stress over strain by least squares; the discs bear a stress before they are compressed.
double gradient(const std::vector<ConfinedPoint>& points, double ConfinedPoint::*stress_Pa) {
    double x = 0, y = 0;
    for (const ConfinedPoint& p : points) x += p.strain, y += p.*stress_Pa;
    x /= static_cast<double>(points.size()), y /= static_cast<double>(points.size());
    double xy = 0, xx = 0;
    for (const ConfinedPoint& p : points)
        xy += (p.strain - x) * (p.*stress_Pa - y), xx += (p.strain - x) * (p.strain - x);
    return xy / xx;
}

}  // namespace

ConfinedCompression compress_confined(const Case& c, const std::vector<Disc>& pattern, double largest_strain,
                                      int points, double speed_m_s) {
    Case box = c;
    box.elements.columns = 0;
    box.integrator = Integrator::symplectic_euler;  // as the pattern is prepared: slow, whatever the case travels with
    box.bed.length_m = c.elements.block_length_m;
    box.contact.consolidation_friction_soil = c.contact.friction_soil;
    box.contact.consolidation_friction_wall = c.contact.friction_wall;
    Scene scene = make_scene(box, Stage::consolidation);
    const double length = c.elements.block_length_m, height = c.elements.block_height_m;
    scene.dem.flat_walls.push_back({{0, height}, {0, -1}});
    State state;
    state.discs.disc = pattern;
    for (std::uint32_t n = 0; n < pattern.size(); ++n) state.discs.id.push_back(n);
    Workspace work = make_workspace(scene, state);

    ConfinedCompression result;
    const double way = largest_strain * height / points;
    const auto steps = static_cast<std::uint64_t>(std::llround(way / speed_m_s / scene.dem.step_s));
    const std::uint64_t moves = 50, between = std::max<std::uint64_t>(1, steps / moves);
    for (int n = 0; n <= points; ++n) {
        for (std::uint64_t k = 0; n > 0 && k < moves; ++k) {
            scene.dem.flat_walls.back().point_m.y -= way / static_cast<double>(moves);
            work.dem.rebuild_outer = true;  // walls are searched from where they stand at a rebuild
            for (std::uint64_t s = 0; s < between; ++s) step(scene, state, work);
        }
        if (n == 0)
            for (std::uint64_t s = 0; s < moves * between; ++s) step(scene, state, work);
        const double strain = n * way / height;
        result.stress = measure_stress(scene, state, work);
        ConfinedPoint p;
        p.strain = -strain;
        p.discs_Pa = -lid_force_N(scene, state, work) / (length * c.soil.thickness_m);
        p.discs_mean_Pa = mean_vertical_Pa(state.discs.disc, result.stress, length * height * (1 - strain));
        p.element_Pa = element_stress_Pa(c.elements, strain);
        result.point.push_back(p);
    }
    result.disc = state.discs.disc;
    const double nu = c.elements.material.poisson, share = (1 + nu) * (1 - 2 * nu) / (1 - nu);
    result.young_Pa = share * gradient(result.point, &ConfinedPoint::discs_mean_Pa);
    result.young_of_lid_Pa = share * gradient(result.point, &ConfinedPoint::discs_Pa);
    return result;
}

}  // namespace ifedem

#include "step/soil_pattern.hpp"

#include <algorithm>
#include <cmath>

#include "core/bitmath.hpp"
#include "dem/bed.hpp"
#include "step/step.hpp"

namespace ifedem {
namespace {

/// A box of a block's length, without elements, wheel or friction.
Case make_box(const Case& c) {
    Case box = c;
    box.elements.columns = 0;
    box.bed.length_m = c.elements.block_length_m;
    box.bed.disc_count = c.elements.pattern_discs + c.elements.pattern_discs / 8;
    box.time_step_s = c.time_step_s * std::sqrt(c.elements.pattern_mass_factor);
    box.integrator = Integrator::symplectic_euler;
    box.contact.consolidation_friction_soil = box.contact.consolidation_friction_wall = 0;
    return box;
}

void keep_lowest(std::size_t count, DiscState& discs) {
    const std::vector<std::uint32_t> order = sort_by_top(discs);
    DiscState kept;
    for (std::size_t n = 0; n < std::min(count, order.size()); ++n) {
        kept.disc.push_back(discs.disc[order[n]]);
        kept.id.push_back(static_cast<std::uint32_t>(n));
    }
    discs = std::move(kept);
}

}  // namespace

std::vector<Disc> prepare_pattern(const Case& c) {
    const Case box = make_box(c);
    Scene scene = make_scene(box, Stage::consolidation);
    State state;
    state.discs = generate_bed(box);
    for (Disc& d : state.discs.disc) d.inverse_mass_1_kg /= c.elements.pattern_mass_factor;
    Workspace work = make_workspace(scene, state);
    const auto steps = static_cast<std::uint64_t>(std::llround(c.elements.pattern_s / box.time_step_s));
    for (std::uint64_t n = 0; n < steps; ++n) step(scene, state, work);

    DiscState kept = state.discs;
    keep_lowest(static_cast<std::size_t>(c.elements.pattern_discs), kept);
    state = {};
    state.discs = std::move(kept);
    const double height = c.elements.block_height_m, above = max_of(0.0, highest_top_m(state.discs) - height);
    scene.dem.flat_walls.push_back({{0, height + above}, {0, -1}});
    work = make_workspace(scene, state);
    const std::uint64_t way = std::max<std::uint64_t>(1, steps / 2), moves = std::min<std::uint64_t>(1000, way);
    const std::uint64_t stride = way / moves;
    for (std::uint64_t n = 0; n < steps; ++n) {
        if (n < way && n % stride == 0) {
            const double share = static_cast<double>(n + stride) / static_cast<double>(way);
            scene.dem.flat_walls.back().point_m.y = height + above * max_of(0.0, 1 - share);
            work.dem.rebuild_outer = true;  // walls are searched from where they stand at a rebuild
        }
        step(scene, state, work);
    }

    std::vector<Disc> pattern(state.discs.disc.size());
    for (std::size_t p = 0; p < pattern.size(); ++p) {
        Disc d = state.discs.disc[p];
        d.vx_m_s = d.vy_m_s = d.omega_rad_s = d.angle_rad = 0;
        d.inverse_mass_1_kg *= c.elements.pattern_mass_factor;
        pattern[state.discs.id[p]] = d;
    }
    return pattern;
}

PatternReport report_pattern(const Case& c, const std::vector<Disc>& pattern) {
    PatternReport r;
    double area = 0, overlaps = 0, contacts = 0;
    for (std::size_t a = 0; a < pattern.size(); ++a) {
        area += pi * pattern[a].radius_m * pattern[a].radius_m;
        for (std::size_t b = a + 1; b < pattern.size(); ++b) {
            const double overlap = pattern[a].radius_m + pattern[b].radius_m -
                                   norm({pattern[b].x_m - pattern[a].x_m, pattern[b].y_m - pattern[a].y_m});
            if (overlap <= 0) continue;
            r.largest_overlap_m = max_of(r.largest_overlap_m, overlap);
            overlaps += overlap, contacts += 1;
        }
    }
    r.mean_overlap_m = contacts > 0 ? overlaps / contacts : 0.0;
    r.solid_fraction = area / (c.elements.block_length_m * c.elements.block_height_m);
    r.bulk_density_kg_m3 = c.soil.density_kg_m3 * r.solid_fraction;
    return r;
}

}  // namespace ifedem

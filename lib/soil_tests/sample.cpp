#include "soil_tests/sample.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/step.hpp"

namespace ifedem {

Sample::Sample(const DemConstants& dem, std::vector<Disc> discs)
    : world_(make_soil_world(dem, std::move(discs))), moved_m_(dem.flat_walls.size(), 0.0) {}

void Sample::step() { step(std::vector<double>(moved_m_.size(), 0.0)); }

void Sample::step(const std::vector<double>& shift_m) {
    auto& [scene, state, work] = world_;
    bool far = false;
    for (std::size_t w = 0; w < shift_m.size(); ++w) {
        FlatWall& wall = scene.dem.flat_walls[w];
        wall.point_m += shift_m[w] * wall.normal;
        moved_m_[w] += std::fabs(shift_m[w]);
        far = far || moved_m_[w] > 0.9 * margin_m;
    }
    if (far) work.dem.rebuild_outer = true;
    if (work.dem.rebuild_outer || work.dem.refresh_inner) {
        // Every list must know all walls where they may go until the next rebuild.
        if (work.dem.rebuild_outer) std::fill(moved_m_.begin(), moved_m_.end(), 0.0);
        DemConstants advanced = scene.dem;
        for (FlatWall& wall : advanced.flat_walls) wall.point_m += margin_m * wall.normal;
        update_lists(advanced, state, work.dem);
    }
    measure_walls();
    ifedem::step(scene, state, work);
}

void Sample::measure_walls() {
    const DemConstants& k = world_.scene.dem;
    wall_force_N_.assign(k.flat_walls.size(), 0.0);
    for (const BoundaryContact& c : world_.state.wall_contacts) {
        if (c.surface >= k.flat_walls.size()) continue;
        const Disc& d = world_.state.discs.disc[world_.work.dem.position_of_id[c.disc]];
        const WallSide side = find_wall_side(k, c.surface, d);
        const BoundaryForce f = boundary_force(k.wall, k.damping_ratio, d, side.normal, side.distance_m,
                                               side.opposite_radius_m, {}, c.tangential_m, k.step_s);
        wall_force_N_[c.surface] += f.normal_N;
    }
}

void Sample::set_friction(double soil, double wall) {
    world_.scene.dem.soil.friction = soil;
    world_.scene.dem.wall.friction = wall;
}

void Sample::set_rolling(double full_chords) {
    world_.scene.dem.soil.rolling_chords = full_chords;
    world_.scene.dem.wall.rolling_chords = full_chords;
}

}  // namespace ifedem

#include "soil_tests/wall_bodies.hpp"

#include <algorithm>
#include <utility>

#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "step/step.hpp"

namespace ifedem {

WallBodies::WallBodies(const DemConstants& dem, std::vector<Disc> discs, std::vector<std::uint32_t> body)
    : world_(make_soil_world(dem, std::move(discs))), body_(std::move(body)) {
    const std::size_t bodies = std::ranges::max(body_) + 1U;
    velocity_m_s_.resize(bodies), force_N_.resize(bodies);
}

void WallBodies::add(const WallDisc& wall, std::uint32_t body) {
    world_.scene.dem.wall_discs.push_back(wall);
    body_.push_back(body);
    if (body >= velocity_m_s_.size()) velocity_m_s_.resize(body + 1U), force_N_.resize(body + 1U);
    world_.work.dem.rebuild_outer = true;
}

void WallBodies::set_velocity(std::uint32_t body, Vec2 velocity_m_s) { velocity_m_s_[body] = velocity_m_s; }

void WallBodies::set_friction(double soil, double wall) {
    world_.scene.dem.soil.friction = soil;
    world_.scene.dem.wall.friction = wall;
}

void WallBodies::step() {
    auto& [scene, state, work] = world_;
    if (moved_m_ > 0.9 * margin_m) work.dem.rebuild_outer = true;
    if (work.dem.rebuild_outer || work.dem.refresh_inner) {
        if (work.dem.rebuild_outer) moved_m_ = 0;
        DemConstants closer = scene.dem;
        for (WallDisc& wall : closer.wall_discs) wall.radius_m += margin_m;
        update_lists(closer, state, work.dem);
    }
    for (std::size_t w = 0; w < body_.size(); ++w) scene.dem.wall_discs[w].velocity_m_s = velocity_m_s_[body_[w]];
    measure();
    ifedem::step(scene, state, work);
    // With the discs, so that forces see both at the same time.
    for (WallDisc& wall : scene.dem.wall_discs) wall.centre_m += scene.dem.step_s * wall.velocity_m_s;
    double fastest = 0;
    for (const Vec2 v : velocity_m_s_) fastest = std::max(fastest, norm(v));
    moved_m_ += scene.dem.step_s * fastest;
}

void WallBodies::advance(std::int64_t steps) {
    for (std::int64_t n = 0; n < steps; ++n) step();
}

void WallBodies::measure() {
    const DemConstants& k = world_.scene.dem;
    std::ranges::fill(force_N_, Vec2{});
    for (const BoundaryContact& c : world_.state.wall_contacts) {
        const Disc& d = world_.state.discs.disc[world_.work.dem.position_of_id[c.disc]];
        const WallSide side = find_wall_side(k, c.surface, d);
        const BoundaryForce f = boundary_force(k.wall, k.damping_ratio, d, side.normal, side.distance_m,
                                               side.opposite_radius_m, side.velocity_m_s, c.tangential_m, k.step_s);
        force_N_[body_[c.surface]] -= f.force_N;
    }
}

}  // namespace ifedem

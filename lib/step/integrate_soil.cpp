#include "step/integrate_soil.hpp"

#include "step/central_difference.hpp"

namespace ifedem {

void integrate_soil(const Scene& scene, State& state, const SoilWorkspace& work) {
    const double dt = scene.dem.step_s;
    for (const SoilNode& n : work.node) {
        Vec2& v = state.soil.velocity_m_s[n.number];
        const Vec2 f = work.force_N[n.number];
        v.x = n.held_x ? 0.0 : advance_velocity(v.x, f.x, n.mass_kg, n.damping_kg_s, dt);
        v.y = n.held_y ? 0.0 : advance_velocity(v.y, f.y, n.mass_kg, n.damping_kg_s, dt);
        state.soil.position_m[n.number] += dt * v;
    }
}

}  // namespace ifedem

#include "coupling/wheel_contact.hpp"

#include <cmath>

namespace ifedem {

void add_wheel_contacts(const DemConstants& k, const WheelModel& model, State& state, DemWorkspace& dem,
                        WheelWorkspace& work, double spring_step_s) {
    dem.wheel_force.clear();
    add_surface_contacts(
        k.wheel, k.damping_ratio, {model.surface, state.wheel.position_m, state.wheel.velocity_m_s},
        {state.discs, state.pairs.inner_reference, dem.refreshes, dem.position_of_id, k.largest_radius_m},
        spring_step_s, state.wheel_contacts, work, dem.wheel_force);
}

double distance_to_wheel_m(const WheelModel& model, const WheelState& wheel, Vec2 point_m) {
    std::vector<Segment> segments;
    place_segments({model.surface, wheel.position_m, wheel.velocity_m_s}, segments);
    double least2 = 1e300;
    bool inside = false;
    for (const Segment& s : segments) {
        const double share = min_of(1.0, max_of(0.0, share_along(s, point_m)));
        const Vec2 away = point_m - (s.from_m + share * s.along_m);
        least2 = min_of(least2, dot(away, away));
        const Vec2 to = s.from_m + s.along_m;  // even–odd rule: does a ray along +x cross this segment?
        if ((s.from_m.y > point_m.y) != (to.y > point_m.y)) {
            const double x = s.from_m.x + (point_m.y - s.from_m.y) / s.along_m.y * s.along_m.x;
            if (x > point_m.x) inside = !inside;
        }
    }
    return inside ? -std::sqrt(least2) : std::sqrt(least2);
}

}  // namespace ifedem

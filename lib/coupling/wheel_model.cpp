#include "coupling/wheel_model.hpp"

#include <algorithm>

#include "core/bitmath.hpp"

namespace ifedem {
WheelModel make_wheel_model(const WheelCase& wheel) {
    WheelModel m;
    m.mesh = make_wheel_mesh(wheel);
    m.surface = make_loop(m.mesh.boundary);
    m.elements = make_elements(m.mesh.mesh, wheel_materials(wheel), wheel_widths_m(wheel), wheel.plane);
    m.body = wheel.shape == WheelShape::plate ? WheelBody::rigid : wheel.body;
    m.damping_frame = wheel.damping_frame;
    m.load_N = wheel.load_N;
    const auto& node = m.mesh.mesh.node_m;
    std::vector<char> rigid(node.size(), 0);
    for (const std::uint32_t n : m.mesh.rigid) rigid[n] = 1;
    for (std::uint32_t n = 0; n < node.size(); ++n)
        if (rigid[n] == 0) m.free_node.push_back(n);
    if (m.body != WheelBody::elastic) {
        // The unmeshed rim is a full disc of WR's density (section 3.2.2 meshes it to the hub); a plate has none.
        const double r = wheel.shape == WheelShape::plate ? 0.0 : wheel.rim_radius_m;
        m.body_mass_kg = pi * r * r * wheel_widths_m(wheel)[0] * wheel.rim.density_kg_m3;
        m.body_inertia_kg_m2 = 0.5 * m.body_mass_kg * r * r;
        for (const std::uint32_t n : m.mesh.rigid) {
            m.body_mass_kg += m.elements.mass_kg[n];
            m.body_inertia_kg_m2 += m.elements.mass_kg[n] * dot(node[n], node[n]);
        }
        m.body_damping_1_s = wheel.rim.damping_1_s;
    }
    for (const std::uint32_t n : m.mesh.boundary) m.outer_radius_m = std::max(m.outer_radius_m, norm(node[n]));
    return m;
}

WheelState place_wheel(const WheelModel& model, Vec2 hub_m) {
    WheelState w;
    w.rim.position_m = hub_m;
    for (const Vec2 n : model.mesh.mesh.node_m) w.position_m.push_back(hub_m + n);
    w.velocity_m_s.resize(w.position_m.size());
    return w;
}

double effective_radius_m(const WheelModel& model, const WheelState& wheel) {
    double least = 1e300;
    for (const std::uint32_t n : model.mesh.boundary) {
        const Vec2 r = wheel.position_m[n] - wheel.rim.position_m;
        least = std::min(least, dot(r, r));
    }
    return std::sqrt(least);
}

RigidMotion damping_frame(const WheelModel& model, const WheelState& wheel) {
    // The rigid part counts with its own c, mass and inertia, just as its elements would.
    const RigidBody& rim = wheel.rim;
    double weight = model.body_damping_1_s * model.body_mass_kg;
    RigidMotion f{weight * rim.position_m, weight * rim.velocity_m_s, 0.0};
    for (const std::uint32_t n : model.free_node) {
        const double c = model.elements.damping_kg_s[n];
        weight += c;
        f.centre_m += c * wheel.position_m[n];
        f.velocity_m_s += c * wheel.velocity_m_s[n];
    }
    if (weight <= 0) return RigidMotion{};
    f.centre_m = (1.0 / weight) * f.centre_m;
    f.velocity_m_s = (1.0 / weight) * f.velocity_m_s;
    const Vec2 arm = rim.position_m - f.centre_m;
    double inertia = model.body_damping_1_s * (model.body_inertia_kg_m2 + model.body_mass_kg * dot(arm, arm));
    double moment = model.body_damping_1_s *
                    (model.body_inertia_kg_m2 * rim.omega_rad_s + model.body_mass_kg * cross(arm, rim.velocity_m_s));
    for (const std::uint32_t n : model.free_node) {
        const double c = model.elements.damping_kg_s[n];
        const Vec2 r = wheel.position_m[n] - f.centre_m;
        inertia += c * dot(r, r);
        moment += c * cross(r, wheel.velocity_m_s[n]);
    }
    f.omega_rad_s = moment / inertia;
    return f;
}

BodyForce add_damping_forces(const WheelModel& model, const WheelState& wheel, std::vector<Vec2>& force_N) {
    BodyForce on_body;
    if (model.damping_frame == DampingFrame::absolute || model.free_node.empty()) return on_body;
    const RigidMotion f = damping_frame(model, wheel);
    for (const std::uint32_t n : model.free_node) {
        const Vec2 rigid = f.velocity_m_s + cross(f.omega_rad_s, wheel.position_m[n] - f.centre_m);
        force_N[n] -= model.elements.damping_kg_s[n] * (wheel.velocity_m_s[n] - rigid);
    }
    const RigidBody& rim = wheel.rim;
    const Vec2 rigid = f.velocity_m_s + cross(f.omega_rad_s, rim.position_m - f.centre_m);
    on_body.force_N -= model.body_damping_1_s * model.body_mass_kg * (rim.velocity_m_s - rigid);
    on_body.moment_Nm -= model.body_damping_1_s * model.body_inertia_kg_m2 * (rim.omega_rad_s - f.omega_rad_s);
    return on_body;
}

Vec2 momentum_Ns(const WheelModel& model, const WheelState& wheel) {
    Vec2 p = model.body_mass_kg * wheel.rim.velocity_m_s;
    for (const std::uint32_t n : model.free_node) p += model.elements.mass_kg[n] * wheel.velocity_m_s[n];
    return p;
}

}  // namespace ifedem

#include "traction/control.hpp"

#include <algorithm>

namespace ifedem {

double advance_controlled(ControlScheme scheme, const GainsCase& gains, const ControlledMass& body, double target,
                          double step_s, PidState& pid) {
    const double dt = step_s;
    const double inertia = body.mass / dt + 0.5 * body.damping;
    const double drive = (body.mass / dt - 0.5 * body.damping) * body.velocity + body.force;
    double velocity = 0, error = 0;
    if (scheme == ControlScheme::semi_implicit) {
        // u = G e⁺ + K_i S − K_d e_old/Δt with e⁺ = target − x − Δt v⁺ and G = K_p + K_i Δt + K_d/Δt.
        const double gain = gains.proportional + gains.integral * dt + gains.derivative / dt;
        const double rest = gains.integral * pid.error_sum - gains.derivative / dt * pid.error_old;
        velocity = (drive + gain * (target - body.position) + rest) / (inertia + gain * dt);
        error = target - body.position - dt * velocity;
        pid.output = gain * error + rest;
    } else if (scheme == ControlScheme::prescribed) {
        velocity = (target - body.position) / dt;
        pid.output = inertia * velocity - drive;
    } else {
        error = pid.target - body.position;
        pid.output = gains.proportional * error + gains.integral * (pid.error_sum + error * dt) +
                     gains.derivative * (error - pid.error_old) / dt;
        velocity = (drive + pid.output) / inertia;
    }
    pid.error_sum += error * dt;
    pid.error_old = error;
    pid.target = target;
    return velocity;
}

double commanded_omega_rad_s(const TravelCase& travel, const WheelCase& wheel) {
    if (wheel.shape == WheelShape::plate) return 0;
    const double radius =
        travel.slip_radius == SlipRadius::tread ? wheel.tread_radius_m : wheel.tread_radius_m + wheel.lug_height_m;
    if (travel.speed_of == SpeedOf::tread) return travel.speed_m_s / radius;
    return travel.speed_m_s / (radius * (1.0 - travel.slip_percent / 100.0));
}

TravelTarget travel_target(const TravelCase& travel, const WheelCase& wheel, double time_s) {
    const double share = travel.acceleration_time_s > 0 ? std::min(1.0, time_s / travel.acceleration_time_s) : 1.0;
    return {share * travel_speed_m_s(travel), share * commanded_omega_rad_s(travel, wheel)};
}

}  // namespace ifedem

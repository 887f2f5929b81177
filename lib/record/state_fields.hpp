#pragma once
#include <algorithm>
#include <string_view>

#include "model/state.hpp"

namespace ifedem {

/// Names of an aggregate's doubles, each ending in its unit, for whoever opens the file with other tools. An aggregate
/// without names here is stored just as well.
template <class T>
inline constexpr const char* fields_of = "";
template <>
inline constexpr const char* fields_of<Vec2> = "x,y";
template <>
inline constexpr const char* fields_of<Disc> = "x_m,y_m,vx_m_s,vy_m_s,omega_rad_s,radius_m,inverse_mass_1_kg,angle_rad";
template <>
inline constexpr const char* fields_of<Reference> = "x_m,y_m,skin_m";
template <>
inline constexpr const char* fields_of<DiscAcceleration> = "x_m_s2,y_m_s2,angular_rad_s2,unused";
template <>
inline constexpr const char* fields_of<BoundaryContact> = "disc,surface,tangential_m";
template <>
inline constexpr const char* fields_of<RigidBody> = "x_m,y_m,vx_m_s,vy_m_s,angle_rad,omega_rad_s";
template <>
inline constexpr const char* fields_of<PidState> = "error_sum,error_old,output,target";
template <>
inline constexpr const char* fields_of<EnergyLedger> =
    "work_torque_J,work_drawbar_J,lost_normal_J,lost_tangential_J,lost_rolling_J,"
    "lost_wheel_J";
template <>
inline constexpr const char* fields_of<SeriesSums> =
    "steps,drawbar_N,torque_Nm,fx_positive_N,fx_negative_N,fy_N,effective_radius_m,hub_speed_m_s,"
    "omega_clockwise_rad_s";
template <>
inline constexpr const char* fields_of<SegmentSum> =
    "radial_N,circumferential_N,normal_N,tangential_N,fx_N,fy_N,moment_Nm,contacts";
template <>
inline constexpr const char* fields_of<StressBlock> =
    "steps,drawbar_N,torque_Nm,effective_radius_m,impulse_x_Ns,impulse_y_Ns,spin_Nms";

template <class T>
constexpr bool fields_are_complete() {
    const std::string_view fields = fields_of<T>;
    return fields.empty() ||
           (static_cast<std::size_t>(std::ranges::count(fields, ',')) + 1) * sizeof(double) == sizeof(T);
}

}  // namespace ifedem

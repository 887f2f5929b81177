#pragma once

namespace ifedem {

/// Eq 2.8 for one velocity component: m (v⁺ − v)/Δt + c (v⁺ + v)/2 = F.
[[nodiscard]] inline double advance_velocity(double velocity_m_s, double force_N, double mass_kg, double damping_kg_s,
                                             double step_s) {
    const double half = 0.5 * step_s * damping_kg_s / mass_kg;
    return ((1.0 - half) * velocity_m_s + step_s * force_N / mass_kg) / (1.0 + half);
}

}  // namespace ifedem

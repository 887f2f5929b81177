#pragma once
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "check/run.hpp"

namespace ifedem {

/// An interval of travel distance, from the place where the travel stage began.
struct Window {
    double from_m = 0;
    double to_m = 0;
};

/// 40–80 cm for slips up to 60 % and 60–80 cm above (section 3.3.1).
[[nodiscard]] Window averaging_window(double slip_percent);

/// That, or the places between which the case averages contact stress (chapter 4: 0.9–1.2 m from the bin's left edge).
[[nodiscard]] Window averaging_window(const Case& c);

/// That, or the same share of a shorter travel: what variants are compared over.
[[nodiscard]] Window compared_window(const Case& c);

/// Travel while one pair of lugs passes: (2πr/pairs)(1 − i), with the radius r that the commanded slip uses; 0 for a
/// smooth tread.
[[nodiscard]] double lug_pair_pitch_m(const Case& c);

/// The last whole number of pitches in the window; its beginning moves, so that what is left of the controllers'
/// transient is cut off first. Pitch 0 leaves the window whole. Throws Error(bad_input) if not one pitch fits.
[[nodiscard]] Window trim(const Window& window, double pitch_m);

/// ∫ y dt / ∫ dt between two times, by the trapezoidal rule with interpolated ends.
[[nodiscard]] double mean_between(std::span<const double> time_s, std::span<const double> y, double from_s,
                                  double to_s);

/// Window means of one run. Signs as in the series: H + R = P_d, R < 0, z < 0.
struct RunMetrics {
    Window window;                               ///< as used, after trimming
    double gross_tractive_effort_N = 0;          ///< H = ⟨T⟩/⟨r_e⟩
    double gross_tractive_effort_instant_N = 0;  ///< ⟨T/r_e⟩
    double gross_tractive_effort_minimum_N = 0;  ///< ⟨T⟩/min r_e
    double net_traction_N = 0;                   ///< P_d = −⟨P⟩
    double motion_resistance_N = 0;              ///< R = P_d − H
    double direct_thrust_N = 0;                  ///< ⟨Σ F_x > 0⟩ over wheel segments (Eq 2.13)
    double direct_resistance_N = 0;              ///< ⟨Σ F_x < 0⟩
    double vertical_force_N = 0;
    double torque_Nm = 0;
    double sinkage_cm = 0;
    double effective_radius_m = 0;
    double deflection_mm = 0;                ///< tread radius − ⟨r_e⟩ (section 3.3.2)
    double measured_slip_percent = 0;        ///< 1 − ⟨V⟩/(⟨r_e⟩ ω) (Eq 3.8), ω as commanded
    double horizontal_imbalance_N = 0;       ///< ⟨Σ F_x⟩ − ⟨P_d⟩: 0 for a wheel that does not accelerate
    double vertical_inertia_N = 0;           ///< growth of the wheel's vertical momentum / time
    double vertical_imbalance_N = 0;         ///< ⟨Σ F_y⟩ − W − inertia: 0 for every window
    double bounce_N = 0, bounce_Hz = 0;      ///< strongest oscillation of Σ F_y, 1–25 Hz
    double drawbar_deviation_N = 0;          ///< standard deviation of P within the window
    std::map<std::string, double> energy_J;  ///< growth of each column of the series that ends in _J, over the window
};

/// Throws Error(bad_input) if the run did not travel to the end of the window.
[[nodiscard]] RunMetrics measure(const Run& run, const Window& window);

/// All NaN: a run that says nothing.
[[nodiscard]] RunMetrics unknown_metrics();

/// Metrics by name, as claims and tables use them.
struct MetricInfo {
    std::string_view name;
    std::string_view unit;
    std::string_view symbol;
    double RunMetrics::*member;
};
[[nodiscard]] std::span<const MetricInfo> metric_table();

/// nullptr if there is no such metric.
[[nodiscard]] const MetricInfo* find_metric(std::string_view name);

}  // namespace ifedem

#include "check/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/bounce.hpp"
#include "check/statistics.hpp"
#include "core/bitmath.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

// A hub that the drawbar controller holds lags its target by a few millimetres; a run that stops this little short of
// the window's end has travelled it. What is missing is cut off, not invented.
constexpr double end_slack_m = 0.02;

const std::vector<double>& column(const Run& run, const std::string& name) {
    const auto found = run.travel.find(name);
    if (found == run.travel.end() || found->second.size() < 2)
        fail_input(
            fmt::format("{}/series.csv: column {} holds no travel (the run did not reach it). Run or resume the case?",
                        run.directory, name));
    return found->second;
}

/// When the wheel first was at this distance, interpolated.
double time_at(std::span<const double> time_s, std::span<const double> x_m, double distance_m) {
    for (std::size_t k = 1; k < x_m.size(); ++k) {
        const double before = x_m[k - 1] - x_m[0];
        const double after = x_m[k] - x_m[0];
        if (after < distance_m || before > distance_m || after <= before) continue;
        return time_s[k - 1] + (time_s[k] - time_s[k - 1]) * (distance_m - before) / (after - before);
    }
    return time_s.back();
}

double at_time(std::span<const double> time_s, std::span<const double> y, double t) {
    const auto above = std::lower_bound(time_s.begin(), time_s.end(), t);
    if (above == time_s.begin()) return y.front();
    if (above == time_s.end()) return y.back();
    const auto k = static_cast<std::size_t>(above - time_s.begin());
    return y[k - 1] + (y[k] - y[k - 1]) * (t - time_s[k - 1]) / (time_s[k] - time_s[k - 1]);
}

double slip_radius_m(const Case& c) {
    return c.wheel.tread_radius_m + (c.travel.slip_radius == SlipRadius::lug_tip ? c.wheel.lug_height_m : 0);
}

}  // namespace

Window averaging_window(double slip_percent) {
    return slip_percent <= 60.0 + 1e-9 ? Window{0.4, 0.8} : Window{0.6, 0.8};
}

Window averaging_window(const Case& c) {
    if (c.record.stress_segments == 0) return averaging_window(c.travel.slip_percent);
    return {c.record.stress_from_x_m - c.travel.start_x_m, c.record.stress_to_x_m - c.travel.start_x_m};
}

Window compared_window(const Case& c) {
    const Window whole = averaging_window(c);
    const double share = std::min(1.0, c.travel.distance_m / whole.to_m);
    return {share * whole.from_m, share * whole.to_m};
}

double lug_pair_pitch_m(const Case& c) {
    if (c.wheel.lug_pairs == 0) return 0;
    return 2 * pi * slip_radius_m(c) / static_cast<double>(c.wheel.lug_pairs) * (1 - c.travel.slip_percent / 100);
}

Window trim(const Window& window, double pitch_m) {
    if (pitch_m == 0) return window;
    // A hair of slack, so that a window of exactly n pitches keeps them all in spite of rounding.
    const double pitches = std::floor((window.to_m - window.from_m) / pitch_m * (1 + 1e-12));
    if (!(pitches >= 1))
        fail_input(fmt::format("Not one lug-pair pitch ({:.3g} m) fits the window {:g}–{:g} m. Widen the window?",
                               pitch_m, window.from_m, window.to_m));
    return {window.to_m - pitches * pitch_m, window.to_m};
}

double mean_between(std::span<const double> time_s, std::span<const double> y, double from_s, double to_s) {
    double t = from_s;
    double value = at_time(time_s, y, from_s);
    double integral = 0;
    for (std::size_t k = 0; k < time_s.size() && time_s[k] < to_s; ++k) {
        if (time_s[k] <= from_s) continue;
        integral += 0.5 * (value + y[k]) * (time_s[k] - t);
        t = time_s[k];
        value = y[k];
    }
    integral += 0.5 * (value + at_time(time_s, y, to_s)) * (to_s - t);
    return integral / (to_s - from_s);
}

namespace {

/// A run's columns over an averaging window.
struct Averages {
    const Run& run;
    const std::vector<double>& time;
    double from_s = 0, to_s = 0;

    [[nodiscard]] double mean_of(const std::vector<double>& y) const { return mean_between(time, y, from_s, to_s); }
    [[nodiscard]] double mean_of(const char* name) const { return mean_of(column(run, name)); }
    [[nodiscard]] double change_of(const std::vector<double>& y) const {
        return at_time(time, y, to_s) - at_time(time, y, from_s);
    }
};

void measure_forces(const Averages& w, RunMetrics& m) {
    const auto& torque = column(w.run, "torque_Nm");
    const auto& radius = column(w.run, "effective_radius_m");
    const auto& pull = column(w.run, "net_traction_N");
    std::vector<double> instant(torque.size()), pull_squared(torque.size());
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < torque.size(); ++k) {
        instant[k] = torque[k] / radius[k];
        pull_squared[k] = pull[k] * pull[k];
        if (w.time[k] >= w.from_s && w.time[k] <= w.to_s) smallest = std::min(smallest, radius[k]);
    }
    m.torque_Nm = w.mean_of(torque);
    m.effective_radius_m = w.mean_of(radius);
    m.gross_tractive_effort_N = m.torque_Nm / m.effective_radius_m;
    m.gross_tractive_effort_instant_N = w.mean_of(instant);
    m.gross_tractive_effort_minimum_N = m.torque_Nm / smallest;
    m.net_traction_N = w.mean_of(pull);
    m.motion_resistance_N = m.net_traction_N - m.gross_tractive_effort_N;
    m.drawbar_deviation_N = std::sqrt(std::max(0.0, w.mean_of(pull_squared) - m.net_traction_N * m.net_traction_N));
    m.direct_thrust_N = w.mean_of("fx_positive_N");
    m.direct_resistance_N = w.mean_of("fx_negative_N");
    m.vertical_force_N = w.mean_of("vertical_force_N");
}

void measure_motion(const Averages& w, RunMetrics& m) {
    m.sinkage_cm = 100 * w.mean_of("sinkage_m");
    m.deflection_mm = 1e3 * (w.run.c.wheel.tread_radius_m - m.effective_radius_m);
    const double tread = m.effective_radius_m * w.mean_of("commanded_omega_rad_s");
    m.measured_slip_percent = 100 * (1 - w.mean_of("hub_speed_m_s") / tread);
    const auto& vertical = column(w.run, "vertical_force_N");
    const auto index = [&](double t) { return std::lower_bound(w.time.begin(), w.time.end(), t) - w.time.begin(); };
    const std::span<const double> within(vertical.begin() + index(w.from_s), vertical.begin() + index(w.to_s));
    const double step = (w.time.back() - w.time.front()) / static_cast<double>(w.time.size() - 1);
    const Bounce bounce = find_bounce(within, step);
    m.bounce_N = bounce.amplitude_N, m.bounce_Hz = bounce.frequency_Hz;
}

void measure_balances(const Averages& w, RunMetrics& m) {
    m.horizontal_imbalance_N = m.direct_thrust_N + m.direct_resistance_N - m.net_traction_N;
    m.vertical_inertia_N = w.change_of(column(w.run, "vertical_momentum_Ns")) / (w.to_s - w.from_s);
    m.vertical_imbalance_N = m.vertical_force_N - w.run.c.wheel.load_N - m.vertical_inertia_N;
    for (const auto& [name, values] : w.run.travel)
        if (name.ends_with("_J")) m.energy_J[name] = w.change_of(values);
}

}  // namespace

RunMetrics measure(const Run& run, const Window& window) {
    const auto& time = column(run, "time_s");
    const auto& x = column(run, "wheel_x_m");
    const double reached = *std::max_element(x.begin(), x.end()) - x.front();
    if (reached < window.to_m - end_slack_m)
        fail_input(
            fmt::format("{}: the wheel travelled {:.3f} m of the {:.2f} m that the window needs. Resume or rerun it?",
                        run.directory, reached, window.to_m));
    RunMetrics m;
    m.window = {window.from_m, std::min(window.to_m, reached)};
    if (run.c.wheel.lug_pairs > 0) m.window = trim(m.window, lug_pair_pitch_m(run.c));  // a smooth tread has no pitch
    const Averages averages{run, time, time_at(time, x, m.window.from_m), time_at(time, x, m.window.to_m)};
    measure_forces(averages, m);
    measure_motion(averages, m);
    measure_balances(averages, m);
    return m;
}

RunMetrics unknown_metrics() {
    RunMetrics m;
    for (const auto& info : metric_table()) m.*info.member = std::numeric_limits<double>::quiet_NaN();
    return m;
}

std::span<const MetricInfo> metric_table() {
    static constexpr std::array<MetricInfo, 19> table{{
        {"gross_tractive_effort_N", "N", "H", &RunMetrics::gross_tractive_effort_N},
        {"gross_tractive_effort_instant_N", "N", "⟨T/r_e⟩", &RunMetrics::gross_tractive_effort_instant_N},
        {"gross_tractive_effort_minimum_N", "N", "⟨T⟩/min r_e", &RunMetrics::gross_tractive_effort_minimum_N},
        {"net_traction_N", "N", "P_d", &RunMetrics::net_traction_N},
        {"motion_resistance_N", "N", "R", &RunMetrics::motion_resistance_N},
        {"direct_thrust_N", "N", "ΣF_x⁺", &RunMetrics::direct_thrust_N},
        {"direct_resistance_N", "N", "ΣF_x⁻", &RunMetrics::direct_resistance_N},
        {"vertical_force_N", "N", "ΣF_y", &RunMetrics::vertical_force_N},
        {"torque_Nm", "N m", "T", &RunMetrics::torque_Nm},
        {"sinkage_cm", "cm", "z", &RunMetrics::sinkage_cm},
        {"effective_radius_m", "m", "r_e", &RunMetrics::effective_radius_m},
        {"deflection_mm", "mm", "δ", &RunMetrics::deflection_mm},
        {"measured_slip_percent", "%", "i", &RunMetrics::measured_slip_percent},
        {"horizontal_imbalance_N", "N", "ΣF_x − P_d", &RunMetrics::horizontal_imbalance_N},
        {"vertical_inertia_N", "N", "ṗ_y", &RunMetrics::vertical_inertia_N},
        {"vertical_imbalance_N", "N", "ΣF_y − W − ṗ_y", &RunMetrics::vertical_imbalance_N},
        {"bounce_N", "N", "amplitude of ΣF_y", &RunMetrics::bounce_N},
        {"bounce_Hz", "Hz", "its frequency", &RunMetrics::bounce_Hz},
        {"drawbar_deviation_N", "N", "s of P", &RunMetrics::drawbar_deviation_N},
    }};
    return table;
}

const MetricInfo* find_metric(std::string_view name) {
    for (const auto& info : metric_table())
        if (info.name == name) return &info;
    return nullptr;
}

}  // namespace ifedem

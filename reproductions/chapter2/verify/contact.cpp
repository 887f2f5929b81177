// Eqs 2.17 and 2.18 with Coulomb's limit: restitution, friction, rolling, statics, Chung & Ooi's cases.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "small_cases.hpp"
#include "support/collisions.hpp"
#include "support/disc_on_plane.hpp"
#include "support/squeezed_pair.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;
constexpr std::array contact_ends{ContactEnd::attraction, ContactEnd::no_attraction};
const char* name_of(ContactEnd end) { return end == ContactEnd::attraction ? "overlap" : "force"; }

/// Mean of 64 collisions at three steps, without the errors of first and second order in the step.
struct Limit {
    double restitution = 0, duration = 0;
};
Limit collide_in_the_limit(double zeta, ContactEnd end) {
    std::array<Measured, 3> m;
    for (std::size_t k = 0; k < 3; ++k)
        m[k] = collide(zeta, end, Integrator::symplectic_euler, 0.01 / (1 << k), Entry::spread);
    const auto extrapolate = [](double a, double b, double c) { return (4 * (2 * c - b) - (2 * b - a)) / 3; };
    return {extrapolate(m[0].mean_restitution, m[1].mean_restitution, m[2].mean_restitution),
            extrapolate(m[0].mean_duration_omega, m[1].mean_duration_omega, m[2].mean_duration_omega)};
}

void measure_restitution(Output& out) {
    std::vector<std::vector<std::string>> rows;
    double worst_duration = 0;
    for (const ContactEnd end : contact_ends) {
        for (const double zeta : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7}) {
            const Limit m = collide_in_the_limit(zeta, end);
            const Impact closed = closed_form(zeta, end);
            worst_duration = std::fmax(worst_duration, std::fabs(m.duration / closed.duration_omega - 1));
            out.add(fmt::format("restitution_{}_{:g}", name_of(end), zeta), m.restitution, "-",
                    "limit of steps 1, 0.5, 0.25 % of the contact");
            rows.push_back({"measured", name_of(end), number(zeta), number(m.restitution), number(m.duration)});
        }
        for (double zeta = 0.005; zeta < 0.7051; zeta += 0.01) {
            const Impact closed = closed_form(zeta, end);
            rows.push_back(
                {"closed", name_of(end), number(zeta), number(closed.restitution), number(closed.duration_omega)});
        }
    }
    out.write_table("restitution.csv", "kind,end,zeta,restitution,duration_omega", rows);
    out.add("contact_duration_worst", worst_duration, "-", "relative error of t ω0, worst of twelve");
}

void measure_chung_ooi(Output& out) {
    double worst = 0;
    std::vector<std::vector<std::string>> rows;
    for (const ContactEnd end : contact_ends) {
        for (const double wanted : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
            const double got = rebound_over_impact(wanted, end);
            worst = std::fmax(worst, std::fabs(got / wanted - 1));
        }
    }
    out.add("chung_ooi_3_worst", worst, "-", "relative error of rebound over impact, worst of sixteen");
    double friction_error = 0;
    for (const double degrees : {30.0, 35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
        const ObliqueImpact m = strike_wall(degrees);
        rows.push_back({number(degrees), number(m.tangential), number(m.closed_tangential), number(m.spin_rad_s),
                        number(m.closed_spin_rad_s)});
        const double impulse = m.coming_m_s * (1 - m.tangential),
                     normal = (1 + m.normal) * ObliqueImpact::speed * std::cos(degrees * pi / 180);
        friction_error = std::fmax(friction_error, std::fabs(impulse / normal / ObliqueImpact::friction - 1));
        if (degrees < 40) continue;
        out.add(fmt::format("chung_ooi_4_tangential_{:g}", degrees), m.tangential, "-", "rebound over impact");
        out.add(fmt::format("chung_ooi_4_spin_{:g}", degrees), m.spin_rad_s, "rad/s");
    }
    out.write_table("case4.csv", "angle_deg,tangential,closed_tangential,spin_rad_s,closed_spin_rad_s", rows);
    out.add("coulomb_impulse_ratio", friction_error, "-",
            "tangential over normal impulse against µ, relative, worst of eight sliding impacts");
    double spins = 0, speeds = 0;
    for (const double omega : {20.0, 100.0, 500.0, 2000.0}) {
        const SpinningPair m = collide_spinning(omega);
        spins = std::fmax(spins, std::fabs(m.omega_a_rad_s - m.omega_b_rad_s) / omega);
        speeds = std::fmax(speeds, m.momentum_per_mass_m_s / SpinningPair::approach_m_s);
    }
    out.add("chung_ooi_7_spins", spins, "-", "difference of the two spins over the first, worst of four");
    out.add("chung_ooi_7_momentum", speeds, "-", "sum of the two velocities over the approach");
}

void measure_friction(Output& out) {
    constexpr double slope = pi / 6;
    World rolling = make_disc_on_plane(slope, 2 * std::tan(slope) / 3, 0);
    out.add("incline_rolling", run_down(rolling, slope, 0.1).along, "m/s2", "30°, µ twice tan θ/3");
    std::vector<std::vector<std::string>> rows;
    for (double share = 0.1; share < 2.05; share += 0.1) {
        World w = make_disc_on_plane(slope, share * std::tan(slope) / 3, 0);
        const Acceleration a = run_down(w, slope, 0.1);
        rows.push_back({number(share), number(a.along), number(a.clockwise * disc_radius)});
    }
    out.write_table("incline.csv", "friction_share,along_m_s2,spin_times_radius_m_s2", rows);
    const Launch launch = launch_sliding(0.3);
    out.add("launch_time", launch.time_s, "s", "0.3 m/s, µ 0.3, on a flat");
    out.add("launch_speed_share", launch.speed_share, "-", "of the first speed, once rolling");
    out.add("block_distance", 1e3 * stop_block(0.4, 0.3).x_m, "mm", "0.3 m/s, µ 0.4; a disc that may not turn");
    out.add("column_overlaps", settle_column(10).sum, "-", "overlaps of ten discs in m g/K_n");
}

/// tan θ at which a disc that already rolls keeps its speed, by bisection, and α b/r, with b the half chord.
struct NeutralSlope {
    double measured = 0, closed = 0;
};
NeutralSlope find_neutral_slope(double half_chords) {
    const auto closed = [&](double slope) { return 0.5 * half_chords * chord_m(slope) / disc_radius; };
    double low = 0, high = 4 * closed(0);
    for (int k = 0; k < 24; ++k) {
        const double middle = 0.5 * (low + high), slope = std::atan(middle);
        World w = make_disc_on_plane(slope, 0.6, half_chords, {0.05, -0.05 / disc_radius});
        (run_down(w, slope, 0.02).along < 0 ? low : high) = middle;
    }
    return {low, closed(std::atan(low))};
}

void measure_rolling(Output& out) {
    std::vector<std::vector<std::string>> rows;
    for (const double half_chords : {0.5, 1.0, 2.0, 4.0, 6.0, 8.0}) {
        const NeutralSlope slope = find_neutral_slope(half_chords);
        rows.push_back({number(half_chords), number(slope.closed), number(slope.measured)});
        if (half_chords == 2)
            out.add("rolling_neutral_slope", slope.measured / slope.closed, "-", "tan θ over α b/r, full chord");
    }
    out.write_table("neutral_slope.csv", "alpha,closed,measured", rows);
    const SpinDown limit = spin_down(RollingScheme::limit), sign = spin_down(RollingScheme::sign);
    out.add("rolling_half_way", limit.half_way_share, "-", "of the first ω, at half of the closed stopping time");
    out.add("rolling_limit_rest", limit.largest_after_rad_s, "rad/s", "largest |ω| in 1000 steps after the stop");
    out.add("rolling_sign_reversals", sign.reversals, "-",
            "in 1000 steps after the stop, where the sign of Eq 2.18 is taken at each step");
}

/// Largest stable step of two discs held together, over the closed form, by bisection. 100 steps tell 10⁻³ of it.
template <class Make>
double measured_pair_limit(Make&& make, double closed, double Disc::*speed, double kick) {
    double low = 0.9, high = 1.1;
    for (int k = 0; k < 16; ++k) {
        const double middle = 0.5 * (low + high);
        (largest_amplification(make(middle * closed), speed, kick) < 100 ? low : high) = middle;
    }
    return low;
}

void measure_step_limits(Output& out) {
    const double normal = 2 / std::sqrt((2 * stiffness_N_m + soft_N_m) / pair_mass);
    out.add("pair_limit_normal",
            measured_pair_limit([](double dt) { return make_squeezed_pair(0, stiffness_N_m / 4, dt); }, normal,
                                &Disc::vx_m_s, 1e-8),
            "-", "over 2/√(2 K_n/m)");
    out.add("pair_limit_tangential",
            measured_pair_limit([](double dt) { return make_squeezed_pair(0, stiffness_N_m, dt); },
                                2 / std::sqrt(6 * stiffness_N_m / pair_mass), &Disc::omega_rad_s, 1e-6),
            "-", "sliding and spinning, over 2/√(6 K_s/m)");
}

}  // namespace

void measure_contact(Output& out, Effort) {
    measure_restitution(out);
    measure_chung_ooi(out);
    measure_friction(out);
    measure_rolling(out);
    measure_step_limits(out);
    draw_small_cases(out);
}

}  // namespace ifedem::chapter2

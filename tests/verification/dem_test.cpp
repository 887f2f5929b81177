// Discs against closed forms: collisions, friction, rolling, statics, conservation, step limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "dem/forces.hpp"
#include "dem/neighbour_lists.hpp"
#include "dem/threads.hpp"
#include "step/integrate_discs.hpp"
#include "support/collisions.hpp"
#include "support/disc_on_plane.hpp"
#include "support/squeezed_pair.hpp"

namespace ifedem {
namespace {

using namespace scene;
constexpr double g = earth_gravity_m_s2;

TEST(Collision, closed_forms_are_those_of_the_tables) {
    // e and t·ω0 as tabulated from an independent integration; half a unit of their last digit.
    const double table[6][5] = {
        {0.05, 0.854468, 3.14553, 0.858758, 3.04536}, {0.1, 0.729248, 3.15742, 0.744079, 2.95608},
        {0.2, 0.526621, 3.20637, 0.571740, 2.79535},  {0.3, 0.372326, 3.29328, 0.450975, 2.65447},
        {0.5, 0.163034, 3.62760, 0.298436, 2.41840},  {0.7, 0.045988, 4.39911, 0.210285, 2.22756}};
    for (const auto& row : table) {
        const Impact pull = closed_form(row[0], ContactEnd::attraction),
                     none = closed_form(row[0], ContactEnd::no_attraction);
        EXPECT_NEAR(pull.restitution, row[1], 0.51e-6);
        EXPECT_NEAR(pull.duration_omega, row[2], 0.51e-5);
        EXPECT_NEAR(none.restitution, row[3], 0.51e-6);
        EXPECT_NEAR(none.duration_omega, row[4], 0.51e-5);
    }
}

class Restitution : public testing::TestWithParam<std::tuple<Integrator, ContactEnd>> {};

TEST_P(Restitution, converges_to_the_closed_form) {
    const auto [integrator, end] = GetParam();
    const bool symplectic = integrator == Integrator::symplectic_euler, pulls = end == ContactEnd::attraction;
    std::printf("%s, %s: relative errors of e at 1, 0.5, 0.25 %% of the contact time\n", name_of(integrator),
                pulls ? "attraction" : "no attraction");
    std::printf("   zeta  contact begins at a step    order  worst of 64 entries      mean extrapolated: e, t\n");
    for (const double zeta : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7}) {
        const Impact exact = closed_form(zeta, end);
        std::array<Measured, 3> m;
        std::array<double, 3> error{};
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = collide(zeta, end, integrator, 0.01 / (1 << k), Entry::spread);
            error[k] =
                collide(zeta, end, integrator, 0.01 / (1 << k), Entry::at_a_step).mean_restitution / exact.restitution -
                1;
        }
        const double order = std::log2((error[0] - error[1]) / (error[1] - error[2]));
        // Symplectic: errors of order 1 and 2 removed; modified Euler: of order 2.
        const auto extrapolate = [&](double a, double b, double c) {
            return symplectic ? (4 * (2 * c - b) - (2 * b - a)) / 3 : c + (c - b) / 3;
        };
        const double e = extrapolate(m[0].mean_restitution, m[1].mean_restitution, m[2].mean_restitution);
        const double t = extrapolate(m[0].mean_duration_omega, m[1].mean_duration_omega, m[2].mean_duration_omega);
        std::printf("   %4.2f  %+.1e %+.1e %+.1e  %5.2f  %.1e %.1e %.1e  %+.1e %+.1e\n", zeta, error[0], error[1],
                    error[2], order, m[0].worst_error, m[1].worst_error, m[2].worst_error, e / exact.restitution - 1,
                    t / exact.duration_omega - 1);
        EXPECT_NEAR(e / exact.restitution, 1, 1e-3) << "zeta " << zeta;
        EXPECT_NEAR(t / exact.duration_omega, 1, 1e-3) << "zeta " << zeta;
        // Where the dashpot's pull jumps to nothing at the end too, one step more or less hides the order.
        if (!pulls) {
            EXPECT_NEAR(order, symplectic ? 1 : 2, 0.25) << "zeta " << zeta;
        }
        // The worst entry is of first order whatever the scheme: the dashpot's force jumps where the contact begins.
        EXPECT_LT(m[2].worst_error, 0.6 * m[0].worst_error) << "zeta " << zeta;
    }
}

INSTANTIATE_TEST_SUITE_P(AllIntegrators, Restitution,
                         testing::Combine(testing::Values(Integrator::symplectic_euler, Integrator::modified_euler_one,
                                                          Integrator::modified_euler_two),
                                          testing::Values(ContactEnd::no_attraction, ContactEnd::attraction)));

// Chung & Ooi 2011, test 3: what rebounds from a wall is e times what arrives, here with e put in through ζ.
TEST(ChungOoi, case_3_rebound_over_impact_is_the_restitution) {
    for (const ContactEnd end : {ContactEnd::no_attraction, ContactEnd::attraction}) {
        for (const double wanted : {0.3, 0.4, 0.6, 0.8, 1.0}) {
            const double mean = rebound_over_impact(wanted, end);
            std::printf("case 3: wanted e %.2f (zeta %.4f, %s) measured %.5f\n", wanted,
                        find_damping_ratio(wanted, end), end == ContactEnd::attraction ? "attraction" : "no attraction",
                        mean);
            EXPECT_NEAR(mean / wanted, 1, 2e-3);  // the scheme's first-order error at 0.1 % of the contact, ζ ≤ 0.5
        }
    }
}

// Test 4, gross sliding: exact in any number of steps, but for the arm, shorter than r by up to 2.5e-4 r.
TEST(ChungOoi, case_4_gross_sliding_impact) {
    std::printf("case 4: angle  e_t  closed  omega'  closed\n");
    for (const double degrees : {40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
        const ObliqueImpact m = strike_wall(degrees);
        const double angle = degrees * pi / 180;
        std::printf("        %4.0f  %.5f %.5f  %8.2f %8.2f\n", degrees, m.tangential, m.closed_tangential, m.spin_rad_s,
                    m.closed_spin_rad_s);
        EXPECT_NEAR(m.normal, ObliqueImpact::restitution, 1e-4);
        EXPECT_NEAR(m.tangential * m.coming_m_s,
                    m.coming_m_s - ObliqueImpact::friction * (1 + m.normal) * ObliqueImpact::speed * std::cos(angle),
                    1e-12 * ObliqueImpact::speed);
        EXPECT_NEAR(m.tangential, m.closed_tangential, 2e-5);
        EXPECT_NEAR(m.spin_rad_s / m.closed_spin_rad_s, 1, 3e-4);
    }
}

// Test 7.
TEST(ChungOoi, case_7_equal_spins_stay_equal) {
    for (const double omega : {0.0, 20.0, 100.0, 500.0, 2000.0}) {
        const SpinningPair m = collide_spinning(omega);
        std::printf("case 7: omega %6.0f -> %10.4f and %10.4f rad/s, tangential speed %+.6f and %+.6f m/s\n", omega,
                    m.omega_a_rad_s, m.omega_b_rad_s, m.tangential_a_m_s, m.tangential_b_m_s);
        EXPECT_NEAR(m.omega_a_rad_s, m.omega_b_rad_s, 1e-12 * omega);
        EXPECT_NEAR(m.momentum_per_mass_m_s, 0, 1e-15);
        const double slid = SpinningPair::friction * (1 + m.restitution) *
                            SpinningPair::approach_m_s;  // friction impulse / m if it slides on
        if (omega == 0) {
            EXPECT_NEAR(m.tangential_a_m_s, 0, 1e-15);
        }
        // a's side facing b moves to +t, so friction pushes a to −t. The normal turns while they slide.
        if (omega >= 500) {
            EXPECT_NEAR(m.tangential_a_m_s, -slid, 0.02 * slid);
            EXPECT_NEAR(omega - m.omega_a_rad_s, 2 * slid / SpinningPair::radius,
                        0.02 * 2 * slid / SpinningPair::radius);
        }
    }
}

// ---- One disc on a plane: friction and rolling --------------------------------------------------------------------

TEST(Friction, launched_sliding_ends_rolling) {
    for (const double friction : {0.1, 0.3, 0.6}) {
        const Launch m = launch_sliding(friction);
        const double time = Launch::speed_m_s / (3 * friction * g);
        std::printf("launch, mu %.1f: rolls after %.6f s (closed %.6f), v/v0 %.7f, slip %.1e m/s\n", friction, m.time_s,
                    time, m.speed_share, m.slip_m_s);
        EXPECT_NEAR(m.time_s, time, 2 * plane_step + rigid_tolerance * time);
        EXPECT_NEAR(m.speed_share, 2.0 / 3, rigid_tolerance);
        EXPECT_NEAR(m.slip_m_s, 0, rigid_tolerance * Launch::speed_m_s);
    }
}

TEST(Friction, rolls_or_slides_down_an_incline) {
    for (const double degrees : {10.0, 30.0, 50.0}) {
        const double slope = degrees * pi / 180, limit = std::tan(slope) / 3;
        for (const double share : {2.0, 1.02, 0.98, 0.5, 0.0}) {
            World w = make_disc_on_plane(slope, share * limit, 0);
            const Acceleration a = run_down(w, slope, 0.1);
            const bool rolls = share >= 1;
            const double along =
                rolls ? 2.0 / 3 * g * std::sin(slope) : g * (std::sin(slope) - share * limit * std::cos(slope));
            const double spin = rolls ? along / disc_radius : 2 * share * limit * g * std::cos(slope) / disc_radius;
            std::printf("incline %2.0f deg, mu %.4f (%.2f of tan/3): a %.6f (closed %.6f), alpha %.3f (%.3f)\n",
                        degrees, share * limit, share, a.along, along, a.clockwise, spin);
            EXPECT_NEAR(a.along / along, 1, rigid_tolerance);
            EXPECT_NEAR(a.clockwise, spin, rigid_tolerance * spin + 1e-9);
        }
    }
}

TEST(Friction, block_stops_after_v2_over_2_mu_g) {
    for (const double friction : {0.2, 0.4, 0.8}) {
        constexpr double v0 = 0.3;
        const Disc d = stop_block(friction, v0);
        const double distance = v0 * v0 / (2 * friction * g);
        std::printf("block, mu %.1f: stops after %.7f m (closed %.7f)\n", friction, d.x_m, distance);
        EXPECT_EQ(d.omega_rad_s, 0);
        EXPECT_NEAR(d.vx_m_s, 0, 1e-9);  // 0.02 s are 20 decay times of the spring
        // The velocity stands half a step behind, and the spring gives back µmg/K_s.
        EXPECT_NEAR(d.x_m, distance, 0.5 * v0 * plane_step + friction * disc_mass * g / (plane_stiffness / 4));
    }
}

// ---- Rolling resistance, Eq 2.18 ----------------------------------------------------------------------------------

// Moments about the contact: m g sin θ r against (full chord) m g cos θ. `share` is tan θ over chord / r.
TEST(Rolling, neutral_angle_is_chord_over_radius) {
    const double neutral = std::atan(chord_m(0) / disc_radius);
    for (const double share : {0.5, 0.98}) {
        World w = make_disc_on_plane(std::atan(share * std::tan(neutral)), 0.6, 2);
        const Vec2 start = centre_of(disc_of(w, 0));
        advance(w, 40000);
        std::printf("rolling: tan theta %.5f = %.2f chord/r: moved %.1e m, v %.1e m/s, omega %.1e rad/s\n",
                    share * std::tan(neutral), share, norm(centre_of(disc_of(w, 0)) - start),
                    norm(velocity_of(disc_of(w, 0))), disc_of(w, 0).omega_rad_s);
        EXPECT_NEAR(norm(velocity_of(disc_of(w, 0))), 0, 1e-9);
        EXPECT_EQ(disc_of(w, 0).omega_rad_s, 0);
    }
    for (const double share : {1.0, 1.02, 2.0, 4.0}) {  // already rolling: keeps its speed at the neutral angle
        const double slope = std::atan(share * std::tan(neutral));
        World w = make_disc_on_plane(slope, 0.6, 2, {0.05, -0.05 / disc_radius});
        const Acceleration a = run_down(w, slope, 0.1);
        const double closed = 2.0 / 3 * g * (std::sin(slope) - chord_m(slope) / disc_radius * std::cos(slope));
        std::printf("rolling: tan theta %.5f = %.2f chord/r: a %+.6f m/s2 (closed %+.6f)\n", std::tan(slope), share,
                    a.along, closed);
        EXPECT_NEAR(a.along, closed, 2 * rigid_tolerance * g * std::sin(slope));
    }
}

TEST(Rolling, as_a_limit_stops_and_never_reverses) {
    EXPECT_EQ(apply_rolling(RollingScheme::limit, 3.0, 3.0, 1.0), 2.0);
    EXPECT_EQ(apply_rolling(RollingScheme::limit, -3.0, -3.0, 1.0), -2.0);
    EXPECT_EQ(apply_rolling(RollingScheme::limit, 0.5, 0.5, 1.0), 0.0);
    EXPECT_EQ(apply_rolling(RollingScheme::limit, -0.5, 0.5, 1.0), 0.0);
    EXPECT_EQ(apply_rolling(RollingScheme::limit, 0.0, 0.0, 1.0), 0.0);
    EXPECT_EQ(apply_rolling(RollingScheme::limit, 3.0, -1.0, 0.0), 3.0);
    EXPECT_EQ(apply_rolling(RollingScheme::sign, 0.5, 0.5, 1.0), -0.5);  // the text's law to the letter reverses
    EXPECT_EQ(apply_rolling(RollingScheme::sign, 0.5, -0.5, 1.0), 1.5);
    EXPECT_EQ(apply_rolling(RollingScheme::sign, 0.5, 0.0, 1.0), 0.5);
}

TEST(Rolling, spinning_disc_stops_in_the_time_of_a_constant_moment) {
    for (const RollingScheme scheme : {RollingScheme::limit, RollingScheme::sign}) {
        const SpinDown m = spin_down(scheme);
        EXPECT_NEAR(m.half_way_share, 0.5, 1e-3);
        std::printf("spin, %s: stop time %.5f s; afterwards |omega| <= %.2e rad/s, %d reversals in 1000 steps\n",
                    scheme == RollingScheme::limit ? "limit" : "sign", m.closed_time_s, m.largest_after_rad_s,
                    m.reversals);
        if (scheme == RollingScheme::limit) {
            EXPECT_EQ(m.largest_after_rad_s, 0.0);
            EXPECT_EQ(m.reversals, 0);
        } else {
            EXPECT_GT(m.reversals, 900);  // to and fro for ever
            EXPECT_LT(m.largest_after_rad_s, 1.001 * spin_loss_rad_s2() * plane_step);
        }
    }
}

// Other codes' rolling spring, for the comparison of costs: two dozen isolated pairs, so that packs and tail are both
// met.
TEST(Rolling, spring_of_other_codes_is_linear_up_to_its_cap) {
    constexpr double ra = 0.002, rb = 0.003, overlap = 1e-5, turn = 3, step = 1e-5, cap = 0.1;
    constexpr int pairs = 25;
    std::vector<Disc> discs;
    for (int n = 0; n < pairs; ++n) {
        discs.push_back(make_disc({0.02 * n, 0}, ra, 0.004, {}, turn));
        discs.push_back(make_disc({0.02 * n + ra + rb - overlap, 0}, rb, 0.009, {}, -turn));
    }
    DemConstants dem = make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, 0.0), 0.2, step);
    dem.rolling_springs = true, dem.soil.rolling_cap = cap;
    World w = make_world(dem, discs);
    update_lists(w.scene.dem, w.state, w.work.dem);
    const double reduced = ra * rb / (ra + rb), limit = cap * reduced * stiffness_N_m * overlap;
    double worst = 0;
    bool capped = false;
    for (int n = 1; n <= 200; ++n) {
        evaluate_forces(w, step);
        const double spring = stiffness_N_m / 4 * reduced * reduced * 2 * turn * n * step;
        capped = spring > limit;
        for (std::uint32_t id = 0; id < 2 * pairs; ++id) {
            const double sign = id % 2 == 0 ? -1 : 1;
            const DiscForce& f = force_on(w, position_of(w, id));
            worst = std::fmax(worst, std::fabs(f.rolling_Nm / (sign * std::fmin(spring, limit)) - 1));
            EXPECT_EQ(f.turning_N, 0.0);
        }
    }
    EXPECT_TRUE(capped);
    EXPECT_LT(worst, 1e-11);  // the overlap, 1e-5 of a position of up to 0.5 m, keeps 11 digits
}

// ---- Blocks -------------------------------------------------------------------------------------------------------

// Five discs wide and a thousand high, so that blocks reach two blocks further and more than one waits for a thread.
TEST(Blocks, are_all_finished_once_with_the_same_forces_beside_any_work_on_any_threads) {
    std::vector<Disc> discs;
    for (int n = 0; n < 5000; ++n) discs.push_back(make_disc({0.0039 * (n % 5), 0.00395 * (n / 5)}, 0.002, 0.004));
    World w = make_world(make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, 0.5), 0.2, 1e-5), discs);
    update_lists(w.scene.dem, w.state, w.work.dem);
    const auto& block = w.work.dem.block;
    ASSERT_EQ(block.size(), 5U);
    std::uint32_t furthest = 0;
    for (std::uint32_t b = 0; b < block.size(); ++b) furthest = std::max(furthest, b - block[b].first_source);
    EXPECT_GE(furthest, 2U);
    std::vector<DiscForce> alone;
    for (const int threads : {1, 2, 3, 5, 8})
        for (const double cost : {0.0, 0.7, 1.6, 4.0, 100.0}) {
            set_threads(threads);
            std::atomic<int> beside = 0;
            std::array<std::atomic<int>, 5> finished{};
            add_forces(w.scene.dem, w.state, w.work.dem, 0.0,
                       [&](const Block& done, std::span<DiscForce> force) {
                           ++finished[done.disc_begin / discs_per_block];
                           std::ranges::fill(force, DiscForce{});
                       },
                       {[&] { ++beside; }, cost});
            EXPECT_EQ(beside, 1) << threads << " threads, " << cost;
            for (const auto& times : finished) EXPECT_EQ(times, 1) << threads << " threads, " << cost;
            if (alone.empty()) alone = w.work.dem.kept_force;
            const bool same = std::ranges::equal(alone, w.work.dem.kept_force, [](const auto& a, const auto& b) {
                return a.x_N == b.x_N && a.y_N == b.y_N && a.turning_N == b.turning_N && a.rolling_Nm == b.rolling_Nm;
            });
            EXPECT_TRUE(same) << threads << " threads, " << cost;
        }
    EXPECT_TRUE(std::ranges::any_of(alone, [](const DiscForce& f) { return f.x_N != 0 && f.y_N != 0; }));
    set_threads(1);
}

// ---- Statics ------------------------------------------------------------------------------------------------------

TEST(Statics, column_overlaps_are_the_weights_above) {
    for (const int count : {1, 2, 5, 10}) {
        const Column m = settle_column(count);
        std::printf("column of %2d: overlaps sum to %.9f mg/Kn (closed %.1f), worst overlap off by %.1e\n", count,
                    m.sum, 0.5 * count * (count + 1), m.worst);
        EXPECT_NEAR(m.sum, 0.5 * count * (count + 1), 1e-6);  // what is left of settling after 0.9 s
        EXPECT_LT(m.worst, 1e-6);
    }
}

// ---- Conservation -------------------------------------------------------------------------------------------------

/// Two unequal discs in an oblique, spinning, rubbing collision away from the origin.
World make_oblique_pair(double rolling_chords, Integrator integrator) {
    return make_world(
        make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, 0.5, ContactEnd::no_attraction, rolling_chords), 0.2,
                 1e-5),
        {make_disc({0.3, 0.2}, 0.002, 0.0033, {0.5, 0.1}, 120),
         make_disc({0.3036, 0.2036}, 0.003, 0.0074, {-0.2, -0.4}, -40)},
        integrator);
}

/// Largest change of the momenta in 400 steps, as shares of Σ m |v| and Σ (m |x| |v| + I |ω|).
struct Drift {
    double linear = 0, angular = 0;
};
Drift find_drift(World w) {
    double sum = 0, moments = 0;
    for (const Disc& d : w.state.discs.disc) {
        sum += mass_of(d) * norm(velocity_of(d));
        moments += mass_of(d) * norm(centre_of(d)) * norm(velocity_of(d)) + inertia_of(d) * std::fabs(d.omega_rad_s);
    }
    const Momentum before = momentum_of(w.state);
    Drift drift;
    for (int n = 0; n < 400; ++n) {
        advance(w, 1);
        const Momentum now = momentum_of(w.state);
        drift.linear = std::fmax(drift.linear, norm(now.linear_Ns - before.linear_Ns) / sum);
        drift.angular = std::fmax(drift.angular, std::fabs(now.angular_Nms - before.angular_Nms) / moments);
    }
    EXPECT_GT(std::fabs(disc_of(w, 0).omega_rad_s - 120), 1);  // they did collide
    return drift;
}

TEST(Conservation, momentum_of_an_isolated_pair) {
    constexpr double round_off = 1e-13;  // 400 steps of some 1e-16 each, with a margin
    for (const Integrator i :
         {Integrator::symplectic_euler, Integrator::modified_euler_one, Integrator::modified_euler_two}) {
        const Drift smooth = find_drift(make_oblique_pair(0, i)), rolling = find_drift(make_oblique_pair(2, i));
        std::printf("pair, %s: drift of momentum %.1e, of angular momentum %.1e; with rolling resistance %.1e, %.1e\n",
                    name_of(i), smooth.linear, smooth.angular, rolling.linear, rolling.angular);
        EXPECT_LT(smooth.linear, round_off);
        EXPECT_LT(rolling.linear, round_off);
        // Only forces along the line of the same positions conserve it exactly; modified Euler corrects positions
        // afterwards.
        EXPECT_LT(smooth.angular, i == Integrator::symplectic_euler ? round_off : 1e-6);
        // Eq 2.18 acts against each disc's own ω and is no pair of moments: the angular momentum of spins is braked.
        EXPECT_GT(rolling.angular, 100 * round_off);
    }
}

// ---- Critical time step -------------------------------------------------------------------------------------------

TEST(CriticalStep, normal_oscillation_of_a_pair) {
    for (const double zeta : {0.0, 0.2, 0.5}) {
        const double omega = std::sqrt((2 * stiffness_N_m + soft_N_m) / pair_mass);  // the soft walls are part of it
        const double dashpots =
            2 * 2 * zeta * std::sqrt(stiffness_N_m * pair_mass / 2) + 2 * zeta * std::sqrt(soft_N_m * pair_mass);
        const double ratio = dashpots / (2 * pair_mass * omega),
                     limit = 2 * (std::sqrt(1 + ratio * ratio) - ratio) / omega;
        const double above =
            growth_a_step(make_squeezed_pair(zeta, stiffness_N_m / 4, 1.002 * limit), &Disc::vx_m_s, 1e-8);
        const double below =
            largest_amplification(make_squeezed_pair(zeta, stiffness_N_m / 4, 0.998 * limit), &Disc::vx_m_s, 1e-8);
        const double factor = -flip_factor(ratio, 1.002 * limit * omega);
        std::printf(
            "critical step, normal, zeta %.1f: %.4e s; 0.2 %% above: %.5f a step (closed %.5f), 0.2 %% below: at most "
            "%.1f times\n",
            zeta, limit, above, factor, below);
        EXPECT_NEAR(above - 1, factor - 1, 0.02 * (factor - 1));
        EXPECT_LT(below, 1.05 / std::sqrt(1 - 0.998 * 0.998) + 1);  // amplitude of the bounded oscillation, undamped
    }
}

TEST(CriticalStep, sliding_and_spinning_of_a_pair) {
    const double arm = pair_radius - 0.5 * squeeze_N / stiffness_N_m,
                 inertia = 0.5 * pair_mass * pair_radius * pair_radius;
    const double omega = std::sqrt(stiffness_N_m * (2 / pair_mass + 2 * arm * arm / inertia));  // √(6 k_s/m)
    const double limit = 2 / omega;
    const double above = growth_a_step(make_squeezed_pair(0, stiffness_N_m, 1.003 * limit), &Disc::omega_rad_s, 1e-6);
    const double below =
        largest_amplification(make_squeezed_pair(0, stiffness_N_m, 0.997 * limit), &Disc::omega_rad_s, 1e-6);
    const double factor = -flip_factor(0, 2 * 1.003);
    std::printf(
        "critical step, tangential: %.4e s = %.5f / sqrt(6 ks/m); 0.3 %% above: %.5f a step (closed %.5f), below: at "
        "most %.1f times\n",
        limit, limit * std::sqrt(6 * stiffness_N_m / pair_mass), above, factor, below);
    EXPECT_NEAR(limit * std::sqrt(6 * stiffness_N_m / pair_mass), 2, 1e-3);
    EXPECT_NEAR(above - 1, factor - 1, 0.02 * (factor - 1));
    EXPECT_LT(below, 1.05 / std::sqrt(1 - 0.997 * 0.997) + 1);
}

}  // namespace
}  // namespace ifedem

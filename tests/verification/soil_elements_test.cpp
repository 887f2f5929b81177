// Soil elements (chapter 5) under discs: settlement, series stiffness, waves across the interface, balances, same bits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/hash.hpp"
#include "dem/bed.hpp"
#include "record/checkpoint.hpp"
#include "step/confined_compression.hpp"
#include "step/energy.hpp"
#include "step/soil_pattern.hpp"
#include "support/scratch.hpp"
#include "support/soil_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

double confined_modulus_Pa(const MaterialCase& m) {
    return m.young_Pa * (1 - m.poisson) / ((1 + m.poisson) * (1 - 2 * m.poisson));  // Eq 5.9
}

double highest_node_m(const World& w) {
    double y = 0;
    for (const Vec2 p : w.state.soil.position_m) y = std::fmax(y, p.y);
    return y;
}

// ---- Elements alone -------------------------------------------------------------------------------------------------

TEST(SoilElements, settle_under_their_own_weight) {
    Case c = make_column_case(4, 2, 0.15, 0.2);
    c.bed.disc_count = 1;
    c.elements.material.damping_1_s = 150;
    World w = begin(c);
    w.state.discs.disc[0].y_m = 10;  // falls for longer than the test lasts
    advance(w, 20000);
    const double height = 0.4, density = c.elements.material.density_kg_m3;
    const double closed = density * c.gravity_m_s2 * height * height / (2 * confined_modulus_Pa(c.elements.material));
    const double got = height - highest_node_m(w);
    std::printf("settlement of 0.4 m of elements: %.5f mm, rho g H^2 / 2 E' = %.5f mm\n", 1e3 * got, 1e3 * closed);
    EXPECT_NEAR(got / closed, 1, 0.005);  // corotational strain is of second order: 0.2 % at most here
}

// ---- Regular columns: closed forms ----------------------------------------------------------------------------------

constexpr double radius = 0.0025;

/// Chains of equal discs, `across` of them, shoulder to shoulder on elements 2 r high and as wide as the chains; a lid
/// on top. No friction, no gravity.
World make_chains(std::int64_t across, std::int64_t discs_up, std::int64_t rows, double young_Pa, double damping) {
    Case c = make_column_case(1, rows, 2 * radius * static_cast<double>(across), 2 * radius);
    c.elements.material.young_Pa = young_Pa;
    c.elements.material.damping_1_s = damping;
    c.soil.radii_m = {radius}, c.soil.radii_shares = {1};
    c.bed.disc_count = across * discs_up;
    c.gravity_m_s2 = 0;
    c.contact.rolling_factor = 0;
    c.contact.damping_ratio = damping > 0 ? 0.5 : 0;
    c.time_step_s = 1e-5;
    World w = begin(c);
    for (std::size_t n = 0; n < w.state.discs.disc.size(); ++n) {
        const auto column = static_cast<double>(n % static_cast<std::size_t>(across));
        const auto row = static_cast<double>(n / static_cast<std::size_t>(across));
        Disc& d = w.state.discs.disc[n];
        d.x_m = (2 * column + 1) * radius;
        d.y_m = 2 * radius * static_cast<double>(rows) + (2 * row + 1) * radius;
    }
    const double top = 2 * radius * static_cast<double>(rows + discs_up);
    w.scene.dem.flat_walls.push_back({{0, top}, {0, -1}});
    w.work = make_workspace(w.scene, w.state);
    return w;
}

void move_lid(World& w, double by_m) {
    w.scene.dem.flat_walls.back().point_m.y += by_m;
    w.work.dem.rebuild_outer = true;  // walls are searched from where they stood at the last rebuild
}

double lid_force_N(const World& w) {
    const auto lid = static_cast<std::uint32_t>(w.scene.dem.flat_walls.size() - 1);
    double sum = 0;
    for (const WallCandidate& c : w.work.dem.wall) {
        if (c.wall != lid) continue;
        const Disc& d = w.state.discs.disc[c.position];
        const double overlap = d.radius_m - find_wall_side(w.scene.dem, lid, d).distance_m;
        if (overlap > 0) sum += w.scene.dem.wall.normal_stiffness_N_m * overlap;
    }
    return sum;
}

TEST(Column, of_chains_on_elements_is_stiff_as_springs_in_series) {
    constexpr std::int64_t across = 8, up = 10, rows = 10;
    World w = make_chains(across, up, rows, 1e6, 400);
    const double stress = 30e3, width = 2 * radius * across, thickness = w.scene.c.soil.thickness_m;
    const double force = stress * width * thickness;
    const double chain = force / across * static_cast<double>(up + 1) / w.scene.c.contact.normal_stiffness_N_m;
    const double elements =
        stress / confined_modulus_Pa(w.scene.c.elements.material) * 2 * radius * static_cast<double>(rows);
    for (int n = 0; n < 50; ++n) {
        move_lid(w, -(chain + elements) / 50);
        advance(w, 400);
    }
    advance(w, 20000);
    const double got = lid_force_N(w) / (width * thickness);
    std::printf("series: %.3f mm of discs + %.3f mm of elements give %.3f kPa of 30\n", 1e3 * chain, 1e3 * elements,
                1e-3 * got);
    EXPECT_NEAR(got / stress, 1, 0.02);
}

/// Moves the lid in small steps, with rest between them, until its stress passes `stress_Pa`; returns the way down.
double press_to(World& w, double stress_Pa, double area_m2, double step_m) {
    const bool down = lid_force_N(w) < stress_Pa * area_m2;
    double way = 0;
    while ((lid_force_N(w) < stress_Pa * area_m2) == down) {
        way += down ? step_m : -step_m;
        move_lid(w, down ? -step_m : step_m);
        advance(w, 200);
    }
    return way;
}

// A random packing, pressed once so that it is elastic: its own compression on a hard floor plus the elements', against
// the same packing on elements.
TEST(Column, of_packed_discs_on_elements_is_the_sum_of_both) {
    constexpr double width = 0.06, height = 0.1, low_Pa = 5e3, high_Pa = 30e3, fine = 2e-6;
    Case c = make_column_case(0, 2, width / 2, height / 2);
    c.bed.length_m = width;
    c.bed.disc_count = 200;
    c.time_step_s = 2e-5;
    c.contact.damping_ratio = 0.5;
    c.elements.material.damping_1_s = 300;
    const double area = width * c.soil.thickness_m, confined = confined_modulus_Pa(c.elements.material);

    World floor = begin(c);
    advance(floor, 25000);
    double top = 0;
    for (const Disc& d : floor.state.discs.disc) top = std::fmax(top, d.y_m + d.radius_m);
    floor.scene.dem.flat_walls.push_back({{0, top}, {0, -1}});
    floor.work.dem.rebuild_outer = true;
    static_cast<void>(press_to(floor, 1.3 * high_Pa, area, 1e-5));
    static_cast<void>(press_to(floor, low_Pa, area, fine));
    advance(floor, 5000);

    c.elements.columns = 2;
    World both = begin(c);
    both.scene.soil.gravity_m_s2 = {};  // else they would settle under their own weight first
    double weight = 0;
    for (const Disc& d : floor.state.discs.disc) weight += c.gravity_m_s2 * mass_of(d);
    const double shift = height * (1 - (low_Pa + weight / area) / confined);
    both.state.discs = floor.state.discs;
    for (Disc& d : both.state.discs.disc) d.y_m += shift;
    for (Vec2& p : both.state.soil.position_m) p.y *= shift / height;
    both.scene.dem.flat_walls.push_back(floor.scene.dem.flat_walls.back());
    both.scene.dem.flat_walls.back().point_m.y += shift;
    both.work = make_workspace(both.scene, both.state);
    advance(both, 5000);

    const double low_floor = lid_force_N(floor) / area, low_both = lid_force_N(both) / area;
    const double discs = press_to(floor, high_Pa, area, fine), sum = press_to(both, high_Pa, area, fine);
    const double elements = (high_Pa - low_both) / confined * height;
    std::printf("%.2f (%.2f) to 30 kPa: discs %.4f mm, elements %.4f mm (closed form), both in one column %.4f mm\n",
                1e-3 * low_floor, 1e-3 * low_both, 1e3 * discs, 1e3 * elements, 1e3 * sum);
    EXPECT_NEAR(low_both / low_floor, 1, 0.02);
    EXPECT_GT(elements, 0.2 * sum);
    EXPECT_NEAR(sum / (discs + elements), 1, 0.02);
}

// ---- Waves ----------------------------------------------------------------------------------------------------------

/// A pressure pulse that runs down a chain of discs into elements: reflected and transmitted velocity against the
/// impedances. Everything stands under a pressure that the pulse's tail cannot undo.
void expect_reflection(double impedance_ratio) {
    constexpr std::int64_t up = 400, rows = 400;
    constexpr double overlap = 2e-6, peak_m_s = 1e-3, spread = 20;  // in discs
    Case probe;
    const double thickness = probe.soil.thickness_m, stiffness = probe.contact.normal_stiffness_N_m;
    const double mass = probe.soil.density_kg_m3 * pi * radius * radius * thickness;
    const double z_discs = std::sqrt(stiffness * mass) / (2 * radius * thickness);
    const double z_elements = impedance_ratio * z_discs;
    const MaterialCase& soil = probe.elements.material;
    const double confined = z_elements * z_elements / soil.density_kg_m3;
    World w = make_chains(1, up, rows, confined * (1 + soil.poisson) * (1 - 2 * soil.poisson) / (1 - soil.poisson), 0);
    const double c_discs = 2 * radius * std::sqrt(stiffness / mass), c_elements = z_elements / soil.density_kg_m3;
    const double strain = stiffness * overlap / (2 * radius * thickness) / confined;  // of the elements, at rest
    for (Vec2& p : w.state.soil.position_m) p.y *= 1 - strain;
    const double floor = 2 * radius * rows * (1 - strain), middle = 200;
    for (std::size_t n = 0; n < w.state.discs.disc.size(); ++n) {
        const auto k = static_cast<double>(n), s = (k - middle) / spread;
        // f(y + c t): velocity peak · exp(−s²/2) downwards, displacement its integral over c.
        const double shift =
            -peak_m_s / c_discs * 2 * radius * spread * std::sqrt(pi / 2) * (1 + std::erf(s / std::sqrt(2)));
        Disc& d = w.state.discs.disc[n];
        d.y_m = floor + (2 * k + 1) * radius - (k + 1) * overlap + shift;
        d.vy_m_s = -peak_m_s * std::exp(-0.5 * s * s);
        if (n + 1 == w.state.discs.disc.size()) w.scene.dem.flat_walls.back().point_m.y = d.y_m + radius - overlap;
    }
    w.work = make_workspace(w.scene, w.state);
    w.work.dem.rebuild_outer = true;
    // Until the reflected pulse is back in the middle of the discs.
    advance(w, std::llround(2 * middle * 2 * radius / c_discs / w.scene.dem.step_s));
    double reflected = 0, transmitted = 0;
    for (const Disc& d : w.state.discs.disc)
        if (std::fabs(d.vy_m_s) > std::fabs(reflected)) reflected = d.vy_m_s;
    for (const Vec2 v : w.state.soil.velocity_m_s)
        if (std::fabs(v.y) > std::fabs(transmitted)) transmitted = v.y;
    const double r = (1 - impedance_ratio) / (1 + impedance_ratio), t = 2 / (1 + impedance_ratio);
    std::printf(
        "Z_elements / Z_discs = %.2f (c %.1f and %.1f m/s): reflected %+.4f (%+.4f), transmitted %+.4f (%+.4f)\n",
        impedance_ratio, c_discs, c_elements, -reflected / peak_m_s, r, -transmitted / peak_m_s, t);
    EXPECT_NEAR(-reflected / peak_m_s, r, 0.02);
    EXPECT_NEAR(-transmitted / peak_m_s, t, 0.02 * t);
}

TEST(Wave, is_reflected_as_impedances_say) {
    expect_reflection(1.5);
    expect_reflection(0.6);
}

// ---- Balances -------------------------------------------------------------------------------------------------------

TEST(Interface, forces_balance_to_round_off) {
    Random random{5};
    const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    Case c = make_column_case(4, 2, 0.06, 0.05);
    c.elements.first_disc_column = 1, c.elements.disc_columns = 2;
    c.bed.disc_count = 500;
    c.contact.consolidation_friction_wall = 0.4;
    World w = begin(c);
    for (Disc& d : w.state.discs.disc) {
        d.x_m = between(0, 0.24), d.y_m = between(0.045, 0.105);
        d.vx_m_s = between(-1, 1), d.vy_m_s = between(-1, 1), d.omega_rad_s = between(-300, 300);
    }
    for (Vec2& v : w.state.soil.velocity_m_s) v = {between(-1, 1), between(-1, 1)};
    w.work = make_workspace(w.scene, w.state);
    update_lists(w.scene.dem, w.state, w.work.dem);
    add_soil_contacts(w.scene.dem, w.scene.soil, w.state, w.work.dem, w.work.soil, 1e-5);
    Vec2 force;
    double moment = 0, size = 0;
    for (const SurfaceContact& k : w.work.soil.contact) {
        force += k.on_disc.force_N;
        const Disc& d = w.state.discs.disc[k.position];
        moment += cross(centre_of(d), k.on_disc.force_N) + k.on_disc.turning_N * d.radius_m;
        size += norm(k.on_disc.force_N);
    }
    for (std::size_t n = 0; n < w.work.soil.contact_force_N.size(); ++n) {
        force += w.work.soil.contact_force_N[n];
        moment += cross(w.state.soil.position_m[n], w.work.soil.contact_force_N[n]);
    }
    std::printf("interface: %zu contacts, unbalanced force %.1e, moment %.1e m of sum |F|\n",
                w.work.soil.contact.size(), norm(force) / size, std::fabs(moment) / size);
    EXPECT_GT(w.work.soil.contact.size(), 50U);
    EXPECT_LT(norm(force) / size, 1e-14);
    EXPECT_LT(std::fabs(moment) / size, 1e-14);
}

/// Discs poured into a trough between elements, friction and rolling resistance included.
Case make_trough() {
    Case c = make_column_case(4, 2, 0.12, 0.05);
    c.elements.first_disc_column = 1, c.elements.disc_columns = 2;
    c.elements.material.damping_1_s = 20;
    c.elements.pattern_discs = 10, c.elements.pattern_s = 0.01;  // not what falls: see begin_trough()
    c.bed.disc_count = 600;
    c.travel.start_x_m = 0.2, c.travel.distance_m = 0.1;  // a checkpoint's case is checked as a whole
    c.contact.consolidation_friction_soil = c.contact.friction_soil;
    c.contact.consolidation_friction_wall = c.contact.friction_elements;
    return c;
}

/// A loose bed above the elements and the trough between them, instead of a trough filled with prepared discs.
World begin_trough(const Case& c) {
    World w = begin(c);
    w.state.discs = generate_bed(c);
    for (Disc& d : w.state.discs.disc) d.y_m += static_cast<double>(c.elements.rows) * c.elements.block_height_m;
    w.work = make_workspace(w.scene, w.state);
    return w;
}

TEST(Energy, of_discs_that_fall_on_elements_closes) {
    double residual[2] = {};
    for (const int halvings : {0, 1}) {
        Case c = make_trough();
        c.time_step_s = 4e-5 / (1 << halvings);
        World w = begin_trough(c);
        EnergyLedger flow;
        const EnergyStore before = measure_energy(w.scene, w.state, w.work);
        for (int n = 0; n < (6000 << halvings); ++n)
            add_to_ledger(flow, step_and_measure(w.scene, w.state, w.work), w.scene.dem.step_s);
        const EnergyStore after = measure_energy(w.scene, w.state, w.work);
        const double lost = flow.lost_normal_J + flow.lost_tangential_J + flow.lost_rolling_J + flow.lost_wheel_J;
        const double released =
            before.height_discs_J + before.height_soil_J - after.height_discs_J - after.height_soil_J;
        residual[halvings] = (before.sum_J() - after.sum_J() - lost) / released;
        std::printf(
            "trough, dt %.0e s: released %.4f J, lost %.4f J (elements %.5f), strain %.5f J, residual %.2f %%\n",
            c.time_step_s, released, lost, flow.lost_wheel_J, after.strain_J, 100 * residual[halvings]);
        EXPECT_GT(flow.lost_wheel_J, 0);
        EXPECT_LT(std::fabs(residual[halvings]), 0.01);
    }
}

// ---- Discs alone ----------------------------------------------------------------------------------------------------

// Preparation and compression are slow: both take symplectic Euler, whatever the case travels with.
TEST(Confined, compression_is_the_same_for_any_integrator_of_the_case) {
    omp_set_num_threads(1);
    Case c = make_column_case(3, 2, 0.06, 0.05);
    c.elements.pattern_discs = 138, c.elements.pattern_s = 0.08;
    const std::vector<Disc> pattern = prepare_pattern(c);
    const ConfinedCompression reference = compress_confined(c, pattern, 0.01, 2, 0.1);
    EXPECT_LT(reference.point.back().discs_Pa, -1e3);
    // Of three points at equal distances the gradient is that between the outer two, wherever the line meets zero.
    const ConfinedPoint &first = reference.point.front(), &last = reference.point.back();
    ASSERT_EQ(reference.point.size(), 3U);
    const MaterialCase unit{.young_Pa = 1, .poisson = c.elements.material.poisson};
    const auto young = [&](double from_Pa, double to_Pa) {
        return (to_Pa - from_Pa) / (last.strain - first.strain) / confined_modulus_Pa(unit);
    };
    EXPECT_NEAR(reference.young_Pa, young(first.discs_mean_Pa, last.discs_mean_Pa), 1e-9 * reference.young_Pa);
    EXPECT_NEAR(reference.young_of_lid_Pa, young(first.discs_Pa, last.discs_Pa), 1e-9 * reference.young_of_lid_Pa);
    for (const Integrator integrator : {Integrator::modified_euler_one, Integrator::modified_euler_two}) {
        c.integrator = integrator;
        const ConfinedCompression result = compress_confined(c, prepare_pattern(c), 0.01, 2, 0.1);
        EXPECT_EQ(result.young_Pa, reference.young_Pa);
        EXPECT_EQ(result.point.back().discs_Pa, reference.point.back().discs_Pa);
    }
}

// ---- The same bits --------------------------------------------------------------------------------------------------

TEST(SoilElements, resume_and_threads_give_the_same_bits) {
    World whole = begin_trough(make_trough());
    advance(whole, 3000);
    World half = begin_trough(make_trough());
    omp_set_num_threads(2);
    advance(half, 1500);
    const Scratch scratch;
    write_checkpoint(scratch.file("checkpoint.h5"), half.state, half.scene.c);
    World resumed;
    resumed.state = read_checkpoint(scratch.file("checkpoint.h5")).state;
    EXPECT_EQ(hash_state(resumed.state), hash_state(half.state));
    resumed.scene = make_scene(make_trough(), Stage::consolidation);
    resumed.work = make_workspace(resumed.scene, resumed.state);
    advance(resumed, 1500);
    omp_set_num_threads(1);
    EXPECT_EQ(to_hex(hash_state(resumed.state)), to_hex(hash_state(whole.state)));
    EXPECT_GT(whole.state.soil.contacts.size(), 10U);
}

}  // namespace
}  // namespace ifedem

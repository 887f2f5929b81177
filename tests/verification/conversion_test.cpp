// Soil that changes between elements and discs (sections 5.1.2–5.1.5): where discs are placed, what an element takes
// over, a block that goes back and forth, and the same bits across a conversion.
#include "coupling/conversion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/hash.hpp"
#include "coupling/stress_handover.hpp"
#include "step/energy.hpp"
#include "step/health.hpp"
#include "step/soil_pattern.hpp"
#include "support/soil_drive.hpp"
#include "support/soil_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

/// About what fills 0.06 × 0.05 m by its own weight; more would stand under pressure from the beginning.
constexpr std::size_t discs_a_block = 138;

/// Three columns of small blocks, the middle one of the top row discs.
Case make_small_case() {
    Case c = make_column_case(3, 2, 0.06, 0.05);
    c.elements.first_disc_column = 1, c.elements.disc_columns = 1;
    c.elements.pattern_discs = discs_a_block;
    c.elements.pattern_s = 0.1;
    c.contact.normal_stiffness_N_m = 5e5, c.contact.tangential_stiffness_N_m = 1.25e5;
    c.contact.consolidation_friction_soil = c.contact.consolidation_friction_wall = 0.6;
    c.soil.thickness_m = 0.17;
    return c;
}

constexpr std::uint32_t middle = 4;  // block (1, 1) of 3 × 2

double kinetic_J(const World& w) {
    const EnergyStore e = measure_energy(w.scene, w.state, w.work);
    return e.kinetic_discs_J + e.kinetic_soil_J;
}

// ---- Element → discs ------------------------------------------------------------------------------------------------

TEST(ToDiscs, places_the_pattern_where_the_element_is) {
    World w = begin(make_small_case());
    const auto node = w.scene.soil.nodes_of(middle);
    const auto rest = plan_to_discs(w.scene.soil, w.scene.dem, w.state.soil, middle);
    ASSERT_EQ(rest.add.size(), discs_a_block);
    double worst = 0;
    for (std::size_t n = 0; n < rest.add.size(); ++n)
        worst = std::fmax(worst, norm(centre_of(rest.add[n]) - centre_of(w.state.soil.pattern[n]) - Vec2{0.06, 0.05}));
    EXPECT_LT(worst, 1e-15);

    // An affine deformation carries every disc along exactly, whatever its triangle.
    const auto map = [](Vec2 p) { return Vec2{0.01 + 0.97 * p.x + 0.05 * p.y, -0.02 + 0.02 * p.x + 0.93 * p.y}; };
    SoilState deformed = w.state.soil;
    for (const std::uint32_t n : node) deformed.position_m[n] = map(deformed.position_m[n]);
    const auto affine = plan_to_discs(w.scene.soil, w.scene.dem, deformed, middle);
    worst = 0;
    for (std::size_t n = 0; n < rest.add.size(); ++n)
        worst = std::fmax(worst, norm(centre_of(affine.add[n]) - map(centre_of(rest.add[n]))));
    EXPECT_LT(worst, 1e-15);

    // Any other one keeps them inside the quad.
    deformed.position_m[node[2]] += Vec2{-0.012, -0.015};
    for (const Disc& d : plan_to_discs(w.scene.soil, w.scene.dem, deformed, middle).add) {
        for (std::size_t a = 0; a < 4; ++a) {
            const Vec2 from = deformed.position_m[node[a]], to = deformed.position_m[node[(a + 1) % 4]];
            EXPECT_GT(cross(to - from, centre_of(d) - from), 0);
        }
    }
}

TEST(ToDiscs, keeps_mass_and_momentum) {
    World w = begin(make_small_case());
    for (Vec2& v : w.state.soil.velocity_m_s) v = {0.3, -0.2};
    const auto edit = plan_to_discs(w.scene.soil, w.scene.dem, w.state.soil, middle);
    double mass = 0, prepared = 0;
    Vec2 momentum;
    for (const Disc& d : edit.add) mass += mass_of(d), momentum += mass_of(d) * velocity_of(d);
    for (const Disc& d : w.state.soil.pattern) prepared += mass_of(d);
    EXPECT_EQ(mass, prepared);
    EXPECT_NEAR(momentum.x, 0.3 * mass, 1e-12);
    EXPECT_NEAR(momentum.y, -0.2 * mass, 1e-12);
}

// ---- Discs → element ------------------------------------------------------------------------------------------------

TEST(ToElement, attaches_the_border_and_removes_the_rest) {
    World w = begin(make_small_case());
    advance(w, 5000);
    const std::uint64_t before = hash_state(w.state);
    const auto edit = plan_to_element(w.scene.soil, w.scene.dem, w.state, w.work.soil, middle);
    EXPECT_EQ(hash_state(w.state), before);  // a plan changes nothing
    EXPECT_TRUE(edit.refusal.empty()) << edit.refusal;
    EXPECT_EQ(edit.remove.size(), discs_a_block);
    // Only the top is open here: 3 R = 9 mm of 50.
    std::printf("attached %zu of %zu discs\n", edit.attach.size(), edit.remove.size());
    EXPECT_GT(edit.attach.size(), 15U);
    EXPECT_LT(edit.attach.size(), 45U);
    for (const Attachment& a : edit.attach) {
        const Disc& d = w.state.discs.disc[a.position];
        EXPECT_GT(d.y_m, 0.1 - 0.012);
        const Vec2 foot =
            (1 - a.disc.share) * w.state.soil.position_m[a.from] + a.disc.share * w.state.soil.position_m[a.to];
        EXPECT_LT(norm(foot + Vec2{a.disc.offset_x_m, a.disc.offset_y_m} - centre_of(d)), 1e-15);
    }
    apply_conversion(edit, w.scene.soil, w.scene.dem, w.state, w.work.dem, w.work.soil);
    EXPECT_TRUE(w.state.discs.disc.empty());
    EXPECT_EQ(w.state.soil.attached.size(), edit.attach.size());
}

TEST(ToElement, is_refused_where_the_rut_is_too_deep) {
    World w = begin(make_small_case());
    // Nothing left of the right-hand neighbour, and its discs at the floor of the row: the corner would lie there.
    w.state.soil.kind[middle + 1] = BlockKind::discs;
    attach_soil_workspace(w.scene.soil, w.state.soil, w.work.soil);
    std::erase_if(w.state.discs.disc, [](const Disc& d) { return d.x_m > 0.1 || d.y_m > 0.06; });
    const auto edit = plan_to_element(w.scene.soil, w.scene.dem, w.state, w.work.soil, middle);
    EXPECT_FALSE(edit.refusal.empty());
    EXPECT_TRUE(edit.remove.empty());
    std::printf("refused: %s\n", edit.refusal.c_str());
}

/// Discs and elements side by side with a rough border: forces on free discs and on nodes add up to nothing.
TEST(Attached, contacts_share_their_forces_out) {
    Case c = make_small_case();
    c.elements.first_disc_column = 1, c.elements.disc_columns = 2;
    World w = begin(c);
    advance(w, 4000);
    const auto edit = plan_to_element(w.scene.soil, w.scene.dem, w.state, w.work.soil, middle);
    ASSERT_TRUE(edit.refusal.empty()) << edit.refusal;
    apply_conversion(edit, w.scene.soil, w.scene.dem, w.state, w.work.dem, w.work.soil);
    const std::size_t inherited = w.state.soil.attached_contacts.size();
    w.work.dem.wheel_force.clear();
    add_soil_contacts(w.scene.dem, w.scene.soil, w.state, w.work.dem, w.work.soil, 0);
    Vec2 sum;
    double size = 0, deepest = 0;
    for (const WheelForce& f : w.work.dem.wheel_force) sum += {f.on_disc.x_N, f.on_disc.y_N};
    for (const Vec2 f : w.work.soil.contact_force_N) sum += f, size += norm(f);
    for (const SurfaceContact& k : w.work.soil.contact) deepest = std::fmax(deepest, k.on_disc.overlap_m);
    std::printf(
        "attached: %zu discs, %zu contacts (%zu springs inherited), unbalanced %.1e of %.1f N; deepest overlap with "
        "a segment %.3f mm\n",
        w.state.soil.attached.size(), w.work.soil.attached.contact.size(), inherited, norm(sum) / size, size,
        1e3 * deepest);
    EXPECT_GT(w.work.soil.attached.contact.size(), 5U);
    EXPECT_GT(inherited, 0U);
    EXPECT_LT(norm(sum) / size, 1e-13);
    EXPECT_LT(deepest, 0.3e-3);  // the outer zone leaves no disc inside a new segment
    advance(w, 5000);
    EXPECT_FALSE(check_health(w.scene, w.state, w.work).has_value());
    EXPECT_LT(kinetic_J(w), 1e-4);
}

// ---- Back and forth -------------------------------------------------------------------------------------------------

// Section 5.1's conversions on a block at rest, with nothing to do: what they cost. The text gives no numbers; the
// bounds say that the effect does not grow.
TEST(BackAndForth, twenty_times_does_not_run_away) {
    World w = begin(make_small_case());
    advance(w, 10000);
    const double start = block_surface_m(w.scene.soil, w.state, middle);
    double burst = 0, last_burst = 0, first_burst = 0;
    std::vector<double> surface;
    for (int n = 0; n < 20; ++n) {
        const auto element = plan_to_element(w.scene.soil, w.scene.dem, w.state, w.work.soil, middle);
        ASSERT_TRUE(element.refusal.empty()) << element.refusal;
        apply_conversion(element, w.scene.soil, w.scene.dem, w.state, w.work.dem, w.work.soil);
        advance(w, 2500);
        const auto discs = plan_to_discs(w.scene.soil, w.scene.dem, w.state.soil, middle);
        apply_conversion(discs, w.scene.soil, w.scene.dem, w.state, w.work.dem, w.work.soil);
        last_burst = 0;
        for (int k = 0; k < 50; ++k) advance(w, 50), last_burst = std::fmax(last_burst, kinetic_J(w));
        burst = std::fmax(burst, last_burst);
        if (n == 0) first_burst = last_burst;
        surface.push_back(block_surface_m(w.scene.soil, w.state, middle) - start);
        ASSERT_FALSE(check_health(w.scene, w.state, w.work).has_value());
    }
    const auto total = static_cast<double>(w.state.discs.disc.size());
    const double weight = 0.06 * 0.05 * 0.17 * 2200 * 9.81;
    std::printf(
        "20 conversions there and back: surface after 1, 5, 10, 20: %+.3f %+.3f %+.3f %+.3f mm; largest kinetic "
        "energy %.2e J (first %.2e, last %.2e), weight × 1 mm %.2e J\n",
        1e3 * surface[0], 1e3 * surface[4], 1e3 * surface[9], 1e3 * surface[19], burst, first_burst, last_burst,
        weight * 1e-3);
    std::printf("discs at the end: %.0f of %zu a block\n", total, discs_a_block);
    EXPECT_LT(std::fabs(surface[19] - surface[9]), 1e-3);
    EXPECT_LT(last_burst, 3 * first_burst);
}

// ---- Stress handed over ---------------------------------------------------------------------------------------------

/// What one conversion there and back does to a block that carries its own weight ten times over: σ_y of what comes
/// out, how its surface settles afterwards and the largest kinetic energy afterwards.
struct Step {
    double before_Pa = 0, element_Pa = 0, discs_Pa = 0;
    double settlement_m = 0, burst_J = 0;
    double element_more_kg = 0, discs_more_kg = 0;  ///< mass of all soil: more than before it became an element, discs
};

double soil_mass_kg(const World& w) {
    double mass = 0;
    for (const Disc& d : w.state.discs.disc) mass += mass_of(d);
    for (const SoilNode& n : w.work.soil.node) mass += n.mass_kg;
    return mass;
}

Step convert_there_and_back(StressHandover handover) {
    Case c = make_small_case();
    c.gravity_m_s2 = 98.1;
    c.elements.stress_handover = handover;
    World w = begin(c);
    advance(w, 20000);
    const double volume = 0.06 * 0.05 * 0.17;
    const auto all = [&] {
        std::vector<std::uint32_t> p(w.state.discs.disc.size());
        for (std::uint32_t n = 0; n < p.size(); ++n) p[n] = n;
        return p;
    };
    const auto element_stress = [&] {
        for (std::size_t k = 0; k < w.work.soil.block.size(); ++k)
            if (w.work.soil.block[k] == middle)
                return centroid_stress_Pa(w.work.soil.elements.element[k], w.scene.soil.material, PlaneState::strain,
                                          w.state.soil.position_m)[1];
        return 0.0;
    };
    Step s;
    s.before_Pa = mean_stress_Pa(w.scene.dem, w.state, all(), volume)[1];
    const double mass = soil_mass_kg(w);
    apply_conversion(plan_to_element(w.scene.soil, w.scene.dem, w.state, w.work.soil, middle), w.scene.soil,
                     w.scene.dem, w.state, w.work.dem, w.work.soil);
    s.element_Pa = element_stress();
    s.element_more_kg = soil_mass_kg(w) - mass;
    const double surface = block_surface_m(w.scene.soil, w.state, middle);
    for (int k = 0; k < 100; ++k) advance(w, 50), s.burst_J = std::fmax(s.burst_J, kinetic_J(w));
    s.settlement_m = block_surface_m(w.scene.soil, w.state, middle) - surface;
    const double carried = element_stress();
    apply_conversion(plan_to_discs(w.scene.soil, w.scene.dem, w.state.soil, middle), w.scene.soil, w.scene.dem, w.state,
                     w.work.dem, w.work.soil);
    s.discs_Pa = mean_stress_Pa(w.scene.dem, w.state, all(), volume)[1] - carried;
    s.discs_more_kg = soil_mass_kg(w) - mass - s.element_more_kg;
    return s;
}

TEST(Handover, gives_the_new_soil_the_stress_of_the_old) {
    const Step without = convert_there_and_back(StressHandover::none),
               with = convert_there_and_back(StressHandover::mean);
    for (const auto& [name, s] : {std::pair{"without", without}, std::pair{"with", with}})
        std::printf(
            "%s handover: discs %.2f kPa, new element %.2f kPa; surface %+.4f mm, largest kinetic energy %.2e J; "
            "discs again: off the element's by %+.2f kPa; mass %+.2e, %+.2e kg\n",
            name, 1e-3 * s.before_Pa, 1e-3 * s.element_Pa, 1e3 * s.settlement_m, s.burst_J, 1e-3 * s.discs_Pa,
            s.element_more_kg, s.discs_more_kg);
    EXPECT_LT(with.before_Pa, -1e3);
    EXPECT_NEAR(without.element_Pa, 0, 1);
    EXPECT_NEAR(with.element_Pa / with.before_Pa, 1, 0.02);  // over the quad's own volume, which is not the block's
    EXPECT_NEAR(with.discs_Pa, 0, 0.02 * std::fabs(with.before_Pa));
    // Over the packings of seeds 1 to 7: 8 to 29 % (0.004 to 0.011 mm of 0.04 to 0.06 mm).
    EXPECT_EQ(with.before_Pa, without.before_Pa);
    EXPECT_LT(std::fabs(with.settlement_m), std::fabs(without.settlement_m) / 3);
    EXPECT_LT(with.burst_J, 0.2 * without.burst_J);
    EXPECT_NEAR(with.element_more_kg, 0, 1e-12);
    EXPECT_NEAR(with.discs_more_kg, 0, 1e-12);
    EXPECT_GT(std::fabs(without.element_more_kg), 1e-3);
}

/// Σ r_y F_y / V over all pairs, the slow way.
double vertical_stress_Pa(const std::vector<Disc>& discs, double stiffness_N_m, double volume_m3) {
    double sum = 0;
    for (std::size_t i = 0; i < discs.size(); ++i)
        for (std::size_t j = i + 1; j < discs.size(); ++j) {
            const Vec2 between = centre_of(discs[j]) - centre_of(discs[i]);
            const double overlap = discs[i].radius_m + discs[j].radius_m - norm(between);
            if (overlap > 0) sum -= stiffness_N_m * overlap * between.y * between.y / norm(between);
        }
    return sum / volume_m3;
}

// An element without stress, one that pulls and one that is pressed: discs take the stress over that they can have.
TEST(Handover, places_discs_under_the_elements_stress) {
    Case c = make_small_case();
    c.elements.stress_handover = StressHandover::mean;
    const World w = begin(c);
    constexpr std::uint32_t left = 3;  // block (0, 1), an element
    const double tenth_Pa = -0.1 * 0.5 * c.elements.material.density_kg_m3 * c.gravity_m_s2 * 0.05;
    for (const double strain : {0.0, 0.01, -0.002}) {
        SoilState soil = w.state.soil;
        const auto node = w.scene.soil.nodes_of(left);
        for (const std::size_t top : {2U, 3U}) soil.position_m[node[top]].y += strain * 0.05;
        const auto discs = plan_to_discs(w.scene.soil, w.scene.dem, soil, left).add;
        const double element_Pa = element_stress_Pa(w.scene.soil, soil, left)[1];
        const double discs_Pa =
            vertical_stress_Pa(discs, c.contact.normal_stiffness_N_m, 0.06 * 0.05 * (1 + strain) * c.soil.thickness_m);
        const double rise_m = discs[0].y_m - 0.05 - (1 + strain) * soil.pattern[0].y_m;
        std::printf("strain %+.3f: element %+.1f Pa, discs %+.1f Pa, first disc %+.4f mm from where it was prepared\n",
                    strain, element_Pa, discs_Pa, 1e3 * rise_m);
        EXPECT_NEAR(discs_Pa, std::fmin(tenth_Pa, element_Pa), 0.1);
        EXPECT_GT(std::fabs(element_Pa), strain == 0 ? -1 : 10 * std::fabs(tenth_Pa));
    }
    // What is discs from the beginning stands as prepared, with handover and without.
    const auto first = plan_to_discs(w.scene.soil, w.scene.dem, w.state.soil, middle).add;
    for (std::size_t n = 0; n < first.size(); ++n) {
        EXPECT_NEAR(first[n].y_m, w.state.soil.pattern[n].y_m + 0.05, 1e-15);
        EXPECT_EQ(first[n].inverse_mass_1_kg, w.state.soil.pattern[n].inverse_mass_1_kg);
    }
}

// ---- A wheel that drives over blocks --------------------------------------------------------------------------------

std::size_t count_made(const State& s, double kind) {
    return static_cast<std::size_t>(std::ranges::count_if(
        s.soil.conversions, [&](const ConversionRecord& r) { return r.kind == kind && r.refused == 0; }));
}

/// The conversions of a drive, which an interrupted and resumed one must make too, with the same bits.
std::vector<ConversionRecord> drive_and_resume(const Case& c) {
    World w = begin_travel(c);
    const State start = w.state;
    drive_through(w, c);
    if (testing::Test::HasFatalFailure()) return {};
    const auto& made = w.state.soil.conversions;
    for (const ConversionRecord& r : made)
        std::printf(
            "step %5.0f: block %2.0f %s%s, discs %.0f -> %.0f, attached %.0f, mass %+.4f kg, momentum %+.1e %+.1e Ns, "
            "surface %+.2f mm\n",
            r.step, r.block, r.kind == 0 ? "to discs  " : "to element", r.refused != 0 ? " refused" : "",
            r.before.discs, r.after.discs, r.attached,
            r.after.disc_mass_kg + r.after.element_mass_kg - r.before.disc_mass_kg - r.before.element_mass_kg,
            r.after.momentum_x_Ns - r.before.momentum_x_Ns, r.after.momentum_y_Ns - r.before.momentum_y_Ns,
            1e3 * (r.after.surface_m - r.before.surface_m));
    EXPECT_GE(count_made(w.state, 0), 1U);
    EXPECT_GE(count_made(w.state, 1), 1U);
    if (made.empty()) return made;

    // Interrupted at the boundary at which the first conversion is due, and again in the middle between two looks.
    for (const std::int64_t stop :
         {static_cast<std::int64_t>(made[0].step), static_cast<std::int64_t>(made[0].step) + 730})
        expect_same_end_after_a_stop(c, start, stop, w.state);
    return made;
}

TEST(Drive, converts_in_front_and_behind_with_the_same_bits_after_a_resume) { drive_and_resume(make_drive()); }

TEST(Drive, keeps_the_soils_mass_where_it_is_handed_over) {
    Case c = make_drive();
    c.elements.stress_handover = StressHandover::mean;
    for (const ConversionRecord& r : drive_and_resume(c))
        EXPECT_NEAR(r.after.disc_mass_kg + r.after.element_mass_kg, r.before.disc_mass_kg + r.before.element_mass_kg,
                    1e-12 * r.before.element_mass_kg);
}

// Nothing would carry the wheel there, and forces would only be too small.
TEST(Drive, is_stopped_where_the_discs_end) {
    Case c = make_drive();
    c.elements.conversion_interval_steps = 0;
    c.travel.distance_m = 0.4;
    World w = begin_travel(c);
    std::optional<Violation> fault;
    for (std::uint64_t n = 0; n < steps_of_stage(c, Stage::travel) && !fault; n += 50) {
        advance(w, 50);
        fault = check_health(w.scene, w.state, w.work);
    }
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(cause_name(fault->cause), cause_name(Cause::beyond_discs)) << to_text(*fault);
    const double discs_end_m = 5 * c.elements.block_length_m;
    EXPECT_LT(w.state.wheel.rim.position_m.x, discs_end_m) << "before the hub is above the elements";
}

}  // namespace
}  // namespace ifedem

// Seeded failures: each must be found by the checks of a run, with the right cause; abrupt ones within 100 steps of
// the first violated quantity, gradual ones within a tenth of the stage. And scenes that are well must pass.
#include <gtest/gtest.h>

#include <limits>

#include "support/failing_runs.hpp"

namespace ifedem {
namespace {

using scene::Outcome;

/// One settled bed for all seeds that need one.
const State& settled_bed() {
    static const State bed = scene::settle(scene::small_case());
    return bed;
}

struct Seed {
    const char* name;
    Stage stage;
    Cause cause;
    void (*change)(Case&);
    std::function<void(State&, std::uint64_t)> tamper = nullptr;
};

std::ostream& operator<<(std::ostream& out, const Seed& seed) { return out << seed.name; }

enum class Begin { poured, settled };

Outcome run_seed(const Seed& seed, Begin begin) {
    Case c = scene::small_case();
    seed.change(c);
    const bool predicts = c.integrator != Integrator::symplectic_euler;
    const Case usual = scene::small_case();
    const bool same_bed = c.bed.disc_count == usual.bed.disc_count && c.bed.walls == usual.bed.walls;
    State state = begin == Begin::poured ? make_initial_state(c) : same_bed ? settled_bed() : scene::settle(c);
    if (predicts) state.discs.acceleration.resize(state.discs.disc.size());
    if (seed.stage == Stage::travel) {
        const Outcome before = scene::watch_stage(c, Stage::sinkage, state, false);
        EXPECT_FALSE(before.found) << to_text(*before.found);
    }
    return scene::watch_stage(c, seed.stage, state, true, seed.tamper);
}

const double nan = std::numeric_limits<double>::quiet_NaN();

void as_it_is(Case&) {}

Disc& highest(State& state) {
    return *std::max_element(state.discs.disc.begin(), state.discs.disc.end(),
                             [](const Disc& a, const Disc& b) { return a.y_m < b.y_m; });
}

/// The first by number of the largest discs: list positions change.
Disc& largest(State& state) {
    std::size_t at = 0;
    for (std::size_t p = 0; p < state.discs.disc.size(); ++p) {
        const double here = state.discs.disc[p].radius_m, best = state.discs.disc[at].radius_m;
        if (here > best || (here == best && state.discs.id[p] < state.discs.id[at])) at = p;
    }
    return state.discs.disc[at];
}

const Seed abrupt[] = {
    // Contacts: springs.
    {"step beyond a pair's limit", Stage::consolidation, Cause::contact_step, [](Case& c) { c.time_step_s = 5e-4; }},
    {"contacts a hundred times stiffer", Stage::consolidation, Cause::contact_step,
     [](Case& c) { c.contact.normal_stiffness_N_m = 1e7, c.contact.tangential_stiffness_N_m = 2.5e6; }},
    {"discs a hundredth as heavy", Stage::consolidation, Cause::contact_step,
     [](Case& c) { c.soil.density_kg_m3 = 26; }},
    {"discs a hundredth as heavy, on a settled bed", Stage::sinkage, Cause::contact_step,
     [](Case& c) { c.soil.density_kg_m3 = 26; },
     [](State& s, std::uint64_t step) {
         for (Disc& d : s.discs.disc)
             if (step == 0) d.inverse_mass_1_kg *= 100;
     }},
    {"modified Euler, one evaluation", Stage::consolidation, Cause::contact_step,
     [](Case& c) { c.integrator = Integrator::modified_euler_one, c.time_step_s = 2e-4; }},
    {"modified Euler, two evaluations", Stage::consolidation, Cause::contact_step,
     [](Case& c) { c.integrator = Integrator::modified_euler_two, c.time_step_s = 3e-4; }},
    // Contacts: dashpots.
    {"damping ratio 2", Stage::consolidation, Cause::contact_dashpot,
     [](Case& c) { c.contact.damping_ratio = 2, c.time_step_s = 8e-5; }},
    // The wheel's elements.
    {"elastic rim at the step of a rigid one", Stage::sinkage, Cause::element_step,
     [](Case& c) { c.wheel.body = WheelBody::elastic; }},
    {"surface layer a hundred times stiffer", Stage::sinkage, Cause::element_step,
     [](Case& c) { c.wheel.surface.young_Pa = 4e8; }},
    {"light lugs", Stage::sinkage, Cause::element_step, [](Case& c) { c.wheel.lug.density_kg_m3 = 30; }},
    {"nearly incompressible in plane strain", Stage::sinkage, Cause::element_step,
     [](Case& c) { c.wheel.plane = PlaneState::strain, c.wheel.surface.poisson = 0.4999; }},
    {"fine mesh", Stage::sinkage, Cause::element_step, [](Case& c) { c.wheel.surface_rings = 16; }},
    // Explicit control.
    {"explicit drawbar loop, derivative gain", Stage::sinkage, Cause::control_step,
     [](Case& c) { c.control.scheme = ControlScheme::explicit_, c.control.drawbar.derivative = 1e6; }},
    {"explicit drawbar loop, proportional gain", Stage::sinkage, Cause::control_step,
     [](Case& c) { c.control.scheme = ControlScheme::explicit_, c.control.drawbar.proportional = 1e11; }},
    {"explicit torque loop at twice the step", Stage::sinkage, Cause::control_step,
     [](Case& c) { c.control.scheme = ControlScheme::explicit_, c.time_step_s = 8e-5; }},
    // Coupling.
    {"tread nodes far lighter than discs", Stage::sinkage, Cause::coupling_step,
     [](Case& c) { c.wheel.lug.density_kg_m3 = 5, c.wheel.lug.young_Pa = 4e2; }},
    {"a disc shot at the wheel", Stage::sinkage, Cause::tunnelling, as_it_is,
     [](State& s, std::uint64_t step) {
         if (step == 70) highest(s).vy_m_s = 500;
     }},
    {"a disc inside the wheel", Stage::sinkage, Cause::tunnelling, as_it_is,
     [](State& s, std::uint64_t step) {
         if (step == 70) highest(s).x_m = s.wheel.rim.position_m.x, highest(s).y_m = s.wheel.rim.position_m.y + 0.1;
     }},
    {"a disc between two lugs", Stage::sinkage, Cause::wedged,
     [](Case& c) { c.wheel.lug_gap_m = 0.0005, c.wheel.body = WheelBody::rigid; },
     [](State& s, std::uint64_t step) {
         if (step < 70) return;
         Disc& d = largest(s);
         const double angle = s.wheel.rim.angle_rad + (0.006 + 0.00025) / 0.15;  // the middle of the first gap
         d.x_m = s.wheel.rim.position_m.x + 0.1541 * std::cos(angle);
         d.y_m = s.wheel.rim.position_m.y + 0.1541 * std::sin(angle);
         d.vx_m_s = d.vy_m_s = 0;
     }},
    // Loads.
    {"contacts a thousandth as stiff", Stage::sinkage, Cause::contact_overload,
     [](Case& c) { c.contact.normal_stiffness_N_m = 100, c.contact.tangential_stiffness_N_m = 25; }},
    {"a soft layer", Stage::sinkage, Cause::element_overload,
     [](Case& c) { c.wheel.intermediate.young_Pa = 500, c.wheel.load_N = 1000; }},
    // The state.
    {"a disc is not a number", Stage::consolidation, Cause::not_a_number, as_it_is,
     [](State& s, std::uint64_t step) {
         if (step == 120) s.discs.disc[5].vx_m_s = nan;
     }},
    {"a node is not a number", Stage::sinkage, Cause::not_a_number, as_it_is,
     [](State& s, std::uint64_t step) {
         if (step == 120) s.wheel.velocity_m_s[200].x = nan;
     }},
    {"two discs in one place", Stage::sinkage, Cause::not_a_number, as_it_is,
     [](State& s, std::uint64_t step) {
         if (step == 120) s.discs.disc[5].x_m = s.discs.disc[6].x_m, s.discs.disc[5].y_m = s.discs.disc[6].y_m;
     }},
    {"a disc thrown over a wall of discs", Stage::consolidation, Cause::lost_disc,
     [](Case& c) { c.bed.walls = WallKind::discs; },
     [](State& s, std::uint64_t step) {
         if (step == 60) highest(s).x_m = 0.02, highest(s).y_m = 0.2, highest(s).vx_m_s = -5;
     }},
    // The scene.
    {"a bed that does not carry yet", Stage::sinkage, Cause::loose_bed, as_it_is,
     [](State& s, std::uint64_t step) {
         for (Disc& d : s.discs.disc)
             if (step == 0) d.y_m *= 1.5;
     }},
    {"hardly any soil", Stage::sinkage, Cause::shallow_bin, [](Case& c) { c.bed.disc_count = 120; }},
    {"a wheel driven against the end wall", Stage::travel, Cause::short_bin,
     [](Case& c) {
         c.wheel.load_N = 20, c.wheel.body = WheelBody::rigid, c.travel.distance_m = 0.4, c.travel.speed_m_s = 5;
         c.travel.slip_percent = 0;
     }},
};

class Abrupt : public testing::TestWithParam<Seed> {};

TEST_P(Abrupt, IsFoundWithinAHundredSteps) {
    const Outcome o = run_seed(GetParam(), GetParam().stage == Stage::consolidation ? Begin::poured : Begin::settled);
    ASSERT_TRUE(o.found) << "not found in " << o.steps << " steps";
    EXPECT_EQ(cause_name(o.found->cause), cause_name(GetParam().cause)) << to_text(*o.found);
    EXPECT_FALSE(o.found->remedy.empty());
    EXPECT_GT(o.first_seen, 0U) << to_text(*o.found);
    EXPECT_LE(o.steps - o.first_seen, 100U) << to_text(*o.found);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Abrupt, testing::ValuesIn(abrupt));

// A settled bed at rest, or a wheel sunk into it, for a second: what is wrong begins with the stage.
const Seed gradual[] = {
    {"bed heated by springs", Stage::consolidation, Cause::contact_step, [](Case& c) { c.time_step_s = 1.6e-4; }},
    {"bed heated by springs with hardly any damping", Stage::consolidation, Cause::contact_step,
     [](Case& c) { c.time_step_s = 1.8e-4, c.contact.damping_ratio = 0.05; }},
    {"bed heated by dashpots", Stage::consolidation, Cause::contact_dashpot,
     [](Case& c) { c.time_step_s = 1.2e-4, c.contact.damping_ratio = 0.7; }},
    {"bed heated by dashpots, near the limit", Stage::consolidation, Cause::contact_dashpot,
     [](Case& c) { c.time_step_s = 8e-5, c.contact.damping_ratio = 0.7; }},
    {"bed heated under modified Euler, one evaluation", Stage::consolidation, Cause::contact_step,
     [](Case& c) { c.integrator = Integrator::modified_euler_one, c.time_step_s = 1.2e-4; }},
    {"energy put in from outside", Stage::consolidation, Cause::energy_drift, as_it_is,
     [](State& s, std::uint64_t) {
         for (Disc& d : s.discs.disc) d.vx_m_s *= 1.003, d.vy_m_s *= 1.003;
     }},
    {"rolling moment by the raw sign", Stage::sinkage, Cause::rolling_sign,
     [](Case& c) {
         c.contact.rolling_scheme = RollingScheme::sign, c.contact.rolling_factor = 4, c.stages.sinkage_s = 0.3;
     }},
    {"drawbar loop winding up", Stage::travel, Cause::control_windup,
     [](Case& c) {
         c.control.drawbar = {1e2, 1e6, 1e2};
     }},
    {"torque loop winding up", Stage::travel, Cause::control_windup,
     [](Case& c) {
         c.control.torque = {1, 1e3, 1};
     }},
    {"no drawbar loop", Stage::travel, Cause::control_weak,
     [](Case& c) {
         c.control.drawbar = {0, 0, 0};
     }},
    {"no torque loop", Stage::travel, Cause::control_weak,
     [](Case& c) {
         c.control.torque = {0, 0, 0};
     }},
};

class Gradual : public testing::TestWithParam<Seed> {};

TEST_P(Gradual, IsFoundWithinATenthOfTheRun) {
    const Outcome o = run_seed(GetParam(), Begin::settled);
    ASSERT_TRUE(o.found) << "not found in " << o.steps << " steps";
    EXPECT_EQ(cause_name(o.found->cause), cause_name(GetParam().cause)) << to_text(*o.found);
    EXPECT_FALSE(o.found->remedy.empty());
    const std::uint64_t onset = o.first_seen;  // of a control error; 0, the beginning, for heat
    EXPECT_LE(10 * (o.steps - onset), o.planned) << to_text(*o.found);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Gradual, testing::ValuesIn(gradual));

// What must pass: the scene that the seeds spoil, and its kin. The short case and chapter 3's runs pass through the
// same checks in their own tests and campaigns.
const Seed healthy[] = {
    {"as it is", Stage::travel, Cause::energy_drift, as_it_is},
    {"Mars", Stage::travel, Cause::energy_drift, [](Case& c) { c.gravity_m_s2 = 3.71, c.wheel.load_N = 64.4; }},
    {"rigid wheel", Stage::travel, Cause::energy_drift, [](Case& c) { c.wheel.body = WheelBody::rigid; }},
    {"elastic rim at its own step", Stage::travel, Cause::energy_drift,
     [](Case& c) { c.wheel.body = WheelBody::elastic, c.time_step_s = 2e-5; }},
    {"stiff intermediate layer", Stage::travel, Cause::energy_drift,
     [](Case& c) { c.wheel.intermediate.young_Pa = 0.3e6; }},
    {"no load", Stage::travel, Cause::energy_drift, [](Case& c) { c.wheel.load_N = 0; }},
    {"slip 70 %", Stage::travel, Cause::energy_drift, [](Case& c) { c.travel.slip_percent = 70; }},
    {"slip -5 %", Stage::travel, Cause::energy_drift, [](Case& c) { c.travel.slip_percent = -5; }},
    {"walls of discs", Stage::travel, Cause::energy_drift, [](Case& c) { c.bed.walls = WallKind::discs; }},
    {"modified Euler, two evaluations", Stage::travel, Cause::energy_drift,
     [](Case& c) { c.integrator = Integrator::modified_euler_two; }},
};

class Healthy : public testing::TestWithParam<Seed> {};

TEST_P(Healthy, Passes) {
    const Outcome o = run_seed(GetParam(), Begin::settled);
    EXPECT_FALSE(o.found) << to_text(*o.found);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Healthy, testing::ValuesIn(healthy));

/// Every disc is pushed once, to and fro in turn.
void push_once(State& s, std::uint64_t step) {
    if (step != 2000) return;
    for (std::size_t p = 0; p < s.discs.disc.size(); ++p)
        s.discs.disc[p].vx_m_s += s.discs.id[p] % 2 == 0 ? 0.02 : -0.02;
}

// What a conversion of soil gains or loses stands in its record and is no drift.
TEST(Healthy, ConversionOfSoilBeginsANewWindow) {
    const Seed alone{"energy put in once", Stage::consolidation, Cause::energy_drift, as_it_is, push_once};
    const Seed converted{"the same by a conversion", Stage::consolidation, Cause::energy_drift, as_it_is,
                         [](State& s, std::uint64_t step) {
                             push_once(s, step);
                             if (step == 2000) s.soil.conversions.emplace_back();
                         }};
    const Outcome found = run_seed(alone, Begin::settled), passed = run_seed(converted, Begin::settled);
    ASSERT_TRUE(found.found);
    EXPECT_EQ(cause_name(found.found->cause), cause_name(Cause::energy_drift)) << to_text(*found.found);
    EXPECT_FALSE(passed.found) << to_text(*passed.found);
}

TEST(Healthy, ConsolidationPassesFromTheBeginning) {
    for (const double gravity : {9.81, 3.71, 1.62}) {
        Case c = scene::small_case();
        c.gravity_m_s2 = gravity;
        State state = make_initial_state(c);
        const Outcome o = scene::watch_stage(c, Stage::consolidation, state, false);
        EXPECT_FALSE(o.found) << gravity << ": " << to_text(*o.found);
    }
}

}  // namespace
}  // namespace ifedem

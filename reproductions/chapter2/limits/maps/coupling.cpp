#include "core/bitmath.hpp"
#include "maps.hpp"
#include "support/growth.hpp"

namespace ifedem::maps {
namespace {

enum class Fate { bounced, sank, passed };

/// A disc of 2 mm shot straight at a smooth rigid tread. It passes where it ends inside, out of every contact's sight;
/// it sinks where its overlap exceeds the health check's limit but the contact turns it round.
Fate shoot(double step_share, double softness, double phase) {
    Case c;
    c.gravity_m_s2 = 0, c.wheel.load_N = 0, c.wheel.body = WheelBody::rigid, c.wheel.lug_pairs = 0;
    c.bed.disc_count = 1, c.contact.damping_ratio = 0;
    c.soil.radii_m = {0.002}, c.soil.radii_shares = {1};
    const double r = 0.002, mass = pi * r * r * c.soil.thickness_m * c.soil.density_kg_m3;
    // Speed v, step v Δt = share · r, stiffness √(m/K) v = softness · r.
    constexpr double speed = 1;
    c.time_step_s = step_share * r / speed;
    c.contact.normal_stiffness_N_m = mass * speed * speed / (softness * softness * r * r);
    c.contact.tangential_stiffness_N_m = 0.25 * c.contact.normal_stiffness_N_m;
    const Scene scene = make_scene(c, Stage::sinkage);
    State state = make_initial_state(c);
    state.wheel = place_wheel(scene.wheel, {0.75, 1});
    state.control.drawbar.target = 0.75;
    const auto& loop = scene.wheel.mesh.boundary;
    const Vec2 a = state.wheel.position_m[loop[0]], b = state.wheel.position_m[loop[1]];
    const Vec2 along = (1 / norm(b - a)) * (b - a), outward{along.y, -along.x};
    const Vec2 start = 0.5 * (a + b) + (r + (5 + phase) * speed * c.time_step_s) * outward;
    Disc& d = state.discs.disc[0];
    d.x_m = start.x, d.y_m = start.y;
    d.vx_m_s = -speed * outward.x, d.vy_m_s = -speed * outward.y;
    Workspace work = make_workspace(scene, state);
    bool deep = false;
    const int steps = static_cast<int>(20 + 20 * softness / step_share);
    for (int n = 0; n < steps; ++n) {
        step(scene, state, work);
        deep |= work.wheel.largest_overlap_share > c.health.overlap_limit;
        const Disc& now = state.discs.disc[0];
        if (-distance_to_wheel_m(scene.wheel, state.wheel, {now.x_m, now.y_m}) > now.radius_m) return Fate::passed;
    }
    return deep ? Fate::sank : Fate::bounced;
}

void map_passing(Output& out) {
    const bool quick = out.effort == Effort::quick;
    std::string text = "step_share,softness,passed,sank\n";
    const double stride = quick ? 2.5 : 1.35;
    for (double softness = 0.03; softness < 3; softness *= stride) {
        for (double share = 0.05; share < 6; share *= stride) {
            int passed = 0, sank = 0;
            constexpr int phases = 8;
            for (int k = 0; k < phases; ++k) {
                const Fate f = shoot(share, softness, (k + 0.5) / phases);
                passed += f == Fate::passed, sank += f == Fate::sank;
            }
            text += fmt::format("{:.4g},{:.4g},{},{}\n", share, softness, passed / static_cast<double>(phases),
                                sank / static_cast<double>(phases));
        }
        text += "\n";
    }
    out.write("passing.csv", text);
    // The first of a stiff surface, on a finer scale.
    double first = 0;
    for (double share = 1.8; share < 3 && first == 0; share += 0.02)
        for (int k = 0; k < 200; ++k)
            if (first == 0 && shoot(share, 0.01, (k + 0.5) / 200) == Fate::passed) first = share;
    out.measured("passing_first_share", first, "-",
                 "speed × step over radius at which the first disc passes a stiff surface");
}

/// A smooth disc that its weight presses into a corner of two faces, as between lug and tread (90°) or, nearly
/// parallel, wedged between two lugs. Its faces are the walls', whose law is the wheel's.
scene::World make_corner(double opening, double zeta, double step_s) {
    constexpr double radius = 0.002, mass = 0.0032, overlap = 2e-5, K = scene::stiffness_N_m;
    DemConstants k = scene::make_dem(scene::make_contact(K, 0.25 * K, 0.0), zeta, step_s);
    const double half = 0.5 * opening;
    k.flat_walls = {{{0, 0}, {-std::cos(half), std::sin(half)}}, {{0, 0}, {std::cos(half), std::sin(half)}}};
    k.gravity_m_s2 = {0, -2 * K * overlap * std::sin(half) / mass};
    return scene::make_world(k, {scene::make_disc({0, (radius - overlap) / std::sin(half)}, radius, mass)},
                             Integrator::symplectic_euler);
}

/// Whether a small disturbance, along and across the bisector, grows a thousandfold.
bool corner_grows(double opening, double zeta, double step_s) {
    constexpr double start = 1e-6;
    return scene::grows(make_corner(opening, zeta, step_s), start,
                        [&](std::vector<Disc>& discs) { discs[0].vx_m_s = start, discs[0].vy_m_s = 0.9 * start; });
}

/// Both faces' springs act on the disc: the stiffer direction has K (1 + |cos β|), twice K where the faces are
/// parallel.
void map_corner(Output& out) {
    std::string text = "opening_deg,zeta,predicted,measured\n";
    const double unit = 2 * std::sqrt(0.0032 / scene::stiffness_N_m);
    double worst = 0;
    for (const double zeta : {0.05, 0.2, 0.7}) {
        for (double degrees = 10; degrees < 175; degrees += out.effort == Effort::quick ? 40 : 10) {
            const double opening = degrees * pi / 180, faces = std::sqrt(1 + std::fabs(std::cos(opening)));
            const double predicted =
                unit * largest_stable_phase(Integrator::symplectic_euler, zeta * faces) / (2 * faces);
            const double measured = scene::measure_largest_step(
                0.5 * predicted, 2 * predicted, [&](double dt) { return corner_grows(opening, zeta, dt); });
            text += fmt::format("{},{},{:.5f},{:.5f}\n", degrees, zeta, predicted / unit, measured / unit);
            worst = std::max(worst, std::fabs(measured / predicted - 1));
        }
        text += "\n";
    }
    out.write("corner.csv", text);
    out.measured("corner_limit_error", worst, "-", "largest |measured/predicted − 1| of a disc between two faces");
}

/// The frozen scene's limit as contacts stiffen against the elements under them.
void map_ratio(Output& out) {
    Case base = scene::small_case();
    base.stages.consolidation_s = 0.5;
    const State bed = scene::settle(base);
    std::string text = "stiffness_N_m,pair_s,bed_s,wheel_s,coupling_s,together_s,survived_s,failed_s\n";
    const bool quick = out.effort == Effort::quick;
    for (const double factor : quick ? std::vector<double>{1} : std::vector<double>{0.03, 0.3, 1, 3, 10}) {
        Case c = base;
        c.contact.normal_stiffness_N_m *= factor, c.contact.tangential_stiffness_N_m *= factor;
        c.wheel.load_N = 170 * std::min(1.0, 3 * factor);
        c.stages.sinkage_s = 0.15;
        c.time_step_s = 4e-5 / std::max(1.0, std::sqrt(factor));
        State sunk = bed;
        static_cast<void>(scene::watch_stage(c, Stage::sinkage, sunk, false));
        const Scene scene = make_scene(c, Stage::sinkage);
        double pair = 0, wheel = 0, coupling = 0, bed_s = 0, together = 0;
        for (const StepLimit& l : find_case_limits(scene)) {
            if (l.name == "an isolated pair of the smallest discs") pair = l.step_s;
            if (l.name == "the whole wheel") wheel = l.step_s;
            if (l.group == LimitGroup::coupling) coupling = l.step_s;
        }
        for (const StepLimit& l : find_frozen_limits(scene, sunk))
            (l.group == LimitGroup::everything ? together : bed_s) = l.step_s;
        double survived = 0, failed = 0;
        for (double share = 0.7; share < 4 && failed == 0; share *= 1.1) {
            Case d = c;
            d.time_step_s = share * together, d.stages.sinkage_s = 0.05;
            State state = sunk;
            const Scene again = make_scene(d, Stage::sinkage);
            Workspace work = make_workspace(again, state);
            std::optional<Violation> v;
            for (std::uint64_t n = 1; n <= steps_of_stage(d, Stage::sinkage) && !v; ++n) {
                step(again, state, work);
                if (n % 10 == 0) v = check_health(again, state, work);
            }
            (v ? failed : survived) = d.time_step_s;
        }
        text += fmt::format("{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g}\n", c.contact.normal_stiffness_N_m,
                            pair, bed_s, wheel, coupling, together, survived, failed);
        if (factor == 1)
            out.measured("wheel_on_bed_blown_over_predicted", failed / together, "-",
                         "blow-up of a sunk B3 over its frozen limit");
    }
    out.write("ratio.csv", text);
}

}  // namespace

void map_coupling(Output& out) {
    map_passing(out);
    map_corner(out);
    map_ratio(out);
}

}  // namespace ifedem::maps

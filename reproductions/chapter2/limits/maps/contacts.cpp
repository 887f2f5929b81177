#include "core/bitmath.hpp"
#include "maps.hpp"
#include "support/growth.hpp"

namespace ifedem::maps {
namespace {

const Integrator integrators[] = {Integrator::symplectic_euler, Integrator::modified_euler_one,
                                  Integrator::modified_euler_two};
const char* const names[] = {"symplectic", "modified-1", "modified-2"};

/// 300 discs of chapter 3 at rest; poured with friction they have fewer contacts.
Case bed_case(double friction) {
    Case c;
    c.bed.disc_count = 300;
    c.bed.length_m = 0.15;
    c.contact.consolidation_friction_soil = c.contact.consolidation_friction_wall = friction;
    return c;
}

State settled_bed(double friction) {
    Case c = bed_case(friction);
    c.contact.damping_ratio = 0.4;
    c.stages.consolidation_s = 1.5;
    return scene::settle(c);
}

double contacts_a_disc(const State& state) {
    double contacts = 0;
    for (std::size_t n = 0; n < state.pairs.i.size(); ++n) {
        const Disc &a = state.discs.disc[state.pairs.i[n]], &b = state.discs.disc[state.pairs.j[n]];
        if (norm({a.x_m - b.x_m, a.y_m - b.y_m}) < a.radius_m + b.radius_m) contacts += 2;
    }
    return contacts / static_cast<double>(state.discs.disc.size());
}

/// Kinetic energy of a disc over that of a fall by its own diameter, mean over the second half of the time: the bed's
/// temperature; infinite if it blew up.
double temperature_after(const Case& c, State state, double seconds) {
    const Scene scene = make_scene(c, Stage::consolidation);
    begin_stage(scene, state);
    if (c.integrator != Integrator::symplectic_euler) state.discs.acceleration.resize(state.discs.disc.size());
    Workspace work = make_workspace(scene, state);
    double fall = 0;
    for (const Disc& d : state.discs.disc) fall += 2 * d.radius_m * c.gravity_m_s2 / d.inverse_mass_1_kg;
    const auto steps = static_cast<int>(std::lround(seconds / c.time_step_s));
    double sum = 0;
    int samples = 0;
    for (int n = 1; n <= steps; ++n) {
        step(scene, state, work);
        if (n % 10 != 0) continue;
        const double hot = measure_energy(scene, state, work).kinetic_discs_J / fall;
        if (!(hot < 10) || check_health(scene, state, work)) return std::numeric_limits<double>::infinity();
        if (n > steps / 2) sum += hot, ++samples;
    }
    return sum / samples;
}

struct Boundary {
    double predicted_s = 0, heated_s = 0, blown_s = 0;
};

/// Steps from 0.9 times the prediction upwards by 4 %.
Boundary find_boundary(const Case& base, const State& bed, double seconds) {
    Case c = base;
    const Scene scene = make_scene(c, Stage::consolidation);
    const FrozenMode mode = find_failing_mode(scene, bed, Movable::discs);
    Boundary b;
    b.predicted_s = largest_stable_phase(c.integrator, mode.damping_ratio) / mode.omega_rad_s;
    constexpr double hot = 1e-5;
    for (double share = 0.9; share < 6 && b.blown_s == 0; share *= 1.04) {
        c.time_step_s = share * b.predicted_s;
        const double t = temperature_after(c, bed, seconds);
        if (b.heated_s == 0 && t > hot) b.heated_s = c.time_step_s;
        if (!std::isfinite(t)) b.blown_s = c.time_step_s;
    }
    return b;
}

void map_beds(Output& out, double unit_s) {
    const bool quick = out.effort == Effort::quick;
    const std::vector<double> zetas = quick ? std::vector<double>{0.2} : std::vector<double>{0.05, 0.2, 0.4, 0.7, 1.0};
    std::string text = "integrator,zeta,friction,contacts,predicted,heated,blown,heated_over_predicted\n";
    for (const double friction : quick ? std::vector<double>{0.0} : std::vector<double>{0.0, 0.6}) {
        const State bed = settled_bed(friction);
        double least = 1e9, most = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const double zeta : zetas) {
                Case c = bed_case(friction);
                c.integrator = integrators[k], c.contact.damping_ratio = zeta;
                const Boundary b = find_boundary(c, bed, quick ? 0.05 : 0.15);
                text += fmt::format("{},{},{},{:.3f},{:.4f},{:.4f},{:.4f},{:.3f}\n", names[k], zeta, friction,
                                    contacts_a_disc(bed), b.predicted_s / unit_s, b.heated_s / unit_s,
                                    b.blown_s / unit_s, b.heated_s / b.predicted_s);
                least = std::min(least, b.heated_s / b.predicted_s);
                most = std::max(most, b.heated_s / b.predicted_s);
            }
        }
        const char* of = friction > 0 ? "friction" : "smooth";
        out.measured(fmt::format("bed_{}_heated_over_predicted_least", of), least, "-",
                     "first heating / frozen network over integrators and ζ");
        out.measured(fmt::format("bed_{}_heated_over_predicted_most", of), most, "-", "the same");
    }
    out.write("contacts_bed.csv", text);
}

void map_columns(Output& out) {
    const bool quick = out.effort == Effort::quick;
    std::string text = "integrator,zeta,discs,predicted,measured\n";
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k)
        for (const double zeta : {0.05, 0.1, 0.2, 0.4, 0.7, 1.0})
            for (const int count : quick ? std::vector<int>{2} : std::vector<int>{1, 2, 5}) {
                scene::World w = scene::make_squeezed_column(count, zeta, 1e-6, integrators[k]);
                scene::advance(w, 1);
                const FrozenMode mode = find_failing_mode(w.scene, w.state, Movable::everything);
                const double predicted = largest_stable_phase(integrators[k], mode.damping_ratio) / mode.omega_rad_s;
                const double measured = scene::measure_largest_step(0.5 * predicted, 2 * predicted, [&](double dt) {
                    return scene::column_grows(count, zeta, dt, integrators[k]);
                });
                const double unit = 2 * std::sqrt(0.0032 / scene::stiffness_N_m);
                text +=
                    fmt::format("{},{},{},{:.5f},{:.5f}\n", names[k], zeta, count, predicted / unit, measured / unit);
                worst = std::max(worst, std::fabs(measured / predicted - 1));
            }
    out.write("contacts_exact.csv", text);
    out.measured("column_limit_error", worst, "-", "largest |measured/predicted − 1| of 1 to 5 squeezed discs");
}

void map_temperature(Output& out) {
    const bool quick = out.effort == Effort::quick;
    const State bed = settled_bed(0);
    std::string text = "zeta,step_s,temperature,predicted_s\n";
    for (const double zeta :
         quick ? std::vector<double>{0.2, 0.7} : std::vector<double>{0.05, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0}) {
        Case c = bed_case(0);
        c.contact.damping_ratio = zeta;
        const FrozenMode mode = find_failing_mode(make_scene(c, Stage::consolidation), bed, Movable::discs);
        const double predicted = largest_stable_phase(c.integrator, mode.damping_ratio) / mode.omega_rad_s;
        for (double dt = 2e-5; dt < 2.3e-4; dt *= quick ? 1.5 : 1.2) {
            c.time_step_s = dt;
            const double t = temperature_after(c, bed, quick ? 0.05 : 0.2);
            text += fmt::format("{},{:.4g},{:.4g},{:.4g}\n", zeta, dt, std::isfinite(t) ? std::max(t, 1e-12) : 10.0,
                                predicted);
        }
        text += "\n";
    }
    out.write("temperature.csv", text);
}

}  // namespace

void map_contacts(Output& out) {
    const Case c;
    const double unit_s =
        2 * std::sqrt(pi * 4e-6 * c.soil.thickness_m * c.soil.density_kg_m3 / c.contact.normal_stiffness_N_m);
    map_columns(out);
    map_beds(out, unit_s);
    map_temperature(out);
    out.measured("default_step_units", c.time_step_s / unit_s, "-", "4e-5 s in units of 2 √(m_min/K_n)");
    out.measured("text_step_units", 1e-5 / unit_s, "-", "the text's 1e-5 s");
}

}  // namespace ifedem::maps

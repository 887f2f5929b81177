#include "fem/radial_stiffness.hpp"
#include "maps.hpp"
#include "support/growth.hpp"

namespace ifedem::maps {
namespace {

/// The wheel alone, falling free, its nodes disturbed by a tenth of a nanometre: does the strain energy grow?
struct FreeWheel {
    Scene scene;
    State state;
};

FreeWheel make_free_wheel(const Case& base) {
    Case c = base;
    c.wheel.load_N = 0, c.gravity_m_s2 = 0, c.bed.disc_count = 1;
    FreeWheel w{make_scene(c, Stage::sinkage), make_initial_state(c)};
    w.state.wheel = place_wheel(w.scene.wheel, {0.75, 1.0});
    w.state.control.drawbar.target = 0.75;
    Random random{7};
    for (const std::uint32_t n : w.scene.wheel.free_node)
        w.state.wheel.position_m[n] += 1e-10 * Vec2{random.uniform() - 0.5, random.uniform() - 0.5};
    w.state.wheel.rim.position_m.y = 1.0;
    return w;
}

bool wheel_grows(const Case& c, double step_s) {
    FreeWheel w = make_free_wheel(c);
    w.scene.dem.step_s = step_s;
    Workspace work = make_workspace(w.scene, w.state);
    const double start = strain_energy_J(w.scene.wheel.elements, w.state.wheel.position_m);
    for (int n = 0; n < 1000; ++n) {
        step(w.scene, w.state, work);
        if (n % 50 != 0) continue;
        if (!(strain_energy_J(w.scene.wheel.elements, w.state.wheel.position_m) < 1e4 * start)) return true;
    }
    return false;
}

StepLimit limit_named(const std::vector<StepLimit>& limits, std::string_view part) {
    for (const StepLimit& l : limits)
        if (l.name.find(part) != std::string::npos) return l;
    return {};
}

/// One row: element bound of the softest part, whole mesh predicted and measured.
std::string element_row(const std::string& group, double x, const Case& c, double& worst) {
    const auto limits = find_case_limits(make_scene(c, Stage::sinkage));
    double element = 1;
    for (const StepLimit& l : limits)
        if (l.group == LimitGroup::elements && l.kind == LimitKind::safe) element = std::min(element, l.step_s);
    const double whole = limit_named(limits, "whole wheel").step_s;
    const double measured =
        scene::measure_largest_step(0.7 * whole, 1.5 * whole, [&](double dt) { return wheel_grows(c, dt); });
    worst = std::max(worst, std::fabs(measured / whole - 1));
    return fmt::format("{},{:.6g},{:.5g},{:.5g},{:.5g}\n", group, x, element, whole, measured);
}

void map_steps(Output& out) {
    const bool quick = out.effort == Effort::quick;
    std::string text = "group,x,element_s,predicted_s,measured_s\n";
    double worst = 0;
    for (const int factor : quick ? std::vector<int>{1} : std::vector<int>{1, 2, 3}) {
        Case c;
        c.wheel.intermediate_rings *= factor, c.wheel.surface_rings *= factor;
        text += element_row("layers", factor, c, worst);
    }
    text += "\n\n";
    for (const int rings : quick ? std::vector<int>{2} : std::vector<int>{1, 2, 3, 4, 6}) {
        Case c;
        c.wheel.body = WheelBody::elastic, c.wheel.rim_rings = rings;
        text += element_row("rim", rings, c, worst);
    }
    text += "\n\n";
    for (const PlaneState plane : {PlaneState::strain, PlaneState::stress}) {
        for (const double gap :
             quick ? std::vector<double>{0.01} : std::vector<double>{0.2, 0.03, 0.01, 3e-3, 1e-3, 1e-4}) {
            Case c;
            c.wheel.plane = plane, c.wheel.surface.poisson = 0.5 - gap;
            text += element_row(plane == PlaneState::strain ? "strain" : "stress", gap, c, worst);
        }
        text += "\n\n";
    }
    out.write("elements.csv", text);
    out.measured("element_limit_error", worst, "-", "largest |measured/predicted − 1| of free wheels");
}

void map_locking(Output& out) {
    std::string text = "gap,strain_N_mm,stress_N_mm\n";
    double at_49 = 0, at_4999 = 0;
    for (const double gap : {0.2, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4}) {
        double k[2] = {0, 0};
        for (const PlaneState plane : {PlaneState::strain, PlaneState::stress}) {
            WheelCase w;
            w.plane = plane, w.surface.poisson = w.lug.poisson = 0.5 - gap;
            const auto rows = press_on_plane(w, std::vector<double>{0.002, 0.004, 0.006}, 0);
            k[plane == PlaneState::strain ? 0 : 1] = 1e-3 * rows.back().load_N / rows.back().deflection_m;
        }
        if (gap == 0.01) at_49 = k[0];
        at_4999 = k[0];
        text += fmt::format("{},{:.4f},{:.4f}\n", gap, k[0], k[1]);
    }
    out.write("locking.csv", text);
    out.measured("locking_strain", at_4999 / at_49, "-",
                 "radial stiffness in plane strain at ν = 0.4999 over that at 0.49");
}

/// The load at which an element of the wheel inverts while it sinks into a bed.
void map_inversion(Output& out) {
    const bool quick = out.effort == Effort::quick;
    Case base = scene::small_case();
    const State bed = scene::settle(base);
    std::string text = "young_kPa,plane_estimate_N,survived_N,inverted_N\n";
    for (const double young :
         quick ? std::vector<double>{0.05e6} : std::vector<double>{0.0125e6, 0.025e6, 0.05e6, 0.1e6, 0.2e6}) {
        Case c = base;
        c.wheel.intermediate.young_Pa = young;
        c.stages.sinkage_s = 0.25;
        const auto rows = press_on_plane(c.wheel, std::vector<double>{0.002, 0.004}, 0);
        // The layer is used up: its stiffness over its own thickness of 40 mm.
        const double estimate = rows.back().load_N / rows.back().deflection_m *
                                (c.wheel.tread_radius_m - c.wheel.surface_thickness_m - c.wheel.rim_radius_m);
        double survived = 0, inverted = 0;
        for (double load = 0.2 * estimate; load < 20 * estimate && inverted == 0; load *= 1.4) {
            c.wheel.load_N = load;
            State state = bed;
            const scene::Outcome o = scene::watch_stage(c, Stage::sinkage, state, false);
            if (o.found && o.found->cause == Cause::element_overload)
                inverted = load;
            else if (o.found)
                break;
            else
                survived = load;
        }
        text += fmt::format("{:.4g},{:.1f},{:.1f},{:.1f}\n", 1e-3 * young, estimate, survived, inverted);
        if (young == 0.05e6)
            out.measured("inversion_load_B3_N", inverted, "N",
                         "first load on B3 that inverts an element in free sinkage (steps of 40 %)");
    }
    out.write("inversion.csv", text);
}

}  // namespace

void map_elements(Output& out) {
    map_steps(out);
    map_locking(out);
    map_inversion(out);
}

}  // namespace ifedem::maps

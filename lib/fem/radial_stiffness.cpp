#include "fem/radial_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "fem/mesh.hpp"

namespace ifedem {
namespace {

/// A wheel whose hub stays at the origin while the plane rises.
struct Press {
    ElementSet set;
    Supports supports;
    RigidPlane plane;
    double first_touch_m = 0;  ///< height of the lowest node
    StaticState state;
    double deflection_m = 0;
};

void hold(Supports& supports, std::uint32_t node) { supports.held[2 * node] = supports.held[2 * node + 1] = 1; }

Press set_up(WheelCase wheel, double phase_deg, PlaneFriction friction) {
    if (wheel.body == WheelBody::rigid || wheel.shape == WheelShape::plate) {
        fail_input(
            "a rigid wheel has no radial stiffness (nothing in it deforms). Set wheel.body to rigid-rim or elastic?");
    }
    wheel.lug_phase_deg += phase_deg;
    const WheelMesh wheel_mesh = make_wheel_mesh(wheel);
    const std::vector<Vec2>& node = wheel_mesh.mesh.node_m;
    Press press;
    press.set = make_elements(wheel_mesh.mesh, wheel_materials(wheel), wheel_widths_m(wheel), wheel.plane);
    press.supports = {std::vector<std::uint8_t>(2 * node.size(), 0), std::vector<Vec2>(node.size())};
    for (const std::uint32_t k : wheel_mesh.rigid) hold(press.supports, k);
    if (wheel_mesh.hub != WheelMesh::no_node) {
        const auto higher = [&](std::uint32_t a, std::uint32_t b) { return node[a].y < node[b].y; };
        const std::vector<std::uint32_t>& rim = wheel_mesh.rim_surface;
        hold(press.supports, wheel_mesh.hub);
        press.supports.held[2 * *std::max_element(rim.begin(), rim.end(), higher)] = 1;
    }
    const auto lower = [](Vec2 a, Vec2 b) { return a.y < b.y; };
    press.first_touch_m = std::min_element(node.begin(), node.end(), lower)->y;
    press.plane.friction = friction;
    press.state = {node, std::vector<std::uint8_t>(node.size(), 0)};
    return press;
}

/// Raises the plane in increments that Newton can follow; they matter for the result only where nodes stick.
void press_to(Press& press, double deflection_m) {
    constexpr double largest_m = 1e-3;
    constexpr double smallest_m = 1e-5;
    double increment = largest_m;
    while (press.deflection_m != deflection_m) {
        const double left = deflection_m - press.deflection_m;
        const double next = left <= increment ? deflection_m : press.deflection_m + increment;
        press.plane.height_m = press.first_touch_m + next;
        if (find_equilibrium(press.set, press.supports, press.plane, press.state) == Convergence::reached) {
            press.deflection_m = next;
            increment = std::min(largest_m, 2 * increment);
        } else if ((increment = 0.5 * std::min(increment, left)) < smallest_m) {
            fail_input(
                fmt::format("the wheel has no equilibrium at a deflection of {:.4g} m on a rigid plane (its layers "
                            "buckle or turn inside out). Stiffen the layers or press less?",
                            next));
        }
    }
}

double load_now_N(const Press& press) { return plane_load_N(press.set, press.supports, press.state); }

/// Deflection under a given load: forward in increments, then regula falsi and bisection in turn (the curve has kinks
/// where nodes touch, and may jump), each trial from the last state below the load.
double find_deflection_m(Press press, double load_N) {
    const double tolerance_N = 1e-6 * load_N;
    Press below = press;
    double below_N = 0;
    while (true) {
        press_to(press, press.deflection_m + 1e-3);
        if (load_now_N(press) >= load_N) break;
        below_N = load_now_N(press);
        below = press;
    }
    double above_N = load_now_N(press);
    double above_m = press.deflection_m;
    for (bool halve = false; above_m - below.deflection_m > 1e-9; halve = !halve) {
        const double share = halve ? 0.5 : (load_N - below_N) / (above_N - below_N);
        Press trial = below;
        press_to(trial, below.deflection_m + (above_m - below.deflection_m) * share);
        const double trial_N = load_now_N(trial);
        if (std::abs(trial_N - load_N) <= tolerance_N) return trial.deflection_m;
        if (trial_N > load_N) {
            above_m = trial.deflection_m;
            above_N = trial_N;
        } else {
            below_N = trial_N;
            below = trial;
        }
    }
    return above_m;
}

}  // namespace

std::vector<LoadDeflection> press_on_plane(const WheelCase& wheel, std::span<const double> deflection_m,
                                           double phase_deg, PlaneFriction friction) {
    Press press = set_up(wheel, phase_deg, friction);
    std::vector<LoadDeflection> rows;
    for (const double deflection : deflection_m) {
        if (!(deflection >= press.deflection_m)) {
            fail_input(
                fmt::format("the deflections of a press test decrease at {} m (a wheel is pressed, not released). "
                            "Sort them?",
                            deflection));
        }
        press_to(press, deflection);
        rows.push_back({deflection, load_now_N(press)});
    }
    return rows;
}

double lug_pitch_deg(const WheelCase& wheel) {
    return 360.0 / static_cast<double>(wheel.lug_pairs > 0 ? wheel.lug_pairs : 12);
}

RadialStiffness find_radial_stiffness(const WheelCase& wheel, double load_N, std::int64_t phases,
                                      PlaneFriction friction) {
    if (!(load_N > 0) || phases < 1) {
        fail_input(
            fmt::format("a radial stiffness at {} N over {} phases cannot be had (W/δ needs a load). Give a load "
                        "above 0 and at least one phase?",
                        load_N, phases));
    }
    const double pitch_deg = lug_pitch_deg(wheel);
    RadialStiffness result;
    for (std::int64_t k = 0; k < phases; ++k) {
        const double phase_deg = pitch_deg * static_cast<double>(k) / static_cast<double>(phases);
        result.phase_N_m.push_back(load_N / find_deflection_m(set_up(wheel, phase_deg, friction), load_N));
        result.mean_N_m += result.phase_N_m.back() / static_cast<double>(phases);
    }
    result.smallest_N_m = *std::min_element(result.phase_N_m.begin(), result.phase_N_m.end());
    result.largest_N_m = *std::max_element(result.phase_N_m.begin(), result.phase_N_m.end());
    return result;
}

}  // namespace ifedem

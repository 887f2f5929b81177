// Eqs 2.13–2.16 and the sharing of a contact's force by shape functions (Fig 2-5), on a wheel in a small bin.
#include <algorithm>
#include <cmath>

#include "known_contacts.hpp"
#include "support/wheel_scenes.hpp"
#include "topics.hpp"
#include "traction/control.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

/// Worst of the steps of a travel, relative to the sum of the contact forces' sizes.
struct Shares {
    double force = 0, moment_m = 0;  ///< node forces plus what the discs get
    double net = 0;                  ///< H + R of Eqs 2.13–2.14 less the sum of the contacts' horizontal forces
};

void compare_shares(const World& w, Shares& worst) {
    Vec2 force;
    double moment = 0, size = 0, h = 0, r = 0, of_contacts = 0;
    for (const WheelContact& c : w.work.wheel.contact) {
        const Disc& d = w.state.discs.disc[c.position];
        force += c.on_disc.force_N;
        moment += cross(centre_of(d), c.on_disc.force_N) + c.on_disc.turning_N * d.radius_m;
        size += norm(c.on_disc.force_N);
        of_contacts -= c.on_disc.force_N.x;
    }
    if (size == 0) return;
    for (std::size_t n = 0; n < w.work.wheel.contact_force_N.size(); ++n) {
        const Vec2 f = w.work.wheel.contact_force_N[n];
        force += f;
        moment += cross(w.state.wheel.position_m[n], f);
        (f.x > 0 ? h : r) += f.x;
    }
    worst.force = std::fmax(worst.force, norm(force) / size);
    worst.moment_m = std::fmax(worst.moment_m, std::fabs(moment) / size);
    worst.net = std::fmax(worst.net, std::fabs(h + r - of_contacts) / size);
}

/// The contacts where wheel and discs stand now: those of the step were taken before both moved. Springs stay.
void evaluate_contacts(World& w) {
    add_wheel_contacts(w.scene.dem, w.scene.wheel, w.state, w.work.dem, w.work.wheel, 0);
}

/// Means over a few steps of a travel, for the figure: H, |R|, P_d = −P, H − |R| less the wheel's change of momentum
/// (Eq 2.15), and the slip (Eq 2.16).
struct Window {
    static constexpr std::int64_t steps = 100;
    SeriesSums sums;
    double momentum_Ns = 0, time_s = 0;
    std::vector<std::vector<std::string>> rows;

    explicit Window(const World& w) : sums(w.state.series), momentum_Ns(momentum_x_Ns(w)) {}

    void close(const Case& c, const World& w) {
        const SeriesSums& now = w.state.series;
        const double duration = steps * w.scene.dem.step_s;
        const auto mean = [&](double SeriesSums::*sum) { return (now.*sum - sums.*sum) / steps; };
        const double h = mean(&SeriesSums::fx_positive_N), r = -mean(&SeriesSums::fx_negative_N);
        const double rate = (momentum_x_Ns(w) - momentum_Ns) / duration;
        const double circumferential = c.wheel.tread_radius_m * mean(&SeriesSums::omega_clockwise_rad_s);
        const double slip = 100 * (1 - mean(&SeriesSums::hub_speed_m_s) / circumferential);
        rows.push_back({number(time_s + 0.5 * duration), number(h), number(r), number(-mean(&SeriesSums::drawbar_N)),
                        number(h - r - rate), number(slip)});
        sums = now, momentum_Ns = momentum_x_Ns(w), time_s += duration;
    }

private:
    static double momentum_x_Ns(const World& w) { return ifedem::momentum_Ns(w.scene.wheel, w.state.wheel).x; }
};

void measure_travel(Output& out, ControlScheme scheme, const std::string& name) {
    Case c = make_wheel_case(WheelBody::rigid_rim);
    c.control.scheme = scheme;
    World w = run_until_travel(c);
    const Vec2 momentum = momentum_Ns(w.scene.wheel, w.state.wheel);
    w.state.series = {};
    constexpr std::int64_t steps = 4000;
    Shares worst;
    Window window(w);
    for (std::int64_t n = 0; n < steps; ++n) {
        advance(w, 1);
        if ((n + 1) % Window::steps == 0) window.close(c, w);
        if (n % 20 != 0) continue;
        evaluate_contacts(w);
        compare_shares(w, worst);
    }
    if (scheme == ControlScheme::prescribed)
        out.write_table("balance.csv", "time_s,gross_N,resistance_N,drawbar_N,net_N,slip_percent", window.rows);
    const Vec2 rate = (1 / (steps * w.scene.dem.step_s)) * (momentum_Ns(w.scene.wheel, w.state.wheel) - momentum);
    const SeriesSums& s = w.state.series;
    const double h = s.fx_positive_N / steps, r = s.fx_negative_N / steps, p = s.drawbar_N / steps, fy = s.fy_N / steps;
    const double slip = 100 * (1 - s.hub_speed_m_s / (c.wheel.tread_radius_m * s.omega_clockwise_rad_s));
    out.add("slip_" + name, slip, "%", "1 − V/(rω) of the motion; commanded 60 %");
    out.add("drawbar_balance_" + name, h - std::fabs(r) + p - rate.x, "N",
            "H − |R| + P less the wheel's change of momentum, mean of 4000 steps");
    if (scheme == ControlScheme::prescribed) return;
    out.add("vertical_balance", fy - w.scene.wheel.load_N - rate.y, "N", "ΣF_y − W less the change of momentum");
    out.add("net_traction_identity", worst.net, "-", "|H + R − ΣF_x| over Σ|F|, worst of 200 steps");
    out.add("shape_function_force", worst.force, "-", "node forces + forces on discs, over Σ|F|, worst of 200 steps");
    out.add("shape_function_moment", worst.moment_m, "m", "the same of moments");
}

}  // namespace

void measure_traction(Output& out, Effort) {
    measure_known_contacts(out);
    measure_travel(out, ControlScheme::semi_implicit, "pid");
    measure_travel(out, ControlScheme::prescribed, "prescribed");
}

}  // namespace ifedem::chapter2

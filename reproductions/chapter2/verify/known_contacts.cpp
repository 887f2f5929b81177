// Eqs 2.13–2.16 with contact forces that are known: a smooth rigid wheel in a prescribed motion touches discs that are
// too heavy to move, each by a stated overlap. Every contact slides, so its force is N (µ cos β − sin β) along the
// travel, β the contact's angle ahead of bottom dead centre: it pushes up to tan β = µ, and resists beyond.
#include "known_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "support/quad_meshes.hpp"
#include "support/wheel_scenes.hpp"
#include "traction/control.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

constexpr double mu = 0.4, overlap_m = 5e-6, heavy_kg = 1e12, touching_radius_m = 2e-3;
constexpr double normal_N = stiffness_N_m * overlap_m;

/// Where a disc touches: on which segment of the tread (from the lowest one of the wheel at rest, forwards) and where.
struct Spot {
    std::int64_t segment = 0;
    double share = 0.5;
};

struct Contact {
    double beta_rad = 0, arm_m = 0;  ///< of the segment's normal; from the hub to the segment
    std::uint32_t from = 0, to = 0;
};

struct Bench {
    World world;
    std::vector<Contact> contact;
    double radius_m = 0;
};

/// The wheel turned by `turned_rad` and moving as travel asks for, a disc at each spot.
Bench make_bench(double slip_percent, const std::vector<Spot>& spots, double turned_rad = 0) {
    Case c;
    c.wheel.body = WheelBody::rigid, c.wheel.lug_pairs = 0;
    c.control.scheme = ControlScheme::prescribed;
    c.travel.slip_percent = slip_percent, c.travel.speed_m_s = 2, c.travel.acceleration_time_s = 0;
    Bench bench;
    bench.radius_m = c.wheel.tread_radius_m;
    World& w = bench.world;
    w.scene = make_scene(c, Stage::travel);
    WheelState wheel = place_wheel(w.scene.wheel, {});
    wheel.position_m = turned(wheel.position_m, turned_rad);
    wheel.rim.angle_rad = turned_rad;
    wheel.rim.velocity_m_s = {c.travel.speed_m_s, 0};
    wheel.rim.omega_rad_s = -commanded_omega_rad_s(c.travel, c.wheel);
    for (std::size_t n = 0; n < wheel.position_m.size(); ++n)
        wheel.velocity_m_s[n] = wheel.rim.velocity_m_s + cross(wheel.rim.omega_rad_s, wheel.position_m[n]);
    const auto& surface = w.scene.wheel.surface;
    const auto middle = [&](const SurfaceEdge& e) { return 0.5 * (wheel.position_m[e.from] + wheel.position_m[e.to]); };
    const auto& still = w.scene.wheel.mesh.mesh.node_m;
    std::size_t lowest = 0;  // before the wheel was turned
    const auto height = [&](std::size_t k) { return still[surface[k].from].y + still[surface[k].to].y; };
    for (std::size_t k = 0; k < surface.size(); ++k)
        if (height(k) < height(lowest)) lowest = k;
    std::vector<Disc> discs;
    const auto count = static_cast<std::int64_t>(surface.size());
    for (const Spot& spot : spots) {
        const auto k = static_cast<std::size_t>((static_cast<std::int64_t>(lowest) + spot.segment + count) % count);
        const SurfaceEdge& edge = surface[k];
        const Vec2 at = middle(edge), along = wheel.position_m[edge.to] - wheel.position_m[edge.from];
        const Vec2 outward = (1 / norm(along)) * Vec2{along.y, -along.x};
        const Vec2 foot = wheel.position_m[edge.from] + spot.share * along;
        discs.push_back(make_disc(foot + (touching_radius_m - overlap_m) * outward, touching_radius_m, heavy_kg));
        bench.contact.push_back({std::atan2(outward.x, -outward.y), norm(at), edge.from, edge.to});
    }
    w.scene.dem = make_dem(make_contact(stiffness_N_m, stiffness_N_m / 4, mu), 0, c.time_step_s);
    fit_radii(w.scene.dem, discs);
    w.state = make_state(discs);
    w.state.wheel = wheel;
    begin_stage(w.scene, w.state);
    w.work = make_workspace(w.scene, w.state);
    return bench;
}

double pushing_share(double beta_rad) { return mu * std::cos(beta_rad) - std::sin(beta_rad); }

/// tan β at which a contact neither pushes nor resists, by bisection.
double find_neutral_tangent() {
    double low = 0, high = 1;
    double tangent = 0;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        Bench b = make_bench(40, {{0, 0.5}}, middle);
        advance(b.world, 1);
        const SeriesSums& s = b.world.state.series;
        (s.fx_positive_N + s.fx_negative_N > 0 ? low : high) = middle;
        tangent = std::tan(b.contact[0].beta_rad);
    }
    return tangent;
}

using Rows = std::vector<std::vector<std::string>>;

/// Sums, drawbar pull and torque of contacts on every second segment, so that no two share a node.
void measure_sums(Output& out, Rows& rows) {
    std::vector<Spot> spots;
    for (std::int64_t k = -8; k <= 10; k += 2) spots.push_back({k, 0.5});
    double gross = 0, resistance = 0, net = 0, torque = 0, slip_error = 0;
    for (const double slip : {10.0, 40.0, 90.0}) {
        Bench b = make_bench(slip, spots);
        advance(b.world, 1);
        const SeriesSums& s = b.world.state.series;
        double h = 0, r = 0, t = 0;
        for (const Contact& c : b.contact) {
            const double fx = normal_N * pushing_share(c.beta_rad);
            (fx > 0 ? h : r) += fx;
            t += mu * normal_N * c.arm_m;
        }
        const auto worsen = [](double& worst, double got, double closed) {
            worst = std::fmax(worst, std::fabs(got / closed - 1));
        };
        worsen(gross, s.fx_positive_N, h);
        worsen(resistance, s.fx_negative_N, r);
        worsen(net, -s.drawbar_N, h + r);
        worsen(torque, s.torque_Nm, t);
        const RigidBody& rim = b.world.state.wheel.rim;
        slip_error =
            std::fmax(slip_error, std::fabs(100 * (1 + rim.position_m.x / (b.radius_m * rim.angle_rad)) - slip));
        if (slip != 40) continue;
        for (const Contact& c : b.contact) {
            const double fx = b.world.work.wheel.contact_force_N[c.from].x + b.world.work.wheel.contact_force_N[c.to].x;
            rows.push_back({"contact", number(c.beta_rad * 180 / pi), number(fx / normal_N), ""});
        }
    }
    const char* what = "over closed form, less 1; worst of slips 10, 40, 90 %";
    out.add("known_gross_tractive_effort", gross, "-", what);
    out.add("known_motion_resistance", resistance, "-", what);
    out.add("known_drawbar_pull", net, "-", "−P of the prescribed motion over H − |R|, less 1; the same");
    out.add("known_torque", torque, "-", what);
    out.add("known_slip", slip_error, "%", "1 − V/(rω) less the commanded; the same");
}

/// Shares of one contact's force on its segment's two nodes (Fig 2-5).
void measure_sharing(Output& out, Rows& rows) {
    double worst = 0;
    for (const double share : {0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.98}) {
        Bench b = make_bench(40, {{0, share}});
        advance(b.world, 1);
        const auto& force = b.world.work.wheel.contact_force_N;
        const Vec2 first = force[b.contact[0].from], second = force[b.contact[0].to];
        const double size = norm(first + second);
        worst = std::max({worst, std::fabs(norm(first) / size - (1 - share)), std::fabs(norm(second) / size - share)});
        rows.push_back({"share", number(share), number(norm(first) / size), number(norm(second) / size)});
    }
    out.add("shape_function_shares", worst, "-", "|F_1/R_3 − (1 − s)| and |F_2/R_3 − s|, worst of eleven places");
}

}  // namespace

void measure_known_contacts(Output& out) {
    Rows rows;
    measure_sums(out, rows);
    measure_sharing(out, rows);
    out.add("known_sign_change", find_neutral_tangent() / mu, "-", "tan β over µ where f_x changes its sign");
    out.write_table("known_contacts.csv", "kind,x,first,second", rows);
}

}  // namespace ifedem::chapter2

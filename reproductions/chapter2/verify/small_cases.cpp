// Courses of the small exact cases, for their figure; what is checked of them stands in contact.cpp.
#include "small_cases.hpp"

#include <cmath>

#include "support/collisions.hpp"
#include "support/disc_on_plane.hpp"
#include "support/squeezed_pair.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;
using Rows = std::vector<std::vector<std::string>>;

void draw_launch(Rows& rows) {
    World w = make_disc_on_plane(0, 0.3, 0, {Launch::speed_m_s, 0});
    for (int point = 0; point <= 12; ++point) {
        const Disc& d = disc_of(w, 0);
        rows.push_back({"launch", number(point * 0.005), number(d.vx_m_s), number(-d.omega_rad_s * disc_radius)});
        advance(w, 1000);
    }
}

void draw_block(Rows& rows) {
    World w = make_disc_on_plane(0, 0.4, 1e9, {0.3, 0});
    for (int point = 0; point <= 10; ++point) {
        const Disc& d = disc_of(w, 0);
        rows.push_back({"block", number(point * 0.01), number(1e3 * d.x_m), ""});
        advance(w, 2000);
    }
}

void draw_column(Rows& rows) {
    const Column column = settle_column(10);
    for (std::size_t k = 0; k < column.overlap.size(); ++k)
        rows.push_back({"column", std::to_string(k + 1), number(column.overlap[k]), ""});
}

/// Chung & Ooi, case 3: rebound over impact for both contact ends against the restitution that ζ was chosen for.
void draw_rebound(Rows& rows) {
    for (const double wanted : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
        rows.push_back({"case3", number(wanted), number(rebound_over_impact(wanted, ContactEnd::no_attraction)),
                        number(rebound_over_impact(wanted, ContactEnd::attraction))});
}

/// Case 7: both spins after the collision.
void draw_spinning_pair(Rows& rows) {
    for (const double omega : {20.0, 100.0, 200.0, 500.0, 1000.0, 2000.0}) {
        const SpinningPair m = collide_spinning(omega);
        rows.push_back({"case7", number(omega), number(m.omega_a_rad_s), number(m.omega_b_rad_s)});
    }
}

/// Largest speed in 100 steps after a kick over the kick, against the step over its limit: exact map and measured.
void draw_pair_growth(Rows& rows) {
    const double omega = std::sqrt((2 * stiffness_N_m + soft_N_m) / pair_mass);
    for (double share = 0.984; share < 1.0041; share += 0.001) {
        const double dt = 2 * share / omega;
        double x = 0, v = 1, largest = 1;
        for (int n = 0; n < 100; ++n) {
            v -= omega * omega * dt * x, x += dt * v;
            largest = std::fmax(largest, std::fabs(v));
        }
        const double measured =
            largest_amplification(make_squeezed_pair(0, stiffness_N_m / 4, dt), &Disc::vx_m_s, 1e-11);
        rows.push_back({"growth", number(share), number(largest), number(measured)});
    }
}

}  // namespace

void draw_small_cases(Output& out) {
    Rows rows;
    draw_launch(rows);
    draw_block(rows);
    draw_column(rows);
    draw_rebound(rows);
    draw_spinning_pair(rows);
    draw_pair_growth(rows);
    out.write_table("small_cases.csv", "kind,x,first,second", rows);
}

}  // namespace ifedem::chapter2

// Janssen's silo in two dimensions: sand between two rough walls whose own weight compresses it, so that it goes down
// along the walls and their friction holds it up. What reaches the floor is
// ρ g L² t/(2 µ k) (1 − exp(−2 µ k H/L)), with k the ratio of horizontal to vertical stress. k is measured on a silo of
// twice its width's height and predicts the others.
//
// The sand is prepared as the bed is, without friction, and then loses its weight; it comes back slowly, with friction.
// (Lowering the floor instead leaves the horizontal stress of the preparation in the sand, and the floor's dashpots
// carry a part of the weight.)
#include <algorithm>
#include <array>
#include <cmath>

#include "check/statistics.hpp"
#include "dem/bed.hpp"
#include "soil_tests/sample.hpp"
#include "support/wheel_scenes.hpp"
#include "topics.hpp"

namespace ifedem::chapter2 {
namespace {

using namespace scene;

constexpr double width_m = 0.09, wall_friction = 0.5;
enum Wall : std::size_t { floor_wall, left, right };

/// Means over the end of a run at rest.
struct Silo {
    double weight_N = 0, height_m = 0;
    double floor_N = 0, shear_N = 0, normal_N = 0;  ///< on the floor; upwards by both walls; on both walls
    double vertical_stress_sum_N = 0;               ///< ∫ σ_v dz over the height, times the thickness
};

/// Adds what the walls do to the discs now. The vertical stress follows from the balance of what lies above.
void add_walls(const SoilWorld& w, double gravity, double share, Silo& silo) {
    struct Load {
        double height_m = 0, down_N = 0;
    };
    std::vector<Load> loads;
    const DemConstants& k = w.scene.dem;
    for (const Disc& d : w.state.discs.disc) loads.push_back({d.y_m, mass_of(d) * gravity});
    for (const BoundaryContact& c : w.state.wall_contacts) {
        const Disc& d = w.state.discs.disc[w.work.dem.position_of_id[c.disc]];
        const WallSide side = find_wall_side(k, c.surface, d);
        const BoundaryForce f = boundary_force(k.wall, k.damping_ratio, d, side.normal, side.distance_m,
                                               side.opposite_radius_m, {}, c.tangential_m, 0);
        if (c.surface == floor_wall) {
            silo.floor_N += share * f.force_N.y;
            continue;
        }
        silo.shear_N += share * f.force_N.y;
        silo.normal_N += share * f.normal_N;
        loads.push_back({d.y_m, -f.force_N.y});
    }
    for (const Load& l : loads) silo.vertical_stress_sum_N += share * l.down_N * l.height_m / width_m;
}

Silo fill_silo(int seed, double slenderness) {
    Case c;
    c.bed.length_m = width_m, c.bed.seed = seed;
    c.bed.disc_count = std::llround(slenderness * width_m * width_m * 0.84 / 17.54e-6);  // mean area of the discs
    const State filled = make_initial_state(c);
    Sample sample(make_dem_constants(c, 0, 0), filled.discs.disc);
    DemConstants& dem = sample.world().scene.dem;
    const State& state = sample.world().state;
    const Vec2 gravity = dem.gravity_m_s2;
    const auto rest = [&](double time_s) {
        for (int n = 0; n < static_cast<int>(time_s / dem.step_s); ++n) sample.step();
    };
    rest(0.8);
    dem.gravity_m_s2 = 0.01 * gravity;
    rest(0.2);
    sample.set_friction(c.contact.friction_soil, wall_friction);
    constexpr int increments = 500;
    for (int n = 1; n <= increments; ++n) {
        dem.gravity_m_s2 = (0.01 + 0.99 * n / increments) * gravity;
        rest(0.6 / increments);
    }
    rest(0.2);
    Silo silo;
    for (const Disc& d : state.discs.disc) silo.weight_N += mass_of(d) * c.gravity_m_s2;
    silo.height_m = measure_surface_m(state.discs, width_m, dem.largest_radius_m);
    constexpr int samples = 100;
    for (int n = 0; n < samples; ++n) {
        rest(0.0004);
        add_walls(sample.world(), c.gravity_m_s2, 1.0 / samples, silo);
    }
    return silo;
}

/// σ_h/σ_v, both as means over the height.
double stress_ratio(const Silo& s) { return 0.5 * s.normal_N / s.vertical_stress_sum_N; }

double janssen_N(const Silo& s, double k) {
    const double rate = 2 * wall_friction * k / width_m;
    return s.weight_N * (1 - std::exp(-rate * s.height_m)) / (rate * s.height_m);
}

}  // namespace

void measure_silo(Output& out, Effort effort) {
    const int seeds = effort == Effort::full ? 8 : 2;
    std::vector<Silo> low, middle, high;
    std::vector<double> ratio;
    for (int seed = 1; seed <= seeds; ++seed) {
        low.push_back(fill_silo(seed, 1));
        middle.push_back(fill_silo(seed, 2));
        high.push_back(fill_silo(seed, 4));
        ratio.push_back(stress_ratio(middle.back()));
    }
    const double k = mean(ratio);
    std::vector<double> mobilised, balance, low_load, high_load;
    std::vector<std::vector<std::string>> rows{{"k", number(k), number(wall_friction)}};
    for (const auto* silos : {&low, &middle, &high}) {
        for (const Silo& s : *silos) {
            mobilised.push_back(s.shear_N / s.normal_N / wall_friction);
            balance.push_back((s.floor_N + s.shear_N) / s.weight_N);
            const double unit = s.weight_N / s.height_m * width_m;
            rows.push_back({"floor", number(s.height_m / width_m), number(s.floor_N / unit)});
        }
    }
    for (const Silo& s : low) low_load.push_back(s.floor_N / janssen_N(s, k));
    for (const Silo& s : high) high_load.push_back(s.floor_N / janssen_N(s, k));
    out.write_table("silo.csv", "kind,slenderness,load", rows);
    out.add("silo_stress_ratio", ratio, "-", "σ_h/σ_v of the silo with H/L = 2, 18 smallest diameters wide");
    out.add_difference("silo_wall_friction", mobilised, "-", "shear over normal force on the walls over µ; all silos");
    out.add("silo_balance", balance, "-", "floor and walls over the weight; all silos");
    out.add_difference("silo_load_low", low_load, "-", "floor load over Janssen’s, H/L = 1, k from H/L = 2");
    out.add_difference("silo_load_high", high_load, "-", "the same, H/L = 4");
}

}  // namespace ifedem::chapter2

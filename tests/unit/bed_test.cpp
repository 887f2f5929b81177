// The unsettled bed and the measures taken of beds, against geometry.
#include "dem/bed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "support/dem_scenes.hpp"

namespace ifedem {
namespace {

using namespace scene;

Case make_case(std::int64_t count, double length_m, std::int64_t seed) {
    Case c;
    c.bed.disc_count = count;
    c.bed.length_m = length_m;
    c.bed.seed = seed;
    return c;
}

DiscState make_discs(const std::vector<Disc>& discs) { return make_state(discs).discs; }

TEST(GenerateBed, has_the_shares_and_masses_of_the_case) {
    for (const std::int64_t count : {1, 6, 7, 1000, 19468}) {
        const Case c = make_case(count, 1.5, 3);
        const DiscState bed = generate_bed(c);
        ASSERT_EQ(bed.disc.size(), static_cast<std::size_t>(count));
        ASSERT_EQ(bed.id.size(), bed.disc.size());
        for (std::size_t k = 0; k < 3; ++k) {  // 3 : 2 : 1 by number, exact to one disc
            const auto found = std::count_if(bed.disc.begin(), bed.disc.end(),
                                             [&](const Disc& d) { return d.radius_m == c.soil.radii_m[k]; });
            EXPECT_NEAR(static_cast<double>(found), static_cast<double>(count) * c.soil.radii_shares[k] / 6, 1.0);
        }
        for (std::size_t n = 0; n < bed.disc.size(); ++n) {
            EXPECT_EQ(bed.id[n], n);
            const double r = bed.disc[n].radius_m;
            EXPECT_NEAR(mass_of(bed.disc[n]), 2600 * 0.1 * pi * r * r, 1e-15);
        }
    }
}

/// Every contact by ids in the numbering before levelling, with its spring.
using Springs = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;
Springs springs_of(const State& state, const std::vector<std::uint32_t>& old_id) {
    Springs springs;
    for (std::size_t n = 0; n < state.pairs.inner.size(); ++n) {
        const std::uint32_t a = old_id[state.discs.id[state.pairs.i[state.pairs.inner[n]]]];
        const std::uint32_t b = old_id[state.discs.id[state.pairs.j[state.pairs.inner[n]]]];
        springs[{std::min(a, b), std::max(a, b)}] = state.pairs.tangential_m[n];
    }
    for (const BoundaryContact& c : state.wall_contacts)
        springs[{1000000 + c.surface, old_id[c.disc]}] = c.tangential_m;
    return springs;
}

TEST(LevelSurface, takes_the_highest_away_and_keeps_every_other_spring) {
    Case c = make_case(300, 0.1, 2);
    c.contact.consolidation_friction_soil = c.contact.consolidation_friction_wall = 0.4;
    World w;
    w.scene = make_scene(c, Stage::consolidation);
    w.state = make_initial_state(c);
    w.work = make_workspace(w.scene, w.state);
    advance(w, 4000);
    const State before = w.state;
    level_surface(w.state, 250);
    ASSERT_EQ(w.state.discs.disc.size(), 250U);

    // The same discs by brute force; their order of ids tells the old from the new ones.
    std::vector<double> tops;
    for (const Disc& d : before.discs.disc) tops.push_back(d.y_m + d.radius_m);
    std::sort(tops.begin(), tops.end());
    std::vector<std::uint32_t> old_id, everyone(300);
    for (std::uint32_t id = 0; id < 300; ++id) {
        everyone[id] = id;
        const auto p = static_cast<std::size_t>(std::find(before.discs.id.begin(), before.discs.id.end(), id) -
                                                before.discs.id.begin());
        if (before.discs.disc[p].y_m + before.discs.disc[p].radius_m <= tops[249]) old_id.push_back(id);
    }
    ASSERT_EQ(old_id.size(), 250U);
    for (std::size_t p = 0; p < 250; ++p) {
        const auto q = static_cast<std::size_t>(
            std::find(before.discs.id.begin(), before.discs.id.end(), old_id[w.state.discs.id[p]]) -
            before.discs.id.begin());
        EXPECT_EQ(w.state.discs.disc[p].x_m, before.discs.disc[q].x_m);
    }
    Springs expected = springs_of(before, everyone);
    std::erase_if(expected, [&](const auto& entry) {
        const auto gone = [&](std::uint32_t id) { return !std::binary_search(old_id.begin(), old_id.end(), id); };
        return gone(entry.first.second) || (entry.first.first < 1000000 && gone(entry.first.first));
    });
    const Springs kept = springs_of(w.state, old_id);
    EXPECT_EQ(kept, expected);
    const auto loaded = std::count_if(kept.begin(), kept.end(), [](const auto& entry) { return entry.second != 0; });
    EXPECT_GT(loaded, 100);

    // What stays can be stepped on: the top is gone, so that nothing may be thrown about.
    w.work = make_workspace(w.scene, w.state);
    advance(w, 100);
    EXPECT_LT(rms_speed_m_s(w.state.discs), 0.1);
}

TEST(GenerateBed, fits_into_the_bin_with_hardly_an_overlap) {
    for (const double length : {0.05, 0.3, 1.5}) {
        const DiscState bed = generate_bed(make_case(1200, length, 5));
        double deepest = 0, highest = 0;
        for (std::size_t a = 0; a < bed.disc.size(); ++a) {
            const Disc& d = bed.disc[a];
            EXPECT_GE(d.x_m - d.radius_m, -1e-12);
            EXPECT_LE(d.x_m + d.radius_m, length + 1e-12);
            EXPECT_GE(d.y_m - d.radius_m, -1e-12);
            highest = std::max(highest, d.y_m);
            for (std::size_t b = a + 1; b < bed.disc.size(); ++b)
                deepest =
                    std::max(deepest, d.radius_m + bed.disc[b].radius_m - norm(centre_of(d) - centre_of(bed.disc[b])));
        }
        std::printf("bin of %.2f m: deepest overlap %.4f of the largest radius, top at %.3f m\n", length,
                    deepest / 0.003, highest);
        // Shifts of ±5 % of r in both directions may beat the gap of 10 % of r along the diagonal by 0.05 (2√2 − 2) r.
        EXPECT_LT(deepest, 0.042 * 0.003);
    }
}

TEST(GenerateBed, follows_its_seed) {
    const DiscState a = generate_bed(make_case(500, 0.4, 1)), again = generate_bed(make_case(500, 0.4, 1)),
                    other = generate_bed(make_case(500, 0.4, 2));
    std::size_t same_radius = 0;
    for (std::size_t n = 0; n < 500; ++n) {
        EXPECT_EQ(a.disc[n].x_m, again.disc[n].x_m);
        EXPECT_EQ(a.disc[n].y_m, again.disc[n].y_m);
        EXPECT_EQ(a.disc[n].radius_m, again.disc[n].radius_m);
        EXPECT_NE(a.disc[n].x_m, other.disc[n].x_m);
        if (a.disc[n].radius_m == other.disc[n].radius_m) ++same_radius;
    }
    EXPECT_LT(same_radius, 260U);  // 1/4 + 1/9 + 1/36 = 39 % by chance, four standard deviations are 9 %
}

TEST(GenerateBed, carries_accelerations_only_for_modified_euler) {
    Case c = make_case(10, 0.4, 1);
    EXPECT_TRUE(generate_bed(c).acceleration.empty());
    c.integrator = Integrator::modified_euler_two;
    EXPECT_EQ(generate_bed(c).acceleration.size(), 10U);
}

// A disc that an edge cuts is 400 slices: their mid-points make it 4e-5 too large (measured 3.8e-5).
constexpr double slice_tolerance = 5e-5;

TEST(Porosity, of_one_disc_inside_and_cut_by_each_edge) {
    const double r = 0.1, area = pi * r * r;
    const auto solid = [&](Vec2 at) {  // area inside the window [0.2, 0.8] × [0.1, 0.9]
        return (1 - measure_porosity(make_discs({make_disc(at, r, 1)}), 1.0, 0.2, 0.1, 0.9)) * 0.6 * 0.8;
    };
    EXPECT_NEAR(solid({0.5, 0.5}), area, slice_tolerance * area);
    for (const Vec2 edge : {Vec2{0.2, 0.5}, Vec2{0.8, 0.5}, Vec2{0.5, 0.1}, Vec2{0.5, 0.9}})
        EXPECT_NEAR(solid(edge), area / 2, slice_tolerance * area);
    for (const Vec2 corner : {Vec2{0.2, 0.1}, Vec2{0.8, 0.9}})
        EXPECT_NEAR(solid(corner), area / 4, slice_tolerance * area);
    EXPECT_EQ(solid({0.05, 0.5}), 0.0);
    EXPECT_EQ(solid({0.5, 1.05}), 0.0);
}

TEST(Porosity, of_close_packing) {
    const double r = 0.0025, row = std::sqrt(3.0) * r;
    std::vector<Disc> discs;
    for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 100; ++i) discs.push_back(make_disc({(2 * i + j % 2) * r, j * row}, r, 1));
    // A window of whole periods: 80 columns, 40 rows.
    const double porosity = measure_porosity(make_discs(discs), 180 * r, 10 * r, 10 * row, 50 * row);
    std::printf("hexagonal packing: porosity %.5f (closed 1 - pi/sqrt(12) = %.5f)\n", porosity,
                1 - pi / std::sqrt(12.0));
    // Of 3200 discs the edges cut 240: 4e-5 of their share is 3e-6.
    EXPECT_NEAR(porosity, 1 - pi / std::sqrt(12.0), 3e-6);
}

TEST(Surface, is_the_mean_of_the_highest_tops_by_column) {
    // Columns of 4 × 3 mm = 12 mm in a bin of 48 mm: tops at 13, 23, 33 and none.
    const double r = 0.003;
    const DiscState discs = make_discs({make_disc({0.006, 0.010}, r, 1), make_disc({0.006, 0.004}, r, 1),
                                        make_disc({0.018, 0.020}, r, 1), make_disc({0.030, 0.030}, r, 1)});
    EXPECT_NEAR(measure_surface_m(discs, 0.048, r), (0.013 + 0.023 + 0.033) / 4, 1e-15);
}

TEST(Speed, is_the_root_mean_square) {
    EXPECT_EQ(rms_speed_m_s(DiscState{}), 0);
    const DiscState discs = make_discs(
        {make_disc({}, 1, 1, {3, 4}), make_disc({}, 1, 1), make_disc({}, 1, 1, {0, -1}), make_disc({}, 1, 1, {1, 1})});
    EXPECT_NEAR(rms_speed_m_s(discs), std::sqrt((25 + 0 + 1 + 2) / 4.0), 1e-15);
}

}  // namespace
}  // namespace ifedem

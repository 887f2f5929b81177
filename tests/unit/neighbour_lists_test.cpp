// Neighbour lists and the forces gathered over them against all pairs, while the discs move about and are sorted anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "dem/pair_kernel.hpp"
#include "dem/skins.hpp"
#include "dem/vector_width.hpp"
#include "support/dem_scenes.hpp"
#include "support/reference_dem.hpp"

namespace ifedem {
namespace {

using namespace scene;
using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< ids, lower first

enum class Walls { none, flat, discs, both };

struct Bed {
    std::size_t count;
    double fill;  ///< area of the discs over that of their box
    double speed_m_s;
    std::uint64_t seed;
    Walls walls;
    double rolling_chords = 2;
};

void PrintTo(const Bed& b, std::ostream* out) {
    *out << b.count << " discs, fill " << b.fill << ", seed " << b.seed << ", walls " << static_cast<int>(b.walls)
         << ", rolling " << b.rolling_chords;
}

World make_bed(const Bed& bed, double gravity_m_s2) {
    Random random{bed.seed};
    double side = 0;
    const std::vector<Disc> discs = scatter_discs(bed.count, bed.fill, bed.speed_m_s, random, side);
    const ContactConstants contact =
        make_contact(stiffness_N_m, stiffness_N_m / 4, 0.5, ContactEnd::no_attraction, bed.rolling_chords);
    DemConstants dem = make_dem(contact, 0.2, 4e-5, gravity_m_s2);
    if (bed.walls == Walls::flat) dem.flat_walls = make_box(side);
    if (bed.walls == Walls::discs || bed.walls == Walls::both) dem.wall_discs = make_box_of_discs(side, 0.003);
    if (bed.walls == Walls::both) dem.flat_walls = {{{0, side}, {0, -1}}};  // a lid
    return make_world(dem, discs);
}

/// Every two discs that overlap, by the definition.
std::set<Pair> find_touching(const State& state) {
    std::set<Pair> touching;
    const auto& d = state.discs.disc;
    for (std::size_t a = 0; a < d.size(); ++a)
        for (std::size_t b = a + 1; b < d.size(); ++b)
            if (norm(centre_of(d[a]) - centre_of(d[b])) < d[a].radius_m + d[b].radius_m)
                touching.insert(std::minmax(state.discs.id[a], state.discs.id[b]));
    return touching;
}

/// Those in the inner list that overlap. Fails if a pair is listed twice, with itself, or out of order.
std::set<Pair> find_listed(const State& state) {
    std::set<Pair> all, touching;
    const auto& p = state.pairs;
    Pair last{0, 0};
    for (const std::uint32_t n : p.inner) {
        const std::uint32_t i = p.i[n], j = p.j[n];
        EXPECT_LT(i, j);
        EXPECT_TRUE(all.empty() || last < Pair(i, j)) << "inner list is not sorted";
        last = {i, j};
        const Pair ids = std::minmax(state.discs.id[i], state.discs.id[j]);
        EXPECT_TRUE(all.insert(ids).second) << "pair " << ids.first << ", " << ids.second << " is listed twice";
        const Disc &a = state.discs.disc[i], &b = state.discs.disc[j];
        if (norm(centre_of(a) - centre_of(b)) < a.radius_m + b.radius_m) touching.insert(ids);
    }
    return touching;
}

class Lists : public testing::TestWithParam<Bed> {};

TEST_P(Lists, hold_every_touching_pair_once) {
    World w = make_bed(GetParam(), 0);
    std::size_t checks = 0, touches = 0;
    for (int n = 0; n < 600; ++n) {
        update_lists(w.scene.dem, w.state, w.work.dem);  // as step() does first
        if (n % 8 == 0) {
            const std::set<Pair> touching = find_touching(w.state);
            ASSERT_EQ(find_listed(w.state), touching) << "at step " << n;
            ++checks, touches += touching.size();
        }
        advance(w, 1);
    }
    std::vector<std::uint32_t> ids = w.state.discs.id;
    std::sort(ids.begin(), ids.end());
    for (std::uint32_t k = 0; k < ids.size(); ++k) ASSERT_EQ(ids[k], k) << "a disc was lost or doubled in sorting";
    std::printf("%zu discs: %zu touching pairs in %zu checks, %llu rebuilds, %llu refreshes\n", ids.size(), touches,
                checks, static_cast<unsigned long long>(w.work.dem.rebuilds),
                static_cast<unsigned long long>(w.work.dem.refreshes));
    if (GetParam().count > 2) {
        EXPECT_GT(touches, 0U);
    }
    EXPECT_GE(w.work.dem.rebuilds, 3U);  // else the test has not seen what it is about
}

INSTANTIATE_TEST_SUITE_P(RandomBeds, Lists,
                         testing::Values(Bed{1, 0.3, 0.5, 1, Walls::flat}, Bed{2, 0.5, 0.5, 2, Walls::flat},
                                         Bed{3, 0.5, 0.5, 3, Walls::flat}, Bed{40, 0.6, 0.5, 4, Walls::flat},
                                         Bed{40, 0.1, 2.0, 5, Walls::none}, Bed{300, 0.7, 0.8, 6, Walls::discs},
                                         Bed{300, 0.6, 3.0, 7, Walls::flat}, Bed{1500, 0.6, 0.5, 8, Walls::flat},
                                         Bed{2200, 0.4, 1.0, 9, Walls::none}));

// ---- Forces and springs -------------------------------------------------------------------------------------------

/// Largest difference of forces, moments, rolling limits and springs between the code and all pairs, relative to the
/// largest.
struct Difference {
    double force = 0, moment = 0, rolling = 0, spring = 0;
};

void compare(const World& w, const reference::Dem& all_pairs, double gravity_scale_N, Difference& worst) {
    double force = gravity_scale_N, moment = gravity_scale_N * 0.002, rolling = 1e-9;
    for (const reference::Force& f : all_pairs.force) {
        force = std::fmax(force, norm(f.force_N)), moment = std::fmax(moment, std::fabs(f.moment_Nm));
        rolling = std::fmax(rolling, f.rolling_limit_Nm);
    }
    for (std::size_t p = 0; p < w.state.discs.disc.size(); ++p) {
        const DiscForce& got = force_on(w, p);
        const reference::Force& want = all_pairs.force[w.state.discs.id[p]];
        worst.force = std::fmax(worst.force, norm(Vec2{got.x_N, got.y_N} - want.force_N) / force);
        worst.moment = std::fmax(worst.moment,
                                 std::fabs(w.state.discs.disc[p].radius_m * got.turning_N - want.moment_Nm) / moment);
        worst.rolling = std::fmax(worst.rolling, std::fabs(got.rolling_Nm - want.rolling_limit_Nm) / rolling);
    }
    double spring = 1e-9;
    for (const auto& [pair, u] : all_pairs.pair_spring_m) spring = std::fmax(spring, std::fabs(u));
    std::size_t found = 0;
    const auto look_up = [&](const auto& springs, Pair key, double got) {
        const auto at = springs.find(key);
        if (at != springs.end()) ++found;
        worst.spring = std::fmax(worst.spring, std::fabs(got - (at == springs.end() ? 0.0 : at->second)) / spring);
    };
    const auto& p = w.state.pairs;
    for (std::size_t n = 0; n < p.inner.size(); ++n)
        look_up(all_pairs.pair_spring_m,
                std::minmax(w.state.discs.id[p.i[p.inner[n]]], w.state.discs.id[p.j[p.inner[n]]]), p.tangential_m[n]);
    for (const BoundaryContact& c : w.state.wall_contacts)
        look_up(all_pairs.wall_spring_m, {c.disc, c.surface}, c.tangential_m);
    ASSERT_EQ(found, all_pairs.pair_spring_m.size() + all_pairs.wall_spring_m.size()) << "a contact is not listed";
}

class Forces : public testing::TestWithParam<Bed> {};

// The reference walks along the code's own path, so that chaos cannot blur the comparison: at every step both see the
// same positions, but each carries its own springs through all rebuilds.
TEST_P(Forces, and_springs_equal_those_of_all_pairs) {
    World w = make_bed(GetParam(), 9.81);
    reference::Dem all_pairs;
    Difference worst;
    std::size_t loaded = 0;
    for (int n = 0; n < 300; ++n) {
        all_pairs.evaluate(w.scene.dem, reference::by_id(w.state), w.scene.dem.step_s);
        advance(w, 1);
        compare(w, all_pairs, 0.01, worst);
        ASSERT_FALSE(HasFatalFailure()) << "at step " << n;
        loaded += all_pairs.pair_spring_m.size();
    }
    std::printf(
        "%zu discs: %zu springs followed, %llu rebuilds; differences: force %.1e, moment %.1e, rolling %.1e, spring "
        "%.1e\n",
        w.state.discs.disc.size(), loaded, static_cast<unsigned long long>(w.work.dem.rebuilds), worst.force,
        worst.moment, worst.rolling, worst.spring);
    EXPECT_GE(w.work.dem.rebuilds, 3U);
    // Overlaps are differences of millimetres: 1e-16 × 3 mm / overlap (1 to 100 µm) is left of each force.
    EXPECT_LT(worst.force, 1e-12);
    EXPECT_LT(worst.moment, 1e-12);
    EXPECT_LT(worst.rolling, 1e-10);  // the half chord from r² − x² cancels some digits more
    EXPECT_LT(worst.spring, 1e-10);   // sums up over the life of a contact
}

INSTANTIATE_TEST_SUITE_P(RandomBeds, Forces,
                         testing::Values(Bed{2, 0.6, 0.5, 12, Walls::flat}, Bed{60, 0.7, 0.8, 13, Walls::flat},
                                         Bed{60, 0.7, 0.8, 14, Walls::discs}, Bed{250, 0.75, 0.6, 15, Walls::discs},
                                         Bed{250, 0.75, 1.5, 16, Walls::flat}, Bed{60, 0.7, 0.8, 17, Walls::both},
                                         Bed{60, 0.7, 0.8, 18, Walls::flat, 0}));

/// The kernel of a width; of one that this processor lacks, the same source in instructions that all have.
PairKernel kernel_of(int width) {
    if (width <= vector_width()) return choose_pair_kernel(width);
    if (width == 4) return [](const ContactConstants& k, const PairBatch& batch) { add_pairs<4>(k, batch); };
    return [](const ContactConstants& k, const PairBatch& batch) { add_pairs<8>(k, batch); };
}

/// A bed after many steps that run over `width` pairs at a time.
World advance_with(int width, const Bed& bed, bool rolling_springs) {
    World w = make_bed(bed, 9.81);
    w.scene.dem.rolling_springs = rolling_springs, w.scene.dem.soil.rolling_cap = 0.1;
    w.work = make_workspace(w.scene, w.state);
    w.work.dem.vector_width = width, w.work.dem.pair_kernel = kernel_of(width);
    advance(w, 200);
    return w;
}

TEST(Widths, give_the_bits_of_scalar_code_for_each_rolling_resistance) {
    const Bed rolling{250, 0.75, 0.6, 19, Walls::flat}, smooth{250, 0.75, 0.6, 19, Walls::flat, 0};
    std::set<std::uint64_t> different;
    for (const auto& [bed, springs] : {std::pair(rolling, false), {smooth, false}, {smooth, true}}) {
        const std::uint64_t scalar = hash_state(advance_with(1, bed, springs).state);
        for (const int width : {2, 4, 8})
            EXPECT_EQ(hash_state(advance_with(width, bed, springs).state), scalar)
                << width << " lanes, rolling " << bed.rolling_chords << ", springs " << springs;
        different.insert(scalar);
    }
    EXPECT_EQ(different.size(), 3U) << "two of the resistances do the same: the test tests nothing";
}

// More than one block of discs, so that forces come together from several threads' slots.
TEST(Blocks, forces_of_several_blocks_equal_those_of_all_pairs) {
    World w = make_bed({2600, 0.6, 0.5, 21, Walls::flat}, 9.81);
    reference::Dem all_pairs;
    Difference worst;
    for (int n = 0; n < 6; ++n) {
        all_pairs.evaluate(w.scene.dem, reference::by_id(w.state), w.scene.dem.step_s);
        advance(w, 1);
        compare(w, all_pairs, 0.01, worst);
    }
    std::printf("%zu discs in %zu blocks: force %.1e, moment %.1e, spring %.1e\n", w.state.discs.disc.size(),
                w.work.dem.block.size(), worst.force, worst.moment, worst.spring);
    EXPECT_GE(w.work.dem.block.size(), 3U);
    EXPECT_LT(worst.force, 1e-12);
    EXPECT_LT(worst.moment, 1e-12);
    EXPECT_LT(worst.spring, 1e-10);
}

// Up to the next health check a lost disc is among the others, which must not notice.
TEST(Lists, bear_discs_that_are_no_longer_anywhere) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double lost : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 1e200}) {
        for (const std::vector<std::uint32_t>& which : {std::vector<std::uint32_t>{0}, {17}, {39}, {0, 1, 38, 39}}) {
            World w = make_bed({40, 0.6, 0, 4, Walls::flat}, 0);
            for (const std::uint32_t p : which) w.state.discs.disc[p].x_m = lost, w.state.discs.disc[p].y_m = -lost;
            w.work = make_workspace(w.scene, w.state);
            update_lists(w.scene.dem, w.state, w.work.dem);
            EXPECT_EQ(find_listed(w.state), find_touching(w.state)) << lost;
            EXPECT_GT(find_touching(w.state).size(), 0U);
        }
        World w = make_bed({3, 0.5, 0, 3, Walls::none}, 0);
        for (Disc& d : w.state.discs.disc) d.x_m = lost;
        w.work = make_workspace(w.scene, w.state);
        update_lists(w.scene.dem, w.state, w.work.dem);
    }
}

// Not every step looks at every disc; a disc that leaves its skin is seen in that step all the same.
TEST(Lists, are_asked_for_in_the_step_in_which_a_disc_leaves_its_skin) {
    World w = make_bed({2600, 0.6, 0.2, 41, Walls::flat}, 9.81);
    const auto& disc = w.state.discs.disc;
    int due = 0, unlooked = 0;
    for (int n = 0; n < 800; ++n) {
        Disc& struck = w.state.discs.disc[static_cast<std::size_t>(n) * 7 % disc.size()];
        if (n % 50 == 49) struck.vx_m_s = 0.1 * n;
        if (n == 799) struck.vy_m_s = std::numeric_limits<double>::quiet_NaN();
        advance(w, 1);
        bool left = false;
        for (std::size_t p = 0; p < disc.size(); ++p) left |= has_left(disc[p], w.state.pairs.inner_reference[p]);
        ASSERT_EQ(w.work.dem.refresh_inner, left) << "step " << n;
        due += left ? 1 : 0;
        for (const Block& b : w.work.dem.block) unlooked += b.calm_steps > 0 ? 1 : 0;
    }
    std::printf("lists due after %d of 800 steps; a block's next look could wait %d times\n", due, unlooked);
    EXPECT_TRUE(w.work.dem.refresh_inner) << "a disc that is nowhere";
    EXPECT_GT(due, 20);
    EXPECT_LT(due, 400);
    EXPECT_TRUE(w.work.dem.vector_width < 4 || unlooked > 400);
}

// A workspace made anew from a state in mid-flight finds the same forces: nothing that matters lives outside the state.
TEST(Lists, a_new_workspace_continues_with_the_same_bits) {
    World w = make_bed({200, 0.7, 0.6, 31, Walls::flat}, 9.81);
    advance(w, 137);
    World resumed = w;
    resumed.work = make_workspace(resumed.scene, resumed.state);
    advance(w, 100);
    advance(resumed, 100);
    EXPECT_EQ(hash_state(w.state), hash_state(resumed.state));
}

}  // namespace
}  // namespace ifedem

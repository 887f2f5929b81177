// What `ifedem doubt` says and `ifedem fit` decides, on made-up window means.
#include "check/differences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "check/least_share.hpp"
#include "core/error.hpp"

using namespace ifedem;

namespace {

std::vector<RunMetrics> runs_of(const std::vector<double>& sinkages_cm) {
    std::vector<RunMetrics> runs;
    for (const double z : sinkages_cm) {
        runs.push_back(unknown_metrics());
        runs.back().sinkage_cm = z;
    }
    return runs;
}

Difference compare_sinkages(const std::vector<double>& before, const std::vector<double>& after, double tolerance) {
    return find_difference(runs_of(before), runs_of(after), parse_quantities("z").front(), tolerance);
}

}  // namespace

TEST(Differences, ArePairedByRealisation) {
    // Differences −0.1, −0.2, −0.3: mean −0.2, s = 0.1, half-width 4.3027 · 0.1 / √3.
    const Difference d = compare_sinkages({-4, -5, -6}, {-4.1, -5.2, -6.3}, 0.05);
    EXPECT_NEAR(d.before, -5, 1e-12);
    EXPECT_NEAR(d.after, -5.2, 1e-12);
    EXPECT_NEAR(d.paired.mean, -0.2, 1e-12);
    EXPECT_NEAR(d.paired.half_width, 4.302653 * 0.1 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(d.tolerance, 0.25, 1e-12);  // of the size, whatever the sign
}

TEST(Differences, MoveStayOrCannotBeTold) {
    EXPECT_EQ(judge_movement(compare_sinkages({-4, -5, -6}, {-4.4, -5.5, -6.6}, 0.05)), Movement::moves);
    // Clearly other than before, if by less than the tolerance: it moves, and the table says by how much.
    EXPECT_EQ(judge_movement(compare_sinkages({-4, -5, -6}, {-4.10, -5.11, -6.12}, 0.05)), Movement::moves);
    EXPECT_EQ(judge_movement(compare_sinkages({-4, -5, -6}, {-4.01, -5.02, -5.98}, 0.05)), Movement::within_scatter);
    EXPECT_EQ(judge_movement(compare_sinkages({-4, -5, -6}, {-4.5, -5.0, -5.5}, 0.05)), Movement::cannot_tell);
    EXPECT_EQ(to_text(Movement::within_scatter), "within scatter");
}

TEST(Differences, AreSmallOnlyIfShownUnlessTheMeanIsAskedFor) {
    const Difference small = compare_sinkages({-4, -5, -6}, {-4.10, -5.11, -6.12}, 0.05);  // 0.11 ± 0.025 of 0.25
    EXPECT_TRUE(is_small(small, DifferenceEvidence::shown));
    EXPECT_TRUE(is_small(small, DifferenceEvidence::mean));
    const Difference noisy = compare_sinkages({-4, -5, -6}, {-4.5, -5.0, -5.5}, 0.05);  // 0 ± 1.24
    EXPECT_FALSE(is_small(noisy, DifferenceEvidence::shown));
    EXPECT_TRUE(is_small(noisy, DifferenceEvidence::mean));
    const Difference large = compare_sinkages({-4, -5, -6}, {-4.3, -5.3, -6.3}, 0.05);
    EXPECT_FALSE(is_small(large, DifferenceEvidence::mean));
    // More scatter about the same mean never helps.
    EXPECT_FALSE(is_small(compare_sinkages({-4, -5, -6}, {-3.3, -5.3, -7.3}, 0.05), DifferenceEvidence::mean));
}

TEST(Differences, OfWhatWasNotMeasuredAreNeverSmall) {
    const std::vector<RunMetrics> runs = runs_of({-4, -5, -6});
    const Difference d = find_difference(runs, runs, parse_quantities("H").front(), 0.05);
    EXPECT_FALSE(is_small(d, DifferenceEvidence::mean));
    EXPECT_EQ(judge_movement(d), Movement::cannot_tell);
}

TEST(Differences, WithoutEffectScatterAsTwoBedsDo) {
    const Difference d = expect_no_difference(runs_of({-4, -5, -6}), parse_quantities("z").front(), 0.05);
    EXPECT_EQ(d.paired.mean, 0);
    EXPECT_NEAR(d.paired.half_width, 4.302653 * std::sqrt(2.0 / 3), 1e-6);
}

TEST(Differences, SayHowManyRealisationsWouldDo) {
    const Difference d = compare_sinkages({-4, -5, -6}, {-4.5, -5.0, -5.5}, 0.05);  // s = 0.5, tolerance 0.25
    const double n = realisations_needed(d);
    EXPECT_LE(student_t_quantile(0.975, n - 1) * 0.5 / std::sqrt(n), 0.25);
    EXPECT_GT(student_t_quantile(0.975, n - 2) * 0.5 / std::sqrt(n - 1), 0.25);
    EXPECT_TRUE(std::isinf(realisations_needed(compare_sinkages({-1, 0, 1}, {-1, 1, 1}, 0.05))));
}

TEST(Differences, AreAskedForByName) {
    const std::vector<ComparedMetric> quantities = parse_quantities("H,Pd,R,z,torque_Nm");
    ASSERT_EQ(quantities.size(), 5U);
    EXPECT_EQ(quantities[1].metric->name, "net_traction_N");
    EXPECT_EQ(quantities[4].metric->name, "torque_Nm");
    for (const char* text : {"", "H,", "Pd,drawbar", "h"}) EXPECT_THROW((void)parse_quantities(text), Error) << text;
    EXPECT_DOUBLE_EQ(parse_tolerance("5%"), 0.05);
    EXPECT_DOUBLE_EQ(parse_tolerance("2.5%"), 0.025);
    for (const char* text : {"", "%", "5", "0.05", "0%", "-5%", "100%", "nan%", "five%", "5 %%"})
        EXPECT_THROW((void)parse_tolerance(text), Error) << text;
}

namespace {

/// The search where every share from `least` on is good.
struct Search {
    double found = 0;
    std::vector<double> tried;
};
Search search(double least, double pointless_below = 0) {
    Search s;
    s.found = find_least_share([&](double share) {
        if (share < pointless_below) return Trial::pointless;
        s.tried.push_back(share);
        return share >= least ? Trial::kept : Trial::refused;
    });
    return s;
}

}  // namespace

TEST(LeastShare, HalvesThenTakesAQuarterOff) {
    const Search s = search(0.2);
    EXPECT_EQ(s.tried, (std::vector<double>{0.5, 0.25, 0.125, 0.188}));
    EXPECT_EQ(s.found, 0.25);
    EXPECT_EQ(search(0.3).found, 0.375);
    EXPECT_EQ(search(0.3).tried, (std::vector<double>{0.5, 0.25, 0.375, 0.281}));
}

TEST(LeastShare, LeavesWhatCannotBeLess) {
    EXPECT_EQ(search(1).found, 1);
    EXPECT_EQ(search(1).tried, (std::vector<double>{0.5, 0.75}));
}

TEST(LeastShare, EndsWhereATrialIsPointless) {
    EXPECT_EQ(search(0, 0.1).found, 0.125);
    EXPECT_TRUE(search(0, 2).tried.empty());
}

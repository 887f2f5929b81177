#include "check/cost_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace ifedem;

namespace {
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
}

TEST(Cost, IsDiscsTimesStepsTimesWhatOneCosts) {
    EXPECT_DOUBLE_EQ((Work{2e9, 15}.cpu_s()), 30);
    // 19,468 discs, 11.5 s at 1e-5 s: 1.15e6 steps.
    const Work text = fidelity_work(19468, 1e-5, 11.5, 10);
    EXPECT_NEAR(text.disc_steps, 19468 * 1.15e6, 1);
    EXPECT_NEAR(text.cpu_s(), 223.882, 1e-6);
}

TEST(Front, KeepsWhatNoOtherBeats) {
    //                                    cheap, wrong  beaten    middle    dear, right  dearest, no better
    const std::vector<CostError> points{{5, 2}, {1, 10}, {2, 11}, {3, 4}, {8, 1}, {9, 1}};
    EXPECT_EQ(pareto_front(points, 0), (std::vector<std::size_t>{1, 3, 0, 4}));
}

TEST(Front, EndsAtTheCheapestPointWithinScatter) {
    const std::vector<CostError> points{{1, 10}, {3, 1.9}, {5, 0.1}, {8, 1}};
    EXPECT_EQ(pareto_front(points, 2), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(pareto_front(points, 1.5), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Front, LeavesOutWhatIsNotKnown) {
    const std::vector<CostError> points{{1, unknown}, {unknown, 1}, {2, 3}};
    EXPECT_EQ(pareto_front(points, unknown), (std::vector<std::size_t>{2}));
    EXPECT_TRUE(pareto_front({}, 0).empty());
}

TEST(Front, TakesTheBetterOfTwoThatCostTheSame) {
    const std::vector<CostError> points{{1, 3}, {1, 2}};
    EXPECT_EQ(pareto_front(points, 0), (std::vector<std::size_t>{1}));
}

TEST(ScatterFloor, IsStudentsIntervalOfAMeanByThePooledScatter) {
    const std::vector<std::vector<double>> groups{{0, 2}, {0, 3, 6}, {7}};  // s² = 20/3, ν = 3
    constexpr double t3 = 3.182446305284263;                                // tables: 0.975, ν = 3
    EXPECT_NEAR(scatter_floor(pool_scatter(groups), 4), t3 * std::sqrt(20.0 / 3) / 2, 1e-6);
    EXPECT_TRUE(std::isinf(scatter_floor(pool_scatter(std::vector<std::vector<double>>{{1}, {2}}), 1)));
}

TEST(Labels, MeetNeitherEachOtherNorAMark) {
    std::vector<Label> labels;
    for (int k = 0; k < 12; ++k) labels.push_back({100.0 + 3 * k, 100.0 + (k % 3), 60, 12});
    const Box area{0, 0, 400, 300};
    const auto boxes = place_labels(labels, area);
    ASSERT_EQ(boxes.size(), labels.size());
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        EXPECT_GE(boxes[a].left, area.left);
        EXPECT_LE(boxes[a].right, area.right);
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            if (a != b) EXPECT_FALSE(boxes[a].meets(boxes[b])) << a << " " << b;
            EXPECT_FALSE(boxes[a].meets({labels[b].x - 1, labels[b].y - 1, labels[b].x + 1, labels[b].y + 1}));
        }
    }
}

TEST(Labels, StandBesideTheirMarkWhereThereIsRoom) {
    const auto boxes = place_labels(std::vector<Label>{{50, 50, 40, 12}}, {0, 0, 400, 300});
    EXPECT_DOUBLE_EQ(boxes[0].left, 58);
    EXPECT_DOUBLE_EQ(0.5 * (boxes[0].bottom + boxes[0].top), 50);
}

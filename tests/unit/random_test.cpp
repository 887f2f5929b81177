#include "core/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <vector>

namespace ifedem {
namespace {

TEST(Random, GivesThePublishedNumbersOfSplitMix64) {
    // First outputs for seed 0 and 1234567, as printed with the reference implementation (S. Vigna) and its ports.
    Random zero{0};
    EXPECT_EQ(zero.next(), 0xe220a8397b1dcdafULL);
    EXPECT_EQ(zero.next(), 0x6e789e6aa1b965f4ULL);
    EXPECT_EQ(zero.next(), 0x06c45d188009454fULL);
    Random other{1234567};
    EXPECT_EQ(other.next(), 6457827717110365317ULL);
    EXPECT_EQ(other.next(), 3203168211198807973ULL);
    EXPECT_EQ(other.next(), 9817491932198370423ULL);
    EXPECT_EQ(other.next(), 4593380528125082431ULL);
    EXPECT_EQ(other.next(), 16408922859458223821ULL);
}

TEST(Random, GoesOnFromItsStateAlone) {
    Random first{7};
    for (int k = 0; k < 100; ++k) first.next();
    Random second{first.state};
    for (int k = 0; k < 100; ++k) ASSERT_EQ(first.next(), second.next());
}

TEST(Random, UniformFillsTheUnitIntervalEvenly) {
    constexpr int draws = 200000;
    constexpr std::size_t bins = 100;
    std::array<double, bins> count{};
    Random random{8};
    for (int k = 0; k < draws; ++k) {
        const double u = random.uniform();
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        count[static_cast<std::size_t>(u * bins)] += 1.0;
    }
    double chi_squared = 0.0;
    const double expected = double{draws} / bins;
    for (const double c : count) chi_squared += (c - expected) * (c - expected) / expected;
    EXPECT_LT(chi_squared, 149.4);  // 99 degrees of freedom, 0.1 %
    EXPECT_GT(chi_squared, 60.3);   // too even would be as wrong
}

TEST(Random, BelowReachesEveryNumberAndNoOther) {
    for (const std::uint64_t n : {1ULL, 2ULL, 3ULL, 7ULL, 64ULL}) {
        std::map<std::uint64_t, int> seen;
        Random random{9};
        for (std::uint64_t k = 0; k < 100 * n; ++k) ++seen[random.below(n)];
        EXPECT_EQ(seen.size(), n);
        EXPECT_EQ(seen.rbegin()->first, n - 1);
    }
}

TEST(Random, BelowIsUnbiasedWhereAModuloWouldNotBe) {
    // n = 3·2⁶²: the plain remainder would take the lowest quarter twice as often (share 1/2 instead of 1/3).
    constexpr std::uint64_t n = 3ULL << 62;
    constexpr int draws = 90000;
    Random random{10};
    int low = 0;
    for (int k = 0; k < draws; ++k) {
        const std::uint64_t draw = random.below(n);
        ASSERT_LT(draw, n);
        if (draw < n / 3) ++low;
    }
    EXPECT_NEAR(static_cast<double>(low) / draws, 1.0 / 3.0, 4 * 0.00157);  // four standard deviations
}

TEST(Random, ShuffleGivesEachOrderItsShare) {
    constexpr int draws = 60000;
    std::map<std::vector<int>, int> count;
    Random random{11};
    for (int k = 0; k < draws; ++k) {
        std::vector<int> items{1, 2, 3};
        shuffle(items, random);
        ++count[items];
    }
    ASSERT_EQ(count.size(), 6U);
    double chi_squared = 0.0;
    for (const auto& [order, c] : count) chi_squared += (c - draws / 6.0) * (c - draws / 6.0) / (draws / 6.0);
    EXPECT_LT(chi_squared, 20.5);  // 5 degrees of freedom, 0.1 %
}

TEST(Random, ShuffleKeepsTheItemsAndTheSeedDecidesTheOrder) {
    std::vector<int> first(1000);
    std::iota(first.begin(), first.end(), 0);
    std::vector<int> second = first;
    std::vector<int> other = first;
    const std::vector<int> original = first;
    Random a{12};
    Random b{12};
    Random c{13};
    shuffle(first, a);
    shuffle(second, b);
    shuffle(other, c);
    EXPECT_EQ(first, second);
    EXPECT_NE(first, other);
    EXPECT_NE(first, original);
    EXPECT_TRUE(std::is_permutation(first.begin(), first.end(), original.begin()));
}

}  // namespace
}  // namespace ifedem

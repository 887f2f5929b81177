#include "core/bitmath.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/random.hpp"

// The reference is the C library's long double (64-bit mantissa, argument reduction to the last bit), which has eleven
// bits more than what it judges.
static_assert(std::numeric_limits<long double>::digits >= 64);

namespace ifedem {
namespace {

/// |computed − reference| in units of the spacing of doubles at the reference.
long double count_ulps(double computed, long double reference) {
    const double nearest = std::fabs(static_cast<double>(reference));
    const double spacing = std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
    return std::fabs(static_cast<long double>(computed) - reference) / static_cast<long double>(spacing);
}

long double worst_cos_sin_ulps(const std::vector<double>& angles) {
    long double worst = 0;
    for (const double angle : angles) {
        const CosSin r = cos_sin(angle);
        worst = std::fmax(worst, count_ulps(r.cos, std::cos(static_cast<long double>(angle))));
        worst = std::fmax(worst, count_ulps(r.sin, std::sin(static_cast<long double>(angle))));
    }
    return worst;
}

double draw_signed(Random& random, double size) { return size * (2.0 * random.uniform() - 1.0); }

/// Magnitudes from 2^low to 2^high, each binade alike, either sign.
double draw_binade(Random& random, int low, int high) {
    const int exponent = low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
    const double value = std::ldexp(1.0 + random.uniform(), exponent);
    return random.below(2) == 0 ? value : -value;
}

TEST(CosSin, IsWithinTwoUlpsForAnglesOfAllSizes) {
    Random random{1};
    std::vector<double> angles;
    for (int k = 0; k < 250000; ++k) {
        angles.push_back(draw_signed(random, 1e6));
        angles.push_back(draw_signed(random, 10.0));
        angles.push_back(draw_signed(random, 1.0));
        angles.push_back(draw_binade(random, -40, 19));
    }
    const long double worst = worst_cos_sin_ulps(angles);
    RecordProperty("worst_ulp", std::to_string(static_cast<double>(worst)));
    EXPECT_LE(worst, 2.0L);
}

TEST(CosSin, IsWithinTwoUlpsNextToEveryMultipleOfAQuarterTurn) {
    // Where the reduction cancels most: the doubles on both sides of k π/4 for every k in the range.
    const long double quarter_pi = std::atan(1.0L);
    std::vector<double> angles;
    for (int k = 0; k <= 1273239; k += 2) {
        const auto angle = static_cast<double>(static_cast<long double>(k) * quarter_pi);
        if (angle <= 1e6) angles.push_back(angle);
    }
    for (int k = 1; k <= 20001; k += 2) {  // where the quadrant changes
        const auto angle = static_cast<double>(static_cast<long double>(k) * quarter_pi);
        angles.push_back(std::nextafter(angle, 0.0));
        angles.push_back(std::nextafter(angle, 1e7));
    }
    const long double worst = worst_cos_sin_ulps(angles);
    RecordProperty("worst_ulp", std::to_string(static_cast<double>(worst)));
    EXPECT_LE(worst, 2.0L);
}

TEST(CosSin, IsExactlyEvenAndOdd) {
    Random random{2};
    for (int k = 0; k < 100000; ++k) {
        const double angle = draw_binade(random, -60, 19);
        const CosSin plus = cos_sin(angle);
        const CosSin minus = cos_sin(-angle);
        ASSERT_EQ(plus.cos, minus.cos) << angle;
        ASSERT_EQ(plus.sin, -minus.sin) << angle;
    }
}

TEST(CosSin, HasTheClosedFormsAtZeroAndForTinyAngles) {
    EXPECT_EQ(cos_sin(0.0).cos, 1.0);
    EXPECT_EQ(cos_sin(0.0).sin, 0.0);
    EXPECT_EQ(cos_sin(1e-300).sin, 1e-300);
    EXPECT_EQ(cos_sin(5e-324).sin, 5e-324);
    EXPECT_EQ(cos_sin(1e-9).cos, 1.0);
    EXPECT_EQ(cos_sin(pi / 2).sin, 1.0);
    EXPECT_EQ(cos_sin(pi).cos, -1.0);
}

TEST(CosSin, IsNotANumberOutsideItsRange) {
    for (const double angle : {1.1e6, -1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_TRUE(std::isnan(cos_sin(angle).cos)) << angle;
        EXPECT_TRUE(std::isnan(cos_sin(angle).sin)) << angle;
    }
    EXPECT_FALSE(std::isnan(cos_sin(1e6).cos));
}

TEST(Atan2, IsWithinFourUlpsInAllDirectionsAndSizes) {
    Random random{3};
    long double worst = 0;
    for (int k = 0; k < 500000; ++k) {
        const double x = k % 2 == 0 ? draw_signed(random, 1.0) : draw_binade(random, -300, 300);
        const double y = k % 2 == 0 ? draw_signed(random, 1.0) : x * draw_binade(random, -60, 60);
        for (const double side : {x, -x}) {
            const long double reference = std::atan2(static_cast<long double>(y), static_cast<long double>(side));
            worst = std::fmax(worst, count_ulps(atan2_fixed(y, side), reference));
        }
    }
    RecordProperty("worst_ulp", std::to_string(static_cast<double>(worst)));
    EXPECT_LE(worst, 4.0L);
}

TEST(Atan2, HoldsAtTheEndsOfTheDoubles) {
    const double large = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    for (const double y : {large, large / 3, 1.0, 1e-300, 7 * tiny, tiny}) {
        for (const double x : {large, -large, large / 7, 1.0, -1.0, 3e-300, 3 * tiny, -tiny}) {
            const long double reference = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
            EXPECT_LE(count_ulps(atan2_fixed(y, x), reference), 4.0L) << y << ' ' << x;
        }
    }
    EXPECT_TRUE(std::isnan(atan2_fixed(std::nan(""), 1.0)));
    EXPECT_TRUE(std::isnan(atan2_fixed(1.0, std::nan(""))));
    EXPECT_TRUE(std::isnan(atan2_fixed(std::numeric_limits<double>::infinity(), 1.0)));
}

TEST(Atan2, HasTheClosedFormsOnAxesAndDiagonals) {
    EXPECT_EQ(atan2_fixed(0.0, 0.0), 0.0);
    EXPECT_EQ(atan2_fixed(0.0, 2.0), 0.0);
    EXPECT_EQ(atan2_fixed(0.0, -2.0), pi);
    EXPECT_EQ(atan2_fixed(-0.0, -2.0), pi);  // the range is (−π, π]: a signed zero has no side
    EXPECT_EQ(atan2_fixed(3.0, 0.0), pi / 2);
    EXPECT_EQ(atan2_fixed(-3.0, 0.0), -pi / 2);
    EXPECT_EQ(atan2_fixed(5.0, 5.0), pi / 4);
    EXPECT_EQ(atan2_fixed(5.0, -5.0), 3 * (pi / 4));
    EXPECT_EQ(atan2_fixed(-5.0, 5.0), -pi / 4);
}

TEST(Atan2, IsExactlyOddAndScaleFree) {
    Random random{4};
    for (int k = 0; k < 100000; ++k) {
        const double x = draw_signed(random, 1.0);
        const double y = draw_signed(random, 1.0);
        if (y == 0.0) continue;
        ASSERT_EQ(atan2_fixed(y, x), -atan2_fixed(-y, x)) << y << ' ' << x;
        ASSERT_EQ(atan2_fixed(y, x), atan2_fixed(std::ldexp(y, 40), std::ldexp(x, 40))) << y << ' ' << x;
    }
}

TEST(Atan2, UndoesCosSin) {
    Random random{5};
    for (int k = 0; k < 100000; ++k) {
        const double angle = draw_signed(random, 3.14159);
        const CosSin r = cos_sin(angle);
        // Rounding of the two components turns the angle by at most an ulp of 1.
        ASSERT_NEAR(atan2_fixed(r.sin, r.cos), angle, 8e-16);
    }
}

}  // namespace
}  // namespace ifedem

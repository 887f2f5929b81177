#include "check/bounce.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/bitmath.hpp"

namespace ifedem {
namespace {

constexpr double interval_s = 0.002;

std::vector<double> sample(std::size_t count, double amplitude_N, double frequency_Hz) {
    std::vector<double> force(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double t = static_cast<double>(k) * interval_s;
        force[k] = 170 + 60 * std::exp(-t / 2) + amplitude_N * std::sin(2 * pi * frequency_Hz * t) +
                   15 * std::sin(2 * pi * 60 * t) + 20 * std::sin(2 * pi * 12.5 * t);
    }
    return force;
}

TEST(Bounce, strongest_line_in_the_band) {
    for (const double frequency : {2.0, 6.0, 8.5}) {
        const Bounce b = find_bounce(sample(2000, 100, frequency), interval_s);
        EXPECT_NEAR(b.amplitude_N, 100, 5) << frequency;  // the transient leaks some newtons into low lines
        EXPECT_NEAR(b.frequency_Hz, frequency, 0.125) << frequency;
    }
}

TEST(Bounce, between_two_lines_frequency_is_that_of_the_nearer) {
    const Bounce b = find_bounce(sample(2000, 100, 6.1), interval_s);  // lines are 0.25 Hz apart
    EXPECT_NEAR(b.frequency_Hz, 6.0, 1e-9);
    EXPECT_GT(b.amplitude_N, 60);
}

TEST(Bounce, outside_the_band_is_no_bounce) {
    EXPECT_NEAR(find_bounce(sample(2000, 200, 0.5), interval_s).frequency_Hz, 12.5, 0.125);
    EXPECT_NEAR(find_bounce(sample(2000, 200, 40), interval_s).frequency_Hz, 12.5, 0.125);
    EXPECT_EQ(find_bounce(std::vector<double>(2000, 170.0), interval_s).amplitude_N, 0.0);
    EXPECT_EQ(find_bounce(std::vector<double>{170, 171}, interval_s).amplitude_N, 0.0);
}

}  // namespace
}  // namespace ifedem

// Measurements against targets, and what a table of knobs says.
#include "check/targets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace ifedem {
namespace {

TEST(Targets, OffAndItsUncertaintyAreThoseOfTheMean) {
    const TargetMatch m = match_target({37, 38, 39}, 40);
    EXPECT_NEAR(m.off, -2, 1e-12);
    EXPECT_NEAR(m.uncertainty, 4.302653 / std::sqrt(3.0), 1e-5);  // t(0.975, 2) s / √n, s = 1
}

TEST(Targets, AreWithinOffOrTooUncertainToTell) {
    EXPECT_EQ(match_target({37, 38, 39}, 39).verdict, TargetVerdict::within);
    EXPECT_EQ(match_target({37, 38, 39}, 41).verdict, TargetVerdict::too_low);
    EXPECT_EQ(match_target({37, 38, 39}, 35).verdict, TargetVerdict::too_high);
    EXPECT_EQ(match_target({30, 38, 46}, 39).verdict, TargetVerdict::cannot_tell) << "U is half of the target";
    EXPECT_EQ(match_target({30, 38, 46}, 90).verdict, TargetVerdict::too_low) << "off is off, however uncertain";
    EXPECT_EQ(match_target({39}, 39).verdict, TargetVerdict::cannot_tell) << "one realisation has no scatter";
}

TEST(Targets, NumbersHaveTheDecimalsOfTheirScatter) {
    EXPECT_EQ(number_within(47.6512, 0.53), "47.65");
    EXPECT_EQ(number_within(47.6512, 5.3), "47.7");
    EXPECT_EQ(number_within(47.6512, 53), "48");
    EXPECT_EQ(number_within(47.6512, 0), "47.7");
    EXPECT_EQ(number_within(std::nan(""), 1), "–");
    EXPECT_EQ(signed_within(1.24, 0.1), "+1.24");
    EXPECT_EQ(signed_within(-1.24, 0.1), "−1.24");
}

const std::string table =
    "name,key,change,before,after,difference,half_width,units,n\n"
    "angle,alpha,to 0,47,28,-19,2,deg,3\n"
    "angle,mu,× 0.5,47,44,-3,4,deg,3\n"
    "angle,contact.k,× 2,47,80,33,1.5,deg,3\n"
    "angle,beta,× 2,47,48,1,,deg,1\n"
    "modulus,mu,× 0.5,1,2,1,0.1,MPa,3\n";

TEST(Knobs, AreThoseWhoseIntervalLeavesOutZeroTheStrongestFirst) {
    EXPECT_EQ(list_knobs(table, "knobs.csv", "angle"),
              (std::vector<std::string>{"k × 2: +33.0 ± 1.5", "alpha to 0: −19.0 ± 2.0"}));
    EXPECT_TRUE(list_knobs(table, "knobs.csv", "porosity").empty());
}

TEST(Knobs, OfAnotherTableAreRefused) {
    EXPECT_THROW((void)list_knobs("name,value\na,1\n", "measurements.csv", "a"), Error);
}

}  // namespace
}  // namespace ifedem

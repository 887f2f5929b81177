// A difference between two states is named by member, row, disc and component.
#include "record/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace ifedem {
namespace {

State make_two_discs() {
    State s;
    s.discs.disc.resize(2);
    s.discs.id = {7, 3};
    s.discs.disc[1].vy_m_s = 0.1;
    s.pairs.i = {0}, s.pairs.j = {1};
    s.wheel_contacts = {{3, 12, 1e-6}};
    return s;
}

TEST(Compare, equal_states_have_no_difference) {
    EXPECT_FALSE(find_difference(make_two_discs(), make_two_discs()).has_value());
}

TEST(Compare, one_unit_in_the_last_place_is_named) {
    const State a = make_two_discs();
    State b = a;
    b.discs.disc[1].vy_m_s = std::nextafter(0.1, 1.0);
    const std::string text = find_difference(a, b).value_or("");
    EXPECT_TRUE(text.starts_with("discs/disc[1].vy_m_s (disc 3): 0.1")) << text;
    EXPECT_NE(text.find("against 0.10000000000000002"), std::string::npos) << text;
}

TEST(Compare, minus_zero_differs_from_zero) {
    const State a = make_two_discs();
    State b = a;
    b.wheel.rim.omega_rad_s = -0.0;
    EXPECT_TRUE(find_difference(a, b).value_or("").starts_with("wheel/rim[0].omega_rad_s: 0 "))
        << *find_difference(a, b);
}

TEST(Compare, mixed_rows_integers_and_lengths) {
    const State a = make_two_discs();
    State b = a;
    b.wheel_contacts[0].tangential_m = 2e-6;
    EXPECT_TRUE(find_difference(a, b).value_or("").starts_with("wheel_contacts[0].tangential_m: "))
        << *find_difference(a, b);
    b = a;
    b.pairs.j[0] = 0;
    EXPECT_EQ(find_difference(a, b).value_or(""), "pairs/j[0]: 1 against 0");
    b = a;
    b.pairs.i.push_back(1);
    EXPECT_EQ(find_difference(a, b).value_or(""), "pairs/i: 1 rows against 2");
}

}  // namespace
}  // namespace ifedem

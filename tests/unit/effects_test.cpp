#include "check/effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "check/csv.hpp"
#include "core/error.hpp"
#include "support/synthetic_runs.hpp"

using namespace ifedem;
using namespace ifedem::test;
namespace fs = std::filesystem;

namespace {

/// Writes a synthetic run whose case is changed by `change`.
template <class Change>
std::string write_variant(const fs::path& root, const SyntheticRun& r, const Change& change) {
    const auto directory = write_synthetic_run(root, r);
    Case c = synthetic_case(r);
    change(c);
    write_text(directory + "/case.toml", to_toml(c));
    return directory;
}

class Effects : public ::testing::Test {
protected:
    void SetUp() override {
        root =
            fresh_directory(std::string("effects-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        for (int k = 1; k <= 3; ++k)
            defaults.push_back(write_synthetic_run(
                root / "default", {.name = fmt::format("B3-earth-170N-s60-r{}", k), .seed = k, .effort_N = 99.0 + k}));
    }
    void TearDown() override { fs::remove_all(root); }

    std::string half_chord(int k, double effort_N) {
        return write_variant(root / "variant",
                             {.name = fmt::format("half-earth-s60-r{}", k), .seed = k, .effort_N = effort_N},
                             [](Case& c) { c.contact.rolling_chord = RollingChord::half; });
    }

    fs::path root;
    std::vector<std::string> defaults;
};

}  // namespace

TEST_F(Effects, OneRunBorrowsTheScatterOfTheDefault) {
    const auto effects = measure_effects(defaults, {half_chord(2, 80)});
    ASSERT_EQ(effects.size(), 4U);
    const Effect& h = effects[0];
    EXPECT_EQ(h.variant, "half");
    EXPECT_EQ(h.changes, "contact.rolling_chord \"full\" → \"half\"");
    EXPECT_EQ(h.metric, "gross_tractive_effort_N");
    EXPECT_NEAR(h.effect, 80 - 101, 0.01);  // against the same realisation, not the mean
    EXPECT_EQ(h.n, 1U);
    // s = 1 N with ν = 2: t(0.975, 2) · √2.
    EXPECT_NEAR(h.half_width, std::sqrt(0.9025 * 2 / 0.0975) * std::sqrt(2.0), 0.02);
}

TEST_F(Effects, ThreePairsTellTheirOwnInterval) {
    const auto effects = measure_effects(defaults, {half_chord(1, 80), half_chord(2, 82), half_chord(3, 84)});
    const Effect& h = effects[0];
    EXPECT_EQ(h.n, 3U);
    EXPECT_NEAR(h.before, 101, 0.01);
    EXPECT_NEAR(h.after, 82, 0.01);
    EXPECT_NEAR(h.effect, -19, 0.01);  // differences −20, −19, −18
    EXPECT_NEAR(h.half_width, std::sqrt(0.9025 * 2 / 0.0975) / std::sqrt(3.0), 0.02);
}

TEST_F(Effects, AShortTravelIsComparedOverTheSameWay) {
    // The default's start is in its first 2 cm only, so any later window has the same mean.
    const auto slow =
        write_variant(root / "variant", {.name = "slow-earth-s60-r1", .seed = 1, .effort_N = 90, .distance_m = 0.4},
                      [](Case& c) { c.travel.distance_m = 0.4; });
    const auto effects = measure_effects(defaults, {slow});
    EXPECT_NEAR(effects[0].effect, -10, 0.1);
    EXPECT_EQ(effects[0].changes, "travel.distance_m 0.8 → 0.4");
}

TEST_F(Effects, AVariantWithoutItsPartnerIsRefused) {
    EXPECT_THROW(static_cast<void>(measure_effects(defaults, {half_chord(4, 80)})), Error);
}

TEST_F(Effects, SurviveTheFileAndReachClaims) {
    write_effects(defaults, {half_chord(1, 80), half_chord(2, 82)}, (root / "out").string());
    const Campaign campaign = read_campaign({(root / "out").string()});
    EXPECT_TRUE(campaign.unusable.empty());
    ASSERT_EQ(campaign.effects.size(), 4U);
    const auto direct = measure_effects(
        defaults, {(root / "variant/half-earth-s60-r1").string(), (root / "variant/half-earth-s60-r2").string()});
    EXPECT_EQ(campaign.effects[0].changes, direct[0].changes);
    EXPECT_NEAR(campaign.effects[0].effect, direct[0].effect, 1e-4);
    EXPECT_NEAR(campaign.effects[0].half_width, direct[0].half_width, 1e-4);
    const Measurement* m = find_measurement(campaign, "half:earth:s60:gross_tractive_effort_N");
    ASSERT_NE(m, nullptr);
    EXPECT_NEAR(m->value, direct[0].effect, 1e-4);
    EXPECT_NEAR(*m->uncertainty, direct[0].half_width, 1e-4);
    const auto data = effects_data(campaign.effects, "earth", 60);
    ASSERT_TRUE(data);
    ASSERT_EQ(parse_csv(*data, "data").rows.size(), 1U);
    EXPECT_EQ(parse_csv(*data, "data").rows[0].cells[1], "rolling_chord full → half");
    EXPECT_FALSE(effects_data(campaign.effects, "mars", 60));
}

TEST(Changes, NameKeysOnceAndLeaveConditionsOut) {
    Case a, b;
    b.wheel.load_N = 50;
    b.bed.seed = 7;
    b.travel.slip_percent = 20;
    b.gravity_m_s2 = 3.71;
    EXPECT_EQ(describe_changes(a, b), "");
    b.contact.damping_ratio = 0.1;
    b.wheel.damping_frame = DampingFrame::absolute;
    b.stages.load_ramp_s = 0.8;
    EXPECT_EQ(describe_changes(a, b),
              "contact.damping_ratio 0.2 → 0.1, wheel.damping_frame \"rigid-motion\" → \"absolute\", "
              "stages.load_ramp_s 0.0 → 0.8");
}

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "check/evaluate.hpp"
#include "check/ordering.hpp"
#include "support/synthetic_campaign.hpp"

using namespace ifedem;
using namespace ifedem::test;

namespace {

/// Outcomes by id, of all claims or of one.
std::map<std::string, Outcome> judge(const Campaign& campaign, const std::string& only = "") {
    const std::string root = IFEDEM_SOURCE_DIR;
    const Ledger ledger = read_ledger(root);
    auto claims = read_claims(root + "/reproductions/chapter3/claims.csv", ledger);
    if (!only.empty()) std::erase_if(claims, [&](const Claim& claim) { return claim.id != only; });
    for (auto& claim : claims) claim.evidence.clear();  // the runs here are none of the campaign's
    std::map<std::string, Outcome> by_id;
    for (auto& o : evaluate(claims, ledger, campaign, root)) by_id.emplace(o.claim.id, o);
    return by_id;
}

/// Eight slips from 0 to 70 %, one run each with a known scatter.
TrendPoints curve(double (*f)(double), double scatter, double freedom = 10) {
    ValuesBySlip values;
    for (int slip = 0; slip <= 70; slip += 10) values[slip] = {f(slip)};
    return trend_points(values, {scatter, freedom});
}

}  // namespace

TEST(Chapter3Curves, AllHoldWhereTheRunsDoWhatTheTextSays) {
    int found = 0;
    for (const auto& [id, o] : judge(synthetic_campaign())) {
        if (!is_about_curves(o.claim.comparison)) continue;
        ++found;
        EXPECT_EQ(o.verdict, Verdict::match) << id << ": " << o.detail;
    }
    EXPECT_EQ(found, 24);
}

TEST(Chapter3Curves, EachFailsWhereTheRunsDoNot) {
    const auto is = [](const Condition& c, const char* wheel, double load) {
        return c.wheel == wheel && std::abs(c.load_N - load) < 1e-9;
    };
    const auto square = [](double i) { return i * i / 70; };
    const std::map<std::string, Distortion> distortions{{"D077",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 100))
                                                                 m.gross_tractive_effort_N =
                                                                     0.8 * square(c.slip_percent);
                                                         }},
                                                        {"D080",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 70)) m.net_traction_N *= -1;
                                                         }},
                                                        {"D081",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 50))
                                                                 m.motion_resistance_N = -20 + 0.2 * c.slip_percent;
                                                         }},
                                                        {"D081-b",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 50))
                                                                 m.motion_resistance_N = -square(c.slip_percent);
                                                         }},
                                                        {"D083",
                                                         [&](auto& c, auto& m) {
                                                             if (c.wheel == "B6") m.deflection_mm = 12;
                                                         }},
                                                        {"D085",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 170))
                                                                 m.gross_tractive_effort_N = square(c.slip_percent);
                                                         }},
                                                        {"D088",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 50)) m.net_traction_N += 30;
                                                         }},
                                                        {"D088-b",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 170)) m.net_traction_N += 15;
                                                         }},
                                                        {"D091",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 70))
                                                                 m.motion_resistance_N = -square(c.slip_percent);
                                                         }},
                                                        {"D092",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 130)) m.net_traction_N += 30;
                                                         }},
                                                        {"D093",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 50)) m.gross_tractive_effort_N += 5;
                                                         }},
                                                        {"D094",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 100))
                                                                 m.motion_resistance_N = -20 + 0.2 * c.slip_percent;
                                                         }},
                                                        {"D094-b",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 100))
                                                                 m.motion_resistance_N = -square(c.slip_percent);
                                                         }},
                                                        {"D095",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 130))
                                                                 m.sinkage_cm = -5 + 0.04 * c.slip_percent;
                                                         }},
                                                        {"D096",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 50)) m.sinkage_cm -= 4;
                                                         }},
                                                        {"D099",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 130)) m.sinkage_cm -= 1;
                                                         }},
                                                        {"D101",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 170))
                                                                 m.deflection_mm = 2 + 0.01 * c.slip_percent;
                                                         }},
                                                        {"D101-b",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 170))
                                                                 m.deflection_mm = 6 - 0.08 * c.slip_percent;
                                                         }},
                                                        {"D102",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 170))
                                                                 m.effective_radius_m = 0.143 - 4e-5 * c.slip_percent;
                                                         }},
                                                        {"D120",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B3", 64.4)) m.sinkage_cm -= 0.6;
                                                         }},
                                                        {"D121",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 64.4) && c.slip_percent < 30)
                                                                 m.net_traction_N += 4;
                                                         }},
                                                        {"D122",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 64.4) && c.slip_percent == 50)
                                                                 m.net_traction_N += 5;
                                                         }},
                                                        {"D123",
                                                         [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 64.4)) m.sinkage_cm -= 1;
                                                         }},
                                                        {"D123-b", [&](auto& c, auto& m) {
                                                             if (is(c, "B6", 64.4)) m.sinkage_cm += 1;
                                                         }}};
    for (const auto& [id, distortion] : distortions) {
        const auto outcomes = judge(synthetic_campaign(distortion), id);
        EXPECT_EQ(outcomes.at(id).verdict, Verdict::not_reproduced) << id << ": " << outcomes.at(id).detail;
    }
}

TEST(Chapter3Curves, AMissingCurveOrSlipLeavesNothingToJudge) {
    Campaign campaign = synthetic_campaign();
    std::erase_if(campaign.runs, [](const MeasuredRun& run) {
        return run.condition.wheel == "B6" && run.condition.load_N == 50 && run.condition.slip_percent == 20;
    });
    const auto outcomes = judge(campaign);
    EXPECT_EQ(outcomes.at("D092").verdict, Verdict::not_computable);
    EXPECT_NE(outcomes.at("D092").detail.find("only 7 of the slips 0–70 % of B6 Earth 50 N were run"),
              std::string::npos)
        << outcomes.at("D092").detail;
    EXPECT_EQ(outcomes.at("D085").verdict, Verdict::match);  // a trend stands on seven slips too
}

TEST(Chapter3Curves, WithoutRealisationsNothingIsCertain) {
    Campaign campaign = synthetic_campaign();
    std::map<Condition, int> seen;
    std::erase_if(campaign.runs, [&](const MeasuredRun& run) { return ++seen[run.condition] > 1; });
    const auto outcomes = judge(campaign);
    for (const char* id : {"D083", "D088", "D092", "D096", "D101-b", "D122", "D120"})
        EXPECT_EQ(outcomes.at(id).verdict, Verdict::unresolved) << id << ": " << outcomes.at(id).detail;
}

TEST(BorrowedScatter, OwnSlipsFirstThenThePlanetInShareOfTheLoad) {
    Campaign campaign;
    const auto add = [&](const char* wheel, double load, double slip, double effort, double sinkage) {
        MeasuredRun run;
        run.condition = {wheel, "earth", load, slip};
        run.metrics.gross_tractive_effort_N = effort;
        run.metrics.sinkage_cm = sinkage;
        campaign.runs.push_back(run);
    };
    for (int k = 0; k < 8; ++k) add("B3", 100, 60, 50 + (k % 2 == 0 ? 2 : -2), -3 + (k % 2 == 0 ? 0.1 : -0.1));
    add("B6", 50, 60, 20, -1);
    const auto& effort = *find_metric("gross_tractive_effort_N");
    const auto own = borrow_scatter(campaign, {"B3", "earth", 100}, effort);
    EXPECT_FALSE(own.from_other_curves);
    EXPECT_NEAR(own.pooled.deviation, 2 * std::sqrt(8.0 / 7), 1e-12);
    const auto other = borrow_scatter(campaign, {"B6", "earth", 50}, effort);
    EXPECT_TRUE(other.from_other_curves);
    EXPECT_NEAR(other.pooled.deviation, std::sqrt(8.0 / 7), 1e-12);  // half the load, half the scatter
    EXPECT_DOUBLE_EQ(other.pooled.degrees_of_freedom, 7);
    const auto sinkage = borrow_scatter(campaign, {"B6", "earth", 50}, *find_metric("sinkage_cm"));
    EXPECT_NEAR(sinkage.pooled.deviation, 0.1 * std::sqrt(8.0 / 7), 1e-12);  // a length does not go with the load
    EXPECT_EQ(borrow_scatter(campaign, {"B6", "mars", 50}, effort).pooled.degrees_of_freedom, 0);
}

TEST(Ordering, MeanDifferenceAndItsInterval) {
    // Eight single runs a side, s = 1: the mean difference has the error √(8 · 2)/8 = 0.5, times t(0.975, 10) = 2.228.
    const auto upper = curve([](double) { return 11.2; }, 1), lower = curve([](double) { return 10.0; }, 1);
    const auto result = judge_exceeds(upper, lower, 8);
    EXPECT_NEAR(*result.statistic, 1.2, 1e-12);
    EXPECT_NEAR(result.uncertainty, 2.2281 * 0.5, 1e-3);
    EXPECT_EQ(result.finding, Finding::within);
    EXPECT_EQ(judge_exceeds(lower, upper, 8).finding, Finding::outside);
    EXPECT_EQ(judge_exceeds(curve([](double) { return 11.0; }, 1), lower, 8).finding, Finding::too_uncertain);
    // One slip reversed far beyond its own interval, t(1 − 0.025/8, 10) · √2 = 4.8: no ordering for all slips.
    const auto dip = curve([](double i) { return i == 30 ? 4.0 : 20.0; }, 1);
    EXPECT_EQ(judge_exceeds(dip, lower, 8).finding, Finding::outside);
    EXPECT_EQ(judge_exceeds(curve([](double i) { return i == 30 ? 6.0 : 20.0; }, 1), lower, 8).finding,
              Finding::within);
}

TEST(Ordering, SameNeedsANarrowIntervalToo) {
    const auto a = curve([](double) { return 10.0; }, 0.1), b = curve([](double) { return 10.5; }, 0.1);
    EXPECT_EQ(judge_same(a, b, 0.6).finding, Finding::within);
    EXPECT_EQ(judge_same(a, b, 0.4).finding, Finding::outside);
    const auto noisy = curve([](double) { return 10.5; }, 1);
    EXPECT_EQ(judge_same(a, noisy, 0.6).finding, Finding::too_uncertain);  // could hide 2
    EXPECT_EQ(judge_same(a, noisy, 0.4).finding, Finding::too_uncertain);  // could be 0
}

TEST(Ordering, SlopesCompareByMagnitude) {
    const auto steep = curve([](double i) { return 10 - 0.10 * i; }, 0.1),
               flat = curve([](double i) { return 3 - 0.02 * i; }, 0.1);
    const auto result = judge_steeper(steep, flat);
    EXPECT_EQ(result.finding, Finding::within);
    EXPECT_NEAR(*result.statistic, 0.08, 1e-12);
    // Error of a slope: s/√Σ(i − ī)² = 0.1/√4200; two of them, times t(0.975, 10).
    EXPECT_NEAR(result.uncertainty, 2.2281 * std::sqrt(2.0) * 0.1 / std::sqrt(4200.0), 1e-6);
    EXPECT_EQ(judge_steeper(flat, steep).finding, Finding::outside);
    EXPECT_EQ(judge_steeper(curve([](double i) { return 0.021 * i; }, 0.1), flat).finding, Finding::too_uncertain);
}

TEST(Ordering, CrossingsCommonScatteredAndUnknown) {
    const auto a = curve([](double i) { return 0.1 * (i - 12); }, 0.05),
               b = curve([](double i) { return 0.3 * (i - 12); }, 0.05),
               c = curve([](double i) { return 0.5 * (i - 13); }, 0.05),
               high = curve([](double i) { return 30 + 0.5 * i; }, 0.05);
    const auto common = judge_cross({a, b, c}, 10);
    EXPECT_EQ(common.finding, Finding::within);
    EXPECT_NEAR(*common.statistic, 14.5 - 12, 0.05);  // b and c meet at (0.5 · 13 − 0.3 · 12)/0.2 = 14.5, a and b at 12
    EXPECT_EQ(judge_cross({a, b, high}, 10).finding, Finding::outside);
    EXPECT_FALSE(judge_cross({a, b, high}, 10).statistic);
    // What the others do among themselves is no matter: a and b cross, neither crosses `high`.
    EXPECT_EQ(judge_not_cross({high}, {a, b}, 10).finding, Finding::within);
    EXPECT_EQ(judge_not_cross({a}, {b, c}, 10).finding, Finding::outside);
    // Nor that the others do not cross: `a` crosses each of two that stay apart.
    const auto level = curve([](double) { return 0.0; }, 0.05), above = curve([](double) { return 0.3; }, 0.05);
    EXPECT_EQ(judge_not_cross({a}, {level, above}, 10).finding, Finding::outside);
    EXPECT_EQ(judge_cross({a, b, c}, 1).finding, Finding::outside);
    const auto unknown = curve([](double i) { return 0.1 * (i - 12); }, 0, 0);
    EXPECT_EQ(judge_cross({unknown, b}, 10).finding, Finding::too_uncertain);
    const auto noisy = curve([](double i) { return 0.28 * (i - 12); }, 2);
    EXPECT_EQ(judge_cross({noisy, b, c}, 10).finding, Finding::too_uncertain);
}

TEST(Curvature, RunErrorsDecideWhereTheyAreKnown) {
    // The same curve, once with a scatter that hides its curvature and once with one that shows it.
    const auto hidden = curve([](double i) { return 10 + i + 0.005 * i * i; }, 8),
               shown = curve([](double i) { return 10 + i + 0.005 * i * i; }, 0.2);
    EXPECT_EQ(judge_linear(hidden, 0.05).finding, Finding::too_uncertain);
    EXPECT_EQ(judge_linear(shown, 0.05).finding, Finding::outside);
    // c L²/4 over the rise of L + c L²: 0.005 · 70/4 / (1 + 0.35).
    EXPECT_NEAR(*judge_linear(shown, 0.05).statistic, 0.005 * 70 / 4 / 1.35, 1e-9);
}

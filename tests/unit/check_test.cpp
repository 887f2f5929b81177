#include "check/check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>

#include "check/trend.hpp"
#include "core/error.hpp"
#include "support/synthetic_runs.hpp"

using namespace ifedem;
using namespace ifedem::test;
namespace fs = std::filesystem;

namespace {

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

constexpr const char* claims_header =
    "id,metric,window,wheel,gravity,load_N,slip_percent,compare,reference,tolerance,tolerance_origin,expected,evidence,"
    "note\n";

/// A small project: a ledger of five rows and claims beside it.
class Project : public ::testing::Test {
protected:
    void SetUp() override {
        root = fresh_directory(std::string("check-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        write_text((root / "reference_data/dissertation.csv").string(),
                   "id,chapter,quantity,symbol,value,units,condition,source,line,kind,note\n"
                   "D107,3,H on Earth,He,102,N,B3 i=60 % W=170 N,Fig 3-17a / 3.4,686,result,\n"
                   "D109,3,H ratio,Hm/He,0.373,-,i=60 %,3.4,688,ratio,\n"
                   "D110,3,Gravity ratio,gm/ge,0.378,-,,3.4,688,ratio,\n"
                   "D095,3,B3 |sinkage| increases with slip,|z|(i),monotonic,-,,Fig 3-14,643,qualitative,\n"
                   "D041,3,Time step,dt,1e-05,s,Earth,3.2.2,504,input,\n");
    }
    void TearDown() override { fs::remove_all(root); }

    CheckResult check(const std::string& rows, const std::vector<std::string>& runs) {
        const std::string path = (root / "claims.csv").string();
        write_text(path, claims_header + rows);
        return check_claims(path, runs);
    }
    Outcome only(const std::string& rows, const std::vector<std::string>& runs) {
        return check(rows, runs).outcomes.at(0);
    }

    std::vector<std::string> three_runs(double h1, double h2, double h3) {
        std::vector<std::string> runs;
        int k = 0;
        for (const double h : {h1, h2, h3}) {
            ++k;
            runs.push_back(write_synthetic_run(root, {.name = fmt::format("r{}", k), .seed = k, .effort_N = h}));
        }
        return runs;
    }

    fs::path root;
};

const std::string h_earth = "D107,gross_tractive_effort_N,text,B3,earth,170,60,equal,,U,scatter,match,,\n";

}  // namespace

TEST(Window, FollowsTheTextAndKeepsWholePitches) {
    EXPECT_DOUBLE_EQ(averaging_window(60).from_m, 0.4);
    EXPECT_DOUBLE_EQ(averaging_window(70).from_m, 0.6);
    EXPECT_DOUBLE_EQ(averaging_window(70).to_m, 0.8);
    Case c;
    for (const auto& [slip, millimetres] : {std::pair{0.0, 79.0}, {60.0, 31.0}, {70.0, 24.0}}) {
        c.travel.slip_percent = slip;
        EXPECT_NEAR(1e3 * lug_pair_pitch_m(c), millimetres, 0.5);
    }
    const Window w = trim({0.4, 0.8}, 0.0785);
    EXPECT_DOUBLE_EQ(w.to_m, 0.8);
    EXPECT_NEAR(w.from_m, 0.8 - 5 * 0.0785, 1e-12);
    EXPECT_NEAR(trim({0.4, 0.8}, 0.1).from_m, 0.4, 1e-12);  // four pitches fit exactly
    EXPECT_THROW(static_cast<void>(trim({0.4, 0.45}, 0.0785)), Error);
}

TEST(Window, MeanIsTheIntegralWithInterpolatedEnds) {
    const std::vector<double> t{0, 1, 2, 3}, y{0, 2, 4, 6};
    EXPECT_DOUBLE_EQ(mean_between(t, y, 0.5, 2.5), 3);      // a line: the value in the middle
    EXPECT_DOUBLE_EQ(mean_between(t, y, 0.25, 0.5), 0.75);  // within one step
    const std::vector<double> kink{0, 0, 1, 1};
    EXPECT_DOUBLE_EQ(mean_between(t, kink, 1, 2), 0.5);
    EXPECT_DOUBLE_EQ(mean_between(t, kink, 0, 3), 0.5);
}

TEST_F(Project, MeasuresWhatASyntheticRunWasMadeOf) {
    const ifedem::Run run = read_run(
        write_synthetic_run(root, {.name = "a", .effort_N = 90, .net_traction_N = 40, .effective_radius_m = 0.145}));
    const RunMetrics m = measure(run, averaging_window(60));
    EXPECT_NEAR(m.gross_tractive_effort_N, 90, 2e-3);  // a sine over whole pitches, sampled 157 times a pitch
    EXPECT_NEAR(m.net_traction_N, 40, 2e-3);
    EXPECT_DOUBLE_EQ(m.motion_resistance_N, m.net_traction_N - m.gross_tractive_effort_N);
    EXPECT_NEAR(m.sinkage_cm, -5.75, 1e-9);
    EXPECT_NEAR(m.deflection_mm, 5, 1e-9);
    // Commanded for 0.15 m: 1 − V/(r_e ω) with V/ω = 0.15 · 0.4.
    EXPECT_NEAR(m.measured_slip_percent, 100 * (1 - 0.06 / 0.145), 1e-6);
    EXPECT_NEAR(m.direct_thrust_N, 81, 2e-3);
    EXPECT_NEAR(m.horizontal_imbalance_N, 0, 1e-6);
    EXPECT_NEAR(m.vertical_imbalance_N, 0, 1e-9);
    EXPECT_NEAR(m.drawbar_deviation_N, 40 * 0.3 / std::sqrt(2.0), 1e-2);
    const double length = m.window.to_m - m.window.from_m;
    EXPECT_NEAR(m.energy_J.at("work_torque_J"), 10 * length, 1e-6);
    EXPECT_NEAR(m.energy_J.at("stored_J"), 0.9 * length, 1e-6);
}

TEST_F(Project, UntrimmedWindowsWouldShowTheRipple) {
    // The same run over a window of half a pitch more: the sine leaves a mark. It is the trimming that removes it.
    const ifedem::Run run = read_run(write_synthetic_run(root, {.name = "a", .effort_N = 90}));
    const auto& t = run.travel.at("time_s");
    const double pitch = lug_pair_pitch_m(run.c);
    const double raw = mean_between(t, run.travel.at("gross_tractive_effort_N"), (0.8 - 1.5 * pitch) / 0.1, 8.0);
    EXPECT_GT(std::abs(raw - 90), 1);
}

TEST_F(Project, FoldersAddClaimsButNoneTwice) {
    const std::string ratio = "D110,gravity_ratio,,,,,,equal,,0.001,digits,match,,\n";
    write_text((root / "more/claims.csv").string(), claims_header + ratio);
    EXPECT_EQ(check(h_earth, {}).outcomes.at(1).claim.id, "D110");
    const std::string message = message_of([&] { check(h_earth + ratio, {}); });
    EXPECT_NE(message.find("D110 is claimed here and in a folder beside it"), std::string::npos) << message;
}

TEST_F(Project, RunsThatFallShortAreNotJudgedButDoNotStopTheOthers) {
    auto runs = three_runs(101, 102, 103);
    // Told to go 0.8 m, stopped at 0.5 m.
    runs.push_back(write_synthetic_run(root, {.name = "stopped", .slip_percent = 20, .distance_m = 0.5}));
    // Told to go 0.2 m: measured over the same share of its way, used by no claim.
    Case brief = synthetic_case({.name = "brief", .slip_percent = 30});
    brief.travel.distance_m = 0.2;
    runs.push_back(write_synthetic_run(root, {.name = "brief", .slip_percent = 30, .effort_N = 70, .distance_m = 0.2}));
    write_text(runs.back() + "/case.toml", to_toml(brief));
    runs.push_back((root / "nowhere").string());
    const std::string rows = h_earth +
                             "D107-b,gross_tractive_effort_N,text,B3,earth,170,20,equal,,U,scatter,match,,\n"
                             "D107-c,gross_tractive_effort_N,text,B3,earth,170,30,equal,,U,scatter,match,,\n";
    const auto result = check(rows, runs);
    EXPECT_EQ(result.outcomes[0].verdict, Verdict::match);
    EXPECT_EQ(result.outcomes[1].verdict, Verdict::not_computable);
    EXPECT_NE(result.outcomes[1].detail.find("travelled 0.500 m of the 0.80 m"), std::string::npos);
    EXPECT_EQ(result.outcomes[2].verdict, Verdict::not_computable);
    EXPECT_NE(result.outcomes[2].detail.find("brief travelled 0.2 m of the 0.8 m"), std::string::npos);
    for (const auto& run : result.campaign.runs)
        if (run.run.name == "brief") {
            EXPECT_NEAR(run.metrics.window.to_m, 0.2, 1e-9);
            EXPECT_NEAR(run.metrics.gross_tractive_effort_N, 70, 2);  // the start of this run is still in its window
        }
    ASSERT_EQ(result.campaign.unusable.size(), 1U);
    EXPECT_NE(result.campaign.unusable[0].find("nowhere"), std::string::npos);
}

TEST_F(Project, MatchNeedsASmallErrorAndASmallUncertainty) {
    // Scatter 1 N: U = √(18.51 · 4/3 + 1) = 5.07 N, below 10.2 N.
    const Outcome good = only(h_earth, three_runs(103, 104, 105));
    EXPECT_EQ(good.verdict, Verdict::match);
    EXPECT_EQ(good.n, 3U);
    EXPECT_NEAR(good.uncertainty, std::sqrt(0.9025 * 2 / 0.0975 * 4 / 3 + 1), 0.01);
    EXPECT_NEAR(*good.error_over_tolerance, 2 / good.uncertainty, 1e-3);
}

TEST_F(Project, WithinAWideUncertaintyIsUnresolved) {
    // Scatter 4 N: U = 19.9 N > 10.2 N.
    EXPECT_EQ(only(h_earth, three_runs(94, 98, 102)).verdict, Verdict::unresolved);
}

TEST_F(Project, OutsideIsNotReproducedAndExplainedOnlyByAFileThatExists) {
    const auto runs = three_runs(79, 80, 81);
    EXPECT_EQ(only(h_earth, runs).verdict, Verdict::not_reproduced);
    const std::string with_evidence =
        "D107,gross_tractive_effort_N,text,B3,earth,170,60,equal,,U,scatter,match,evidence/why.svg,\n";
    EXPECT_EQ(only(with_evidence, runs).verdict, Verdict::not_reproduced);
    write_text((root / "evidence/why.svg").string(), "<svg/>");
    EXPECT_EQ(only(with_evidence, runs).verdict, Verdict::differs_explained);
}

TEST_F(Project, OneRunCannotTell) {
    const auto run = write_synthetic_run(root, {.name = "one", .effort_N = 102});
    EXPECT_EQ(only(h_earth, {run}).verdict, Verdict::unresolved);
}

TEST_F(Project, RatiosPropagate) {
    auto runs = three_runs(101, 102, 103);
    for (int k = 1; k <= 3; ++k)
        runs.push_back(write_synthetic_run(root, {.name = fmt::format("m{}", k),
                                                  .gravity_m_s2 = 3.71,
                                                  .load_N = 64.4,
                                                  .seed = k,
                                                  .effort_N = 37.8 + 0.1 * k}));
    const std::string row =
        "D109,ratio:gross_tractive_effort_N,text,B3,mars/earth,64.4/170,60,equal,,U,both,match,,\n"
        "D110,gravity_ratio,,B3,,,,equal,,0.0005,digit,match,,\n"
        "D109-b,ratio:gross_tractive_effort_N,text,B3,mars/earth,64.4/170,60,below,=0.5,U,both,match,,\n"
        "D109-c,ratio:gross_tractive_effort_N,text,B3,mars/earth,64.4/170,60,above,=0.5,U,both,match,,\n"
        "D109-d,ratio:gross_tractive_effort_N,text,B3,mars/earth,64.4/170,60,below,D110,U,both,match,,\n";
    const auto result = check(row, runs);
    const Outcome& o = result.outcomes[0];
    EXPECT_NEAR(*o.computed, 38.0 / 102, 1e-4);
    const double t2 = 0.9025 * 2 / 0.0975;
    const double ue = std::sqrt(t2 * 4 / 3 + 1), um = std::sqrt(t2 * 0.01 * 4 / 3 + 0.25);
    EXPECT_NEAR(o.uncertainty, 38.0 / 102 * std::hypot(ue / 102, um / 38), 1e-4);
    EXPECT_EQ(o.verdict, Verdict::match);
    EXPECT_EQ(result.outcomes[1].verdict, Verdict::match);
    EXPECT_EQ(result.outcomes[2].verdict, Verdict::match);
    EXPECT_EQ(result.outcomes[3].verdict, Verdict::not_reproduced);
    EXPECT_EQ(result.outcomes[4].verdict, Verdict::unresolved);  // 0.373 ± 0.019 cannot be told from 0.378
}

TEST_F(Project, MissingRunsAndMissingRowsFailTheCheck) {
    const std::string claims = (root / "claims.csv").string();
    const std::string out = (root / "out/checks.csv").string();
    const std::string others = "D109,,,,,,,none,,,,not-computable,,why\nD110,,,,,,,none,,,,not-computable,,why\n";
    const std::string last = "D095,,,,,,,none,,,,not-computable,,why\n";
    const auto runs = three_runs(101, 102, 103);
    write_text(claims, claims_header + h_earth + others + last);
    EXPECT_EQ(run_check(claims, runs, out), 0);
    EXPECT_EQ(run_check(claims, {}, out), 1);  // D107 has no run
    write_text(claims, claims_header + h_earth + others);
    EXPECT_EQ(run_check(claims, runs, out), 1);  // D095 has no claim; D041 is an input and needs none
    const CsvTable table = read_csv(out);
    EXPECT_EQ(table.rows.size(), 4U);
    EXPECT_EQ(table.rows.back().cells[table.require("id")], "D095");
    EXPECT_EQ(table.rows.back().cells[table.require("verdict")], "not-computable");
    EXPECT_EQ(fmt::format("{}", fmt::join(table.header, ",")),
              "id,chapter,quantity,units,condition,reference,computed,scatter,n,tolerance,error_over_tolerance,verdict,"
              "expected,"
              "evidence,source,uncertainty");
}

TEST_F(Project, MeasurementsStandBesideRuns) {
    write_text((root / "reference_data/external.csv").string(),
               "id,chapter,quantity,symbol,value,units,condition,source,line,kind,note\n"
               "X001,2,Restitution,e,0.5266,-,,formula,,exact,\n"
               "X002,2,Angle of repose,phi,30,deg,,a paper,,published,\n");
    write_text((root / "m/measurements.csv").string(),
               "name,value,units,scatter,n,note\n"
               "restitution,0.5268,-,,1,head-on\nrepose,31,deg,0.5,5,mean\nheight,3,m,,1,\n");
    const std::string rows =
        "X001,measured:restitution,,,,,,equal,,0.001,integration error,match,,\n"
        "X001-b,measured:restitution,,,,,,equal,,0.0001,integration error,match,,\n"
        "X001-c,measured:restitution,,,,,,equal,,U,scatter,match,,\n"
        "X002,measured:repose,,,,,,equal,,U,scatter,match,,\n"
        "X002-b,measured:repose,,,,,,equal,=28,U,scatter,match,,\n"
        "X002-c,measured:repose,,,,,,above,=28,U,scatter,match,,\n"
        "X002-d,measured:height,,,,,,equal,,U,scatter,match,,\n"
        "X002-e,measured:nothing,,,,,,equal,,U,scatter,match,,\n"
        "X001-d,measured:restitution,,,,,,above,=0.5,0,one exact run,match,,\n";
    const auto o = check(rows, {(root / "m").string()}).outcomes;
    ASSERT_EQ(o.size(), 9U);  // chapter 2's rows from elsewhere call for none of the dissertation's
    EXPECT_EQ(o[0].verdict, Verdict::match);
    EXPECT_EQ(o[1].verdict, Verdict::not_reproduced);
    EXPECT_EQ(o[2].verdict, Verdict::unresolved);  // one value knows no scatter
    // t(0.975, 4) = 2.776 and half a unit of the last digit: U = √((2.776 · 0.5)² · 6/5 + 0.5²).
    EXPECT_NEAR(o[3].uncertainty, std::sqrt(2.7764 * 2.7764 * 0.25 * 1.2 + 0.25), 1e-3);
    EXPECT_EQ(o[3].verdict, Verdict::match);
    EXPECT_NEAR(o[4].uncertainty, std::sqrt(2.7764 * 2.7764 * 0.25 * 1.2), 1e-3);  // the claim's own 28 is not read off
    EXPECT_EQ(o[4].verdict, Verdict::not_reproduced);
    EXPECT_EQ(o[5].verdict, Verdict::match);
    EXPECT_NE(o[6].detail.find("measured in m but the ledger row is in deg"), std::string::npos);
    EXPECT_EQ(o[7].verdict, Verdict::not_computable);
    EXPECT_EQ(o[8].verdict, Verdict::match);

    write_text((root / "other/measurements.csv").string(), "name,value,units,scatter,n,note\nheight,4,m,,1,\n");
    EXPECT_NE(message_of([&] {
                  static_cast<void>(check(rows, {(root / "m").string(), (root / "other").string()}));
              }).find("measurement height stands twice"),
              std::string::npos);
    write_text((root / "bad/measurements.csv").string(), "name,value,units,scatter,n,note\nheight,tall,m,,1,\n");
    const auto bad = check(rows, {(root / "bad").string()});
    ASSERT_EQ(bad.campaign.unusable.size(), 1U);
    EXPECT_NE(bad.campaign.unusable[0].find("measurements.csv:2: value is not a number"), std::string::npos);
}

TEST_F(Project, MeasurementsOverSlipsAreACurve) {
    const auto measure = [&](const std::string& values) {
        write_text((root / "m/measurements.csv").string(), "name,value,units,scatter,n,note\n" + values);
    };
    const auto verdict = [&](const char* compare, const char* slips) {
        return check(fmt::format("D095,measured:angle,,,,,{},{},,U,ranks,match,,\n", slips, compare),
                     {(root / "m").string()})
            .outcomes.at(0)
            .verdict;
    };
    measure(
        "angle_s-5,80,deg,1,4,\nangle_s1,86,deg,1,4,\nangle_s7.5,90,deg,1,4,\nangle_s22,95,deg,1,4,\n"
        "angle_s55,99,deg,1,4,\nangle_share_s55,0,-,1,4,\n");
    EXPECT_EQ(verdict("increasing", "-5..55"), Verdict::match);
    EXPECT_EQ(verdict("decreasing", "-5..55"), Verdict::not_reproduced);
    EXPECT_EQ(verdict("increasing", "7.5..55"), Verdict::not_computable);  // three slips
    // One step back of 9 with U = 3.182 √1.25 = 3.56: the fit is left.
    measure(
        "angle_s-5,80,deg,1,4,\nangle_s1,95,deg,1,4,\nangle_s7.5,86,deg,1,4,\nangle_s22,96,deg,1,4,\n"
        "angle_s55,99,deg,1,4,\n");
    EXPECT_EQ(verdict("increasing", "-5..55"), Verdict::not_reproduced);
    // One of 4 is within U, and then ranks 0.8 at p = 0.04 tell.
    measure(
        "angle_s-5,80,deg,1,4,\nangle_s1,95,deg,1,4,\nangle_s7.5,91,deg,1,4,\nangle_s22,96,deg,1,4,\n"
        "angle_s55,99,deg,1,4,\n");
    EXPECT_EQ(verdict("increasing", "-5..55"), Verdict::match);
}

TEST_F(Project, AThresholdOfTheClaimIsToldByU) {
    write_text((root / "m/measurements.csv").string(),
               "name,value,units,scatter,n,note\nexact,0.4,-,,1,\nlarge,2,-,0.1,4,\nnoisy,2,-,1,4,\n");
    const auto verdict = [&](const char* name) {
        return check(fmt::format("D095,measured:{},,,,,,above,=0,0.5,more than a disc,match,,\n", name),
                     {(root / "m").string()})
            .outcomes.at(0)
            .verdict;
    };
    EXPECT_EQ(verdict("exact"), Verdict::not_reproduced);  // above 0, but not by 0.5
    EXPECT_EQ(verdict("large"), Verdict::match);
    EXPECT_EQ(verdict("noisy"), Verdict::unresolved);
}

TEST_F(Project, IdsOfBothLedgersAreDistinct) {
    write_text((root / "reference_data/external.csv").string(),
               "id,chapter,quantity,symbol,value,units,condition,source,line,kind,note\n"
               "D107,2,Restitution,e,0.5266,-,,formula,,exact,\n");
    EXPECT_NE(message_of([&] { static_cast<void>(check("", {})); }).find("the id D107 stands twice"),
              std::string::npos);
}

TEST(Ledger, ValuesFromElsewhereAreExactOrPublishedAndNameTheirSource) {
    std::size_t found = 0;
    for (const auto& [id, row] : read_ledger(IFEDEM_SOURCE_DIR)) {
        if (!id.starts_with('X')) continue;
        ++found;
        EXPECT_TRUE(row.kind == "exact" || row.kind == "published") << id;
        EXPECT_FALSE(row.source.empty()) << id;
        EXPECT_TRUE(row.kind != "exact" || row.number()) << id;
        EXPECT_FALSE(row.needs_verdict()) << id;
    }
    EXPECT_GE(found, 1U);
    const double zeta = 0.2;
    EXPECT_NEAR(*read_ledger(IFEDEM_SOURCE_DIR).at("X001").number(), std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta)),
                1e-9);
}

TEST_F(Project, WorseThanExpectedFailsAndAsExpectedDoesNot) {
    const std::string claims = (root / "claims.csv").string();
    const std::string rest =
        "D109,,,,,,,none,,,,not-computable,,why\nD110,,,,,,,none,,,,not-computable,,why\nD095,,,,,,,none,,,,not-"
        "computable,,why\n";
    const auto runs = three_runs(79, 80, 81);
    write_text(claims, claims_header + h_earth + rest);
    EXPECT_EQ(run_check(claims, runs, (root / "c.csv").string()), 1);
    write_text(claims,
               claims_header +
                   std::string("D107,gross_tractive_effort_N,text,B3,earth,170,60,equal,,U,s,not-reproduced,,\n") +
                   rest);
    EXPECT_EQ(run_check(claims, runs, (root / "c.csv").string()), 0);
}

TEST_F(Project, BadClaimsAreAllNamedWithTheirLines) {
    const std::string rows =
        "D999,gross_tractive_effort_N,text,B3,earth,170,60,equal,,U,s,match,,\n"
        "D107,thrust,text,B3,earth,170,60,equal,,U,s,match,,\n"
        "D107-b,gross_tractive_effort_N,text,B3,earth,170,60,alike,,U,s,fine,,\n"
        "D107-c,gross_tractive_effort_N,80-40,B3,earth,heavy,60,equal,,many,,match,,\n"
        "D107-d,sinkage_cm,text,B3,earth,170,60,equal,,U,s,match,,\n"
        "D107-d,,,,,,,none,,,,not-computable,,\n"
        "D109,ratio:gross_tractive_effort_N,text,B3,earth,170,60,equal,,U,s,match,,\n"
        "D107-e,gross_tractive_effort_N,text,B3,,170,60,equal,,U,s,match,,\n"
        "D107-f,gross_tractive_effort_N,text,B3+B6,earth,170,60,equal,,U,s,match,,\n"
        "D095,sinkage_cm,text,B3,earth,170/50,0..70,increasing,,U,s,match,,\n"
        "D095-b,sinkage_cm,text,B3/B6,earth,170+50/50,0..70,exceeds,,U,s,match,,\n"
        "D095-c,sinkage_cm,text,B3/B6,earth,170,0..70,same,,U,s,match,,\n"
        "D095-d,sinkage_cm,text,B3,earth,170,0..70,cross,,10,s,match,,\n"
        "D095-e,gravity_ratio,text,B3,earth,170,0..70,increasing,,U,s,match,,\n"
        "D095-f,sinkage_cm,text,B3,earth,170+50,0..70,not-cross,,10,s,match,,\n"
        "D095-g,measured:angle,,,,,0..70,same,,1,s,match,,\n"
        "D095-h,measured:angle,,,,,,increasing,,U,s,match,,\n";
    const auto text = message_of([&] { static_cast<void>(check(rows, {})); });
    for (const char* part : {"claims.csv:2: the id 'D999'",
                             "claims.csv:3: metric 'thrust'",
                             "claims.csv:4: compare 'alike'",
                             "claims.csv:4: expected verdict 'fine'",
                             "claims.csv:5: window '80-40'",
                             "claims.csv:5: load_N 'heavy'",
                             "claims.csv:5: tolerance 'many'",
                             "claims.csv:5: the tolerance 'many' has no origin",
                             "claims.csv:6: sinkage_cm is in cm but the ledger row in N",
                             "claims.csv:7: the id D107-d stands twice",
                             "claims.csv:7: a row that is not computed needs its reason",
                             "claims.csv:8: a ratio:gross_tractive_effort_N needs",
                             "claims.csv:9: the runs are not selected",
                             "claims.csv:10: equal needs one wheel",
                             "claims.csv:11: increasing looks at one side",
                             "claims.csv:12: exceeds needs two sides of equally many curves",
                             "claims.csv:13: same needs a number as tolerance",
                             "claims.csv:14: one curve cannot cross itself",
                             "claims.csv:15: gravity_ratio has no curve over slip",
                             "claims.csv:16: not-cross needs two sides",
                             "claims.csv:17: measured:angle over slips cannot be judged by same",
                             "claims.csv:18: the slips are not selected"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
}

TEST_F(Project, RealisationsMustDifferInSeedOrPhaseOnly) {
    const auto a = write_synthetic_run(root, {.name = "a", .seed = 1});
    const auto same = write_synthetic_run(root, {.name = "b", .seed = 1});
    EXPECT_NE(message_of([&] {
                  static_cast<void>(read_campaign({a, same}));
              }).find("same realisation"),
              std::string::npos);
    const auto phase = write_synthetic_run(root, {.name = "c", .seed = 1, .lug_phase_deg = 15});
    EXPECT_NO_THROW(static_cast<void>(read_campaign({a, phase})));
    Case other = synthetic_case({.name = "d", .seed = 2});
    other.contact.rolling_factor = 0.5;
    const auto d = write_synthetic_run(root, {.name = "d", .seed = 2});
    write_text(d + "/case.toml", to_toml(other));
    const auto text = message_of([&] { static_cast<void>(read_campaign({a, d})); });
    EXPECT_NE(text.find("rolling_factor"), std::string::npos) << text;
}

TEST_F(Project, TrendsNeedRunsAtSeveralSlips) {
    const std::string row = "D095,abs:sinkage_cm,text,B3,earth,170,0..70,increasing,,U,each point,match,,\n";
    std::vector<std::string> runs;
    for (int k = 0; k < 3; ++k)
        runs.push_back(write_synthetic_run(
            root, {.name = fmt::format("s{}", k), .slip_percent = 10.0 * k, .sinkage_m = -0.01 * (k + 1)}));
    EXPECT_EQ(only(row, runs).verdict, Verdict::not_computable);
    for (int k = 3; k < 8; ++k)
        runs.push_back(write_synthetic_run(
            root, {.name = fmt::format("s{}", k), .slip_percent = 10.0 * k, .sinkage_m = -0.01 * (k + 1)}));
    // A second realisation at one slip tells the scatter.
    runs.push_back(write_synthetic_run(root, {.name = "t6", .slip_percent = 60, .seed = 2, .sinkage_m = -0.0702}));
    const Outcome o = only(row, runs);
    EXPECT_EQ(o.verdict, Verdict::match) << o.detail;
    EXPECT_DOUBLE_EQ(*o.computed, 1);
    EXPECT_EQ(o.n, 9U);
    const std::string wrong = "D095,abs:sinkage_cm,text,B3,earth,170,0..70,decreasing,,U,each point,match,,\n";
    EXPECT_EQ(only(wrong, runs).verdict, Verdict::not_reproduced);
}

TEST(Trend, StepsBackWithinUAreForgiven) {
    const ValuesBySlip rising{{0, {1.0, 1.04}}, {10, {2.0}}, {20, {1.9}}, {30, {3.0}}, {40, {4.0}}};
    EXPECT_EQ(judge_monotonic(trend_points(rising, pool(rising)), 1).finding, Finding::within);
    EXPECT_EQ(judge_monotonic(trend_points(rising, pool(rising)), -1).finding, Finding::outside);
    // All within the scatter of ±30: nothing can be told.
    const ValuesBySlip noisy{{0, {-30, 30}}, {10, {2.0}}, {20, {1.0}}, {30, {3.0}}, {40, {0.5}}};
    EXPECT_EQ(judge_monotonic(trend_points(noisy, pool(noisy)), 1).finding, Finding::too_uncertain);
}

TEST(Trend, LinearCurvedAndUndecided) {
    ValuesBySlip line, curve, noise;
    for (int k = 0; k < 8; ++k) {
        const double wobble = k % 2 == 0 ? 1 : -1;
        line[10.0 * k] = {10 + 12.0 * k + 0.5 * wobble};
        curve[10.0 * k] = {10 + 2.0 * k * k + 0.5 * wobble};
        noise[10.0 * k] = {10 + 1.0 * k + 8 * wobble};
    }
    EXPECT_EQ(judge_linear(trend_points(line, {}), 0.1).finding, Finding::within);
    EXPECT_EQ(judge_linear(trend_points(curve, {}), 0.1).finding,
              Finding::outside);  // off its chord by a quarter of the rise
    EXPECT_NEAR(*judge_linear(trend_points(curve, {}), 0.1).statistic, 0.25, 0.01);
    EXPECT_EQ(judge_linear(trend_points(noise, {}), 0.1).finding, Finding::too_uncertain);
}

TEST(Verdicts, EdgesAndOrder) {
    EXPECT_EQ(compare_within_uncertainty(5, 5, 10), Finding::within);
    EXPECT_EQ(compare_within_uncertainty(-5.1, 5, 10), Finding::outside);
    EXPECT_EQ(compare_within_uncertainty(5, 11, 10), Finding::too_uncertain);
    EXPECT_EQ(compare_within_uncertainty(std::nan(""), 5, 10), Finding::outside);
    EXPECT_EQ(compare_within_tolerance(1, 0.5, 1), Finding::within);
    EXPECT_EQ(compare_within_tolerance(1, 2, 1), Finding::too_uncertain);
    EXPECT_EQ(compare_with_bound(-1, 5), Finding::within);
    EXPECT_EQ(compare_with_bound(1, 5), Finding::too_uncertain);
    EXPECT_EQ(compare_with_bound(6, 5), Finding::outside);
    EXPECT_EQ(compare_with_bound(1, std::numeric_limits<double>::infinity()), Finding::outside);
    EXPECT_EQ(compare_with_bound(1, 0), Finding::outside);
    EXPECT_EQ(compare_with_bound(std::nan(""), 1), Finding::outside);
    EXPECT_EQ(compare_side(2, 1), Finding::within);
    EXPECT_EQ(compare_side(0.5, 1), Finding::too_uncertain);
    EXPECT_EQ(compare_side(-2, 1), Finding::outside);
    EXPECT_TRUE(is_worse(Verdict::unresolved, Verdict::match));
    EXPECT_FALSE(is_worse(Verdict::match, Verdict::unresolved));
    EXPECT_TRUE(is_worse(Verdict::not_computable, Verdict::not_reproduced));
    EXPECT_EQ(parse_verdict("differs-explained"), Verdict::differs_explained);
    EXPECT_FALSE(parse_verdict("ok"));
}

TEST(Reading, UncertaintyOfPrintedNumbers) {
    EXPECT_DOUBLE_EQ(reading_uncertainty("102", "N", "earth"), 1);
    EXPECT_DOUBLE_EQ(reading_uncertainty("-27.5", "N", "mars"), 0.5);
    EXPECT_DOUBLE_EQ(reading_uncertainty("-5.75", "cm", "earth"), 0.125);
    EXPECT_DOUBLE_EQ(reading_uncertainty("15.9", "N/mm", ""), 0.05);
    EXPECT_DOUBLE_EQ(reading_uncertainty("0.378", "-", ""), 0.0005);
    EXPECT_DOUBLE_EQ(reading_uncertainty("45400", "s", "earth"), 0.5);
}

TEST(Csv, QuotesLinesAndFaults) {
    const CsvTable t = parse_csv("a,b\n\"x, \"\"y\"\"\nz\",2\r\n3,4\n", "f.csv");
    ASSERT_EQ(t.rows.size(), 2U);
    EXPECT_EQ(t.rows[0].cells[0], "x, \"y\"\nz");
    EXPECT_EQ(t.rows[0].cells[1], "2");
    EXPECT_EQ(t.rows[1].line, 4U);
    EXPECT_EQ(parse_csv(csv_line({"h"}) + csv_line({"x, \"y\"\nz"}), "g").rows[0].cells[0], "x, \"y\"\nz");
    EXPECT_NE(message_of([] { static_cast<void>(parse_csv("a,b\n1\n", "f.csv")); }).find("f.csv:2: 1 cells"),
              std::string::npos);
    EXPECT_NE(message_of([] { static_cast<void>(parse_csv("a\n\"1\n", "f.csv")); }).find("f.csv:2: a quote"),
              std::string::npos);
    EXPECT_FALSE(parse_number("1x"));
    EXPECT_FALSE(parse_number(""));
    EXPECT_DOUBLE_EQ(*parse_number(" -2.5e3 "), -2500);
}

TEST(Chapter3, EveryStatementThatNeedsAVerdictHasAClaim) {
    const std::string root = IFEDEM_SOURCE_DIR;
    const auto result = check_claims(root + "/reproductions/chapter3/claims.csv", {});
    std::set<std::string> ids;
    for (const auto& o : result.outcomes) {
        ids.insert(o.claim.base_id());
        EXPECT_NE(o.detail, "no claim declares this ledger row") << o.claim.id;
        EXPECT_EQ(o.verdict, Verdict::not_computable) << o.claim.id;  // there are no runs
        EXPECT_FALSE(o.detail.empty()) << o.claim.id;
    }
    EXPECT_EQ(ids.size(), 53U);
}

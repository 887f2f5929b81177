#include "check/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/points_guide.hpp"
#include "core/error.hpp"
#include "support/synthetic_runs.hpp"

using namespace ifedem;
using namespace ifedem::test;
namespace fs = std::filesystem;

namespace {

const std::string references = std::string(IFEDEM_SOURCE_DIR) + "/reproductions/speed_accuracy/references3.csv";

/// Variants of three realisations each, with made-up window means and known steps and ns.
class Points : public ::testing::Test {
protected:
    void SetUp() override {
        root =
            fresh_directory(std::string("points-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        for (int k = 1; k <= 3; ++k) {
            add("fine", k, 100.0 + k, 1e-5, 1'000'000, 10);
            add("whole", k, 104.0 + k, 4e-5, 250'000, 9.0 + k);  // median 11
        }
        request.references_path = references;
        request.finest = "fine";
        request.out_dir = (root / "out").string();
    }
    void TearDown() override { fs::remove_all(root); }

    std::string add(const std::string& variant, int k, double effort_N, double step_s, double steps, double ns) {
        const SyntheticRun r{.name = fmt::format("{}-earth-s60-r{}", variant, k), .seed = k, .effort_N = effort_N};
        const auto directory = write_synthetic_run(root, r);
        Case c = synthetic_case(r);
        c.time_step_s = step_s;
        c.bed.disc_count = 19468;
        write_text(directory + "/case.toml", to_toml(c));
        write_text(directory + "/run.csv",
                   fmt::format("name,value,unit\ntotal_steps,{:.0f},\nparticles,19468,\nns_per_particle_step,{},ns\n",
                               steps, ns));
        request.run_dirs.push_back(directory);
        return directory;
    }
    void stop(const std::string& directory) {
        fs::remove(directory + "/run.csv");
        write_text(directory + "/stopped.txt", "a disc goes its radius within a step.\n");
    }
    [[nodiscard]] PointSet measured() const { return measure_points(request, read_ledger(find_root(references))); }
    static Point find(const PointSet& set, const std::string& variant) {
        for (const Point& p : set.points)
            if (p.variant == variant && p.quantity == "gross_tractive_effort_N") return p;
        throw std::runtime_error("no point " + variant);
    }

    fs::path root;
    PointsRequest request;
};

}  // namespace

TEST_F(Points, CostIsRelativeToTheTextsScene) {
    const PointSet set = measured();
    // fine: the text's own discs and step, so exactly 1; whole: a quarter of the steps at 11 ns against 10.
    EXPECT_NEAR(find(set, "fine").relative_cost, 1, 1e-12);
    EXPECT_NEAR(find(set, "whole").relative_cost, 0.25 * 1.1, 1e-12);
}

TEST_F(Points, ErrorsAreAgainstTheFinestAndTheText) {
    const PointSet set = measured();
    const Point p = find(set, "whole");
    EXPECT_EQ(p.chapter, 3);
    EXPECT_EQ(p.n, 3U);
    EXPECT_NEAR(p.error_fine, 4, 0.01);
    EXPECT_LT(p.error_fine_U, 0.01);             // the same difference in each realisation
    EXPECT_NEAR(p.error_text, 106 - 102, 0.01);  // D107
    EXPECT_NEAR(p.scatter, 1, 0.01);
    EXPECT_TRUE(std::isnan(find(set, "fine").error_fine));
    EXPECT_NEAR(find(set, "fine").error_text, 0, 0.01);
}

TEST_F(Points, AWindowCostsATravelToItsEnd) {
    const PointSet set = measured();
    // 0.2–0.4 m of 0.8 m: 4 s of the 8 s of travel are saved, of 10 s simulated in all.
    const Point p = find(set, "window20-40cm");
    EXPECT_NEAR(p.relative_cost, find(set, "whole").relative_cost * (1 - 4.0 / 10), 1e-3);
    EXPECT_EQ(p.n, 3U);
}

TEST_F(Points, AStoppedRunStaysOnTheChart) {
    for (int k = 1; k <= 2; ++k) {
        const auto directory = add("coarse", k, 110, 8e-5, 125'000, 10);
        if (k == 2) stop(directory);
    }
    const Point p = find(measured(), "coarse");
    EXPECT_EQ(p.stopped, "a disc goes its radius within a step.");
    EXPECT_TRUE(std::isnan(p.error_fine));
    EXPECT_NEAR(p.relative_cost, 0.125 * 1.1, 1e-12);  // its steps, the whole scene's ns
}

TEST_F(Points, FewerRealisationsHideMore) {
    for (int k = 1; k <= 3; ++k) add("pair", k, 104.0 + 2 * k, 8e-5, 125'000, 10);  // differences to fine 5, 6, 7
    add("single", 1, 110, 8e-5, 125'000, 10);
    const Chart chart = measured().charts.front();
    // Variants' differences: whole 4, 4, 4, pair 5, 6, 7, single 9: s² = 2/4, ν = 4.
    constexpr double t4 = 2.776445105197799;  // tables: 0.975, ν = 4
    EXPECT_NEAR(chart.floor(3), t4 * std::sqrt(0.5 / 3), 0.01);
    EXPECT_NEAR(chart.floor(1), t4 * std::sqrt(0.5), 0.02);
}

TEST_F(Points, AModelWithoutRunsStandsBesideThem) {
    request.models.push_back({"formula", "a formula", {1e9, 20}, [](const Case& c) {
                                  return Values{{"gross_tractive_effort_N", 2 * c.travel.slip_percent}};
                              }});
    const PointSet set = measured();
    const Point p = find(set, "formula");
    EXPECT_EQ(p.value, 120);
    EXPECT_NEAR(p.error_fine, 120 - 102, 0.01);
    EXPECT_NEAR(p.error_text, 120 - 102, 1e-9);
    EXPECT_NEAR(p.relative_cost, 20 / (1e-9 * 1'000'000 * 19468 * 10), 1e-9);
    EXPECT_EQ(std::ranges::count(set.points, "formula", &Point::variant), 1);  // it says nothing of the others
}

TEST_F(Points, FurtherQuantitiesComeFromTheRunsDirectory) {
    request.measure_more = [](const ifedem::Run& run) {
        return Values{{"greatest_normal_stress_kPa", run.name.starts_with("fine") ? 50.0 : 53.0}};
    };
    const PointSet set = measured();
    const auto is_stress = [](const Point& p) { return p.quantity == "greatest_normal_stress_kPa"; };
    EXPECT_EQ(std::ranges::count_if(set.points, is_stress), 2);  // not for windows
    for (const Point& p : set.points)
        if (is_stress(p) && p.variant == "whole") EXPECT_NEAR(p.error_fine, 3, 1e-12);
}

TEST_F(Points, TheGuideNamesBothEndsOfAFront) {
    for (int k = 1; k <= 3; ++k) add("rough", k, 140.0 + k, 8e-5, 125'000, 10);
    write_points(request);
    const std::string out = (root / "guide").string();
    write_points_guide({{request.out_dir}, "whole", out, find_root(references) + "/reports/templates", "make x"});
    EXPECT_EQ(read_text(out + "/points.csv"), read_text(request.out_dir + "/points.csv"));
    const CsvTable front = read_csv(request.out_dir + "/front.csv");
    EXPECT_EQ(front.rows.front().cells[front.require("variant")], "rough");
    const std::string text = read_text(out + "/report.md");
    EXPECT_NE(text.find("| H [N] | rough (24.3 s) | 40 |"), std::string::npos) << text;  // 125,000 × 19,468 × 10 ns
}

TEST_F(Points, ARealisationWithoutPartnerIsTold) {
    add("lonely", 4, 100, 4e-5, 250'000, 10);
    try {
        (void)measured();
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("variant 'fine'"), std::string::npos) << e.what();
    }
}

TEST_F(Points, ThePageHoldsAFigureForEachChart) {
    stop(add("coarse", 1, 110, 8e-5, 125'000, 10));
    write_points(request);
    const CsvTable table = read_csv(request.out_dir + "/points.csv");
    const std::vector<std::string> wanted{"chapter", "wheel", "gravity",       "load_N",     "slip_percent", "quantity",
                                          "variant", "n",     "relative_cost", "error_fine", "error_text",   "scatter"};
    EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), table.header.begin()));
    EXPECT_EQ(table.rows.size(), 4 * (3 + 4U));  // quantities × (variants and windows)
    const std::string page = read_text(request.out_dir + "/index.html");
    std::size_t figures = 0;
    for (auto at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) ++figures;
    EXPECT_EQ(figures, 8U);  // four quantities against the finest and against the text
}

// `ifedem doubt` and `ifedem fit` through the program itself, on a bin of a few hundred discs: what the files say is
// what the runs say, a second call repeats no run, and bad options are refused before anything is written.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "check/csv.hpp"
#include "check/metrics.hpp"
#include "check/run.hpp"
#include "check/statistics.hpp"
#include "step/stages.hpp"
#include "support/program.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

const std::string tiny = IFEDEM_SOURCE_DIR "/tests/reliability/tiny.toml";

class Variants : public testing::Test {
protected:
    [[nodiscard]] ProgramEnd run(std::vector<std::string> command) const {
        // Faster than the file: its numbers need not mean anything, and a smooth tread needs no pitch in the window.
        for (const char* setting : {"wheel.lug_pairs=0", "bed.disc_count=200", "record.frame_interval_s=0"})
            command.insert(command.end(), {"--set", setting});
        command.insert(command.end(), {"--n", "2", "--jobs", "2", "--stages", scratch.file("stages")});
        return Program(command, scratch.file("log")).wait();
    }
    /// When each run below the directory ended.
    [[nodiscard]] std::map<std::string, fs::file_time_type> ends(const std::string& directory) const {
        std::map<std::string, fs::file_time_type> times;
        for (const auto& entry : fs::directory_iterator(scratch.file(directory)))
            if (fs::exists(entry.path() / "run.csv"))
                times[entry.path().filename()] = fs::last_write_time(entry.path() / "run.csv");
        return times;
    }
    /// Window means of the two realisations under this name.
    [[nodiscard]] std::vector<double> means(const std::string& name, double RunMetrics::*member) const {
        std::vector<double> values;
        for (const char* realisation : {"-r1", "-r2"}) {
            const ifedem::Run r = read_run(scratch.file(name) + realisation);
            values.push_back(measure(r, {0.5 * r.c.travel.distance_m, r.c.travel.distance_m}).*member);
        }
        return values;
    }

    Scratch scratch;
};

struct Table {
    CsvTable csv;
    [[nodiscard]] std::string text(std::size_t row, const char* column) const {
        return csv.rows.at(row).cells[csv.require(column)];
    }
    [[nodiscard]] double number(std::size_t row, const char* column) const {
        return parse_number(text(row, column)).value_or(std::nan(""));
    }
};

TEST_F(Variants, DoubtSaysWhatTheRunsSay) {
    const std::vector<std::string> command = {"doubt", tiny, "-o", scratch.file("doubt"), "--quantities", "z,H"};
    const ProgramEnd first = run(command);
    ASSERT_EQ(first.status, 0) << first.errors;
    const Table table{read_csv(scratch.file("doubt/doubt.csv"))};
    const std::vector<std::string> names = {"depth", "length", "discs", "mesh", "step"};
    ASSERT_EQ(table.csv.rows.size(), 2 * names.size());
    const std::vector<double> before = means("doubt/default", &RunMetrics::sinkage_cm);
    const Case c = read_case(scratch.file("doubt/default-r2/case.toml"));
    EXPECT_EQ(c.bed.seed, 2);
    EXPECT_GT(c.wheel.lug_phase_deg, 0);
    for (std::size_t v = 0; v < names.size(); ++v) {
        EXPECT_EQ(table.text(2 * v, "variation"), names[v]);
        EXPECT_EQ(table.text(2 * v, "quantity"), "z");
        EXPECT_EQ(table.text(2 * v + 1, "quantity"), "H");
        const PairedDifference expected =
            paired_difference(before, means("doubt/" + names[v], &RunMetrics::sinkage_cm));
        EXPECT_NEAR(table.number(2 * v, "difference"), expected.mean, 1e-5) << names[v];
        EXPECT_NEAR(table.number(2 * v, "half_width"), expected.half_width, 1e-4) << names[v];
        EXPECT_NEAR(table.number(2 * v, "tolerance"), 0.05 * std::abs(mean(before)), 1e-5);
        const Case variant = read_case(scratch.file("doubt/" + names[v] + "-r2/case.toml"));
        EXPECT_EQ(variant.bed.seed, 2);
        EXPECT_EQ(variant.wheel.lug_phase_deg, c.wheel.lug_phase_deg);
        EXPECT_NEAR(table.number(2 * v, "relative_cost"), count_disc_steps(variant) / count_disc_steps(c), 5e-3);
        EXPECT_NE(table.text(2 * v, "changes"), "");
    }
    const auto before_again = ends("doubt");
    EXPECT_EQ(before_again.size(), 12U);
    const std::string text = read_text(scratch.file("doubt/doubt.csv"));
    const ProgramEnd second = run(command);
    EXPECT_EQ(second.status, 0) << second.errors;
    EXPECT_NE(second.errors.find("12 runs, 12 of them complete already"), std::string::npos) << second.errors;
    EXPECT_EQ(ends("doubt"), before_again);
    EXPECT_EQ(read_text(scratch.file("doubt/doubt.csv")), text);

    std::vector<std::string> fewer = command;
    fewer.insert(fewer.end(), {"--only", "step,mesh"});
    ASSERT_EQ(run(fewer).status, 0);
    const Table part{read_csv(scratch.file("doubt/doubt.csv"))};
    ASSERT_EQ(part.csv.rows.size(), 4U);
    for (std::size_t row = 0; row < 4; ++row) EXPECT_EQ(part.csv.rows[row].cells, table.csv.rows[row + 6].cells);
    fewer.back() = "mass";
    const ProgramEnd refused = run(fewer);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.errors.find("'mass' is nothing that can be more"), std::string::npos) << refused.errors;
}

TEST_F(Variants, FitKeepsWhatItsLogSays) {
    // The effective radius scatters so little that two realisations show something; twice this step is beyond a limit.
    const std::vector<std::string> command = {"fit",          tiny,
                                              "-o",           scratch.file("small.toml"),
                                              "--quantities", "effective_radius_m",
                                              "--tolerance",  "15%",
                                              "--only",       "step,ahead",
                                              "--set",        "time_step_s=1e-4"};
    const ProgramEnd first = run(command);
    ASSERT_EQ(first.status, 0) << first.errors;
    const Table log{read_csv(scratch.file("small.csv"))};
    EXPECT_EQ(log.text(0, "trial"), "original");
    const std::vector<double> before = means("small-runs/original", &RunMetrics::effective_radius_m);
    const double tolerance = 0.15 * mean(before);
    std::string kept = "original";
    for (std::size_t k = 1; k < log.csv.rows.size(); ++k) {
        const std::string trial = log.text(k, "trial"), decision = log.text(k, "decision");
        if (decision == "kept") kept = trial;
        if (log.text(k, "n") == "0") continue;  // it did not run, or not to its end
        const PairedDifference expected =
            paired_difference(before, means("small-runs/" + trial, &RunMetrics::effective_radius_m));
        EXPECT_NEAR(log.number(k, "effective_radius_m_difference"), expected.mean,
                    1e-5 * std::abs(expected.mean) + 1e-8);
        EXPECT_EQ(decision == "kept", std::abs(expected.mean) + expected.half_width <= tolerance) << trial;
    }
    EXPECT_NE(log.text(1, "decision").find("the largest stable step"), std::string::npos);
    EXPECT_FALSE(fs::exists(scratch.file("small-runs/step-0.5-r1")));
    ASSERT_NE(kept, "original");

    // What is written is what was last kept, and it is a case.
    const Case small = read_case(scratch.file("small.toml"));
    const Case ran = read_case(scratch.file("small-runs/" + kept + "-r1/case.toml"));
    EXPECT_LT(count_disc_steps(small), count_disc_steps(read_case(scratch.file("small-runs/original-r1/case.toml"))));
    for (const Override& change : list_changes(small, ran)) EXPECT_EQ(change.key, "bed.seed");  // of realisation 1

    const auto times = ends("small-runs");
    const std::string text = read_text(scratch.file("small.csv")), toml = read_text(scratch.file("small.toml"));
    EXPECT_EQ(run(command).status, 0);
    EXPECT_EQ(ends("small-runs"), times);
    EXPECT_EQ(read_text(scratch.file("small.csv")), text);
    EXPECT_EQ(read_text(scratch.file("small.toml")), toml);
}

TEST_F(Variants, FitTriesNoCaseTwice) {
    // Half of three rings is two, and so are three quarters; a tread of twelve columns has no fewer.
    const ProgramEnd end = run({"fit", tiny, "-o", scratch.file("small.toml"), "--quantities", "H", "--tolerance",
                                "0.0001%", "--only", "mesh", "--set", "wheel.smooth_columns=12", "--set",
                                "wheel.intermediate_rings=3", "--set", "wheel.surface_rings=1"});
    ASSERT_EQ(end.status, 0) << end.errors;
    const Table log{read_csv(scratch.file("small.csv"))};
    ASSERT_EQ(log.csv.rows.size(), 2U);
    EXPECT_EQ(log.text(1, "changes"), "wheel.intermediate_rings = 2");
}

TEST_F(Variants, SayWhatIsWrongBeforeTheyWrite) {
    const std::string out = scratch.file("out.toml");
    struct Bad {
        std::vector<std::string> options;
        std::string named;
    };
    const std::vector<Bad> bad = {{{"--quantities", "H,slope"}, "slope"},
                                  {{"--tolerance", "some"}, "some"},
                                  {{"--tolerance", "5"}, "5%"},
                                  {{"--n", "1"}, "--n 1"},
                                  {{"--set", "travel.start_x_m=9"}, "right wall"}};
    for (const char* command : {"doubt", "fit"}) {
        for (const Bad& b : bad) {
            std::vector<std::string> arguments = {command, tiny, "-o", out, "--set", "wheel.lug_pairs=0"};
            arguments.insert(arguments.end(), b.options.begin(), b.options.end());
            const ProgramEnd outcome = Program(arguments, scratch.file("log")).wait();
            EXPECT_EQ(outcome.status, 2) << command << outcome.errors;
            EXPECT_NE(outcome.errors.find(b.named), std::string::npos) << outcome.errors;
        }
    }
    // Lugs that pass seldomer than the travel is long.
    EXPECT_EQ(Program({"doubt", tiny, "-o", out}, scratch.file("log")).wait().status, 2);
    EXPECT_EQ(run({"fit", tiny, "-o", out, "--evidence", "none"}).status, 2);
    EXPECT_EQ(run({"fit", tiny, "-o", out, "--only", "step,width"}).status, 2);
    EXPECT_EQ(run({"fit", tiny, "-o", tiny}).status, 2);
    EXPECT_EQ(run({"fit", tiny, "-o", scratch.file("out")}).status, 2);
    for (const auto& entry : fs::directory_iterator(scratch.path)) EXPECT_EQ(entry.path().filename(), "log");
}

}  // namespace
}  // namespace ifedem

// `ifedem calibrate` through the program itself, on the tutorial's sand: the files, the same bytes on any number of
// threads, an answer to a key, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "check/csv.hpp"
#include "support/program.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

const std::string sand = IFEDEM_SOURCE_DIR "/tests/tutorial/sand.toml";

class Calibrate : public testing::Test {
protected:
    [[nodiscard]] ProgramEnd run(const std::string& path, const std::string& output,
                                 const std::vector<std::string>& more) const {
        std::vector<std::string> command = {"calibrate", path, "-o", scratch.file(output), "--quick", "--n", "1"};
        command.insert(command.end(), more.begin(), more.end());
        return Program(command, scratch.file("log")).wait();
    }
    [[nodiscard]] std::map<std::string, double> measured(const std::string& output) const {
        const CsvTable t = read_csv(scratch.file(output + "/measurements.csv"));
        std::map<std::string, double> values;
        for (const CsvRow& row : t.rows)
            values[row.cells[t.require("name")]] = parse_number(row.cells[t.require("value")]).value_or(std::nan(""));
        return values;
    }
    [[nodiscard]] std::string write_case(const std::string& text) const {
        std::ofstream(scratch.file("case.toml")) << text;
        return scratch.file("case.toml");
    }
    void expect_refused(const std::string& text, const std::string& message) const {
        const ProgramEnd outcome = run(write_case(text), "refused", {});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
        EXPECT_FALSE(fs::exists(scratch.file("refused")));
    }

    Scratch scratch;
};

TEST_F(Calibrate, MeasuresTheSameOnAnyNumberOfThreadsAndAnswersToAlpha) {
    const ProgramEnd one = run(sand, "one", {"--jobs", "1"}), two = run(sand, "two", {"--jobs", "2"});
    ASSERT_EQ(one.status, 0) << one.errors;
    ASSERT_EQ(two.status, 0) << two.errors;
    for (const char* file : {"realisations.csv", "measurements.csv", "figures/box.csv", "figures/heap.csv"}) {
        const std::string text = read_text(scratch.file("one/") + file);
        EXPECT_GT(text.size(), 300U) << file;
        EXPECT_EQ(text, read_text(scratch.file("two/") + file)) << file;
    }
    const std::map<std::string, double> values = measured("one");
    ASSERT_EQ(values.size(), 12U);
    for (const auto& [name, value] : values) EXPECT_TRUE(std::isfinite(value)) << name;
    EXPECT_NEAR(values.at("porosity"), 0.16, 0.03);
    EXPECT_NE(read_text(scratch.file("one/index.html")).find("cannot tell: more realisations"), std::string::npos);
    EXPECT_TRUE(fs::exists(scratch.file("one/report.md")));

    const ProgramEnd smooth = run(sand, "smooth", {"--set", "contact.rolling_factor=0", "--jobs", "2"});
    ASSERT_EQ(smooth.status, 0) << smooth.errors;
    const std::map<std::string, double> rolling_free = measured("smooth");
    EXPECT_LT(rolling_free.at("friction_angle"), values.at("friction_angle") - 10);
    EXPECT_LT(rolling_free.at("shear_angle"), values.at("shear_angle"));
    EXPECT_LT(rolling_free.at("repose_angle"), values.at("repose_angle"));
    EXPECT_EQ(rolling_free.at("porosity"), values.at("porosity")) << "the bed settles without friction";
}

TEST_F(Calibrate, RefusesFaultyCasesBeforeAnythingIsWritten) {
    expect_refused("[target]\nfriction_angel_deg = 38\n", "case.toml:2:1: unknown key target.friction_angel_deg");
    expect_refused("[target]\nporosity = 40\n", "case.toml:2:12: target.porosity = 40");
    expect_refused("[contact]\nfriction_soil = \"high\"\n", "case.toml:2:17: contact.friction_soil is a text");
    expect_refused("gravity_m_s2 = 0\n", "gravity_m_s2 is 0");
    expect_refused("time_step_ms = 1\n", "time_step_s = 0.001 is ");
}

}  // namespace
}  // namespace ifedem

// The sweep through the program itself: it gives the runs that single commands give, goes on where it stopped, and says
// what is wrong with its options.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "check/csv.hpp"
#include "support/program.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

class Sweep : public testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> arguments(const std::string& slips, const std::string& loads) const {
        return {"sweep",    IFEDEM_SOURCE_DIR "/tests/reliability/tiny.toml",
                "-o",       scratch.file("sweep"),
                "--slip",   slips,
                "--load",   loads,
                "--jobs",   "2",
                "--set",    "wheel.lug_pairs=0",
                "--stages", scratch.file("stages")};
    }
    [[nodiscard]] ProgramEnd run(const std::vector<std::string>& command) const {
        return Program(command, scratch.file("log")).wait();
    }
    [[nodiscard]] std::string hash(const std::string& directory) const {
        return run_value(scratch.file(directory), "state_hash");
    }

    Scratch scratch;
};

TEST_F(Sweep, GivesTheRunsOfSingleCommands) {
    const ProgramEnd first = run(arguments("20,60,20", "30,50"));  // 20 twice: one run
    ASSERT_EQ(first.status, 0) << first.errors;
    ASSERT_EQ(run({"run", IFEDEM_SOURCE_DIR "/tests/reliability/tiny.toml", "-o", scratch.file("one"), "--quiet",
                   "--set", "wheel.lug_pairs=0", "--set", "wheel.load_N=50", "--set", "travel.slip_percent=60",
                   "--stages", scratch.file("other-stages")})
                  .status,
              0);
    EXPECT_EQ(hash("sweep/load-50-slip-60"), hash("one"));
    EXPECT_NE(hash("sweep/load-50-slip-20"), hash("one"));

    const CsvTable table = read_csv(scratch.file("sweep/sweep.csv"));
    ASSERT_EQ(table.rows.size(), 4U);
    const std::size_t torque = table.require("torque_Nm"), note = table.require("note");
    for (const CsvRow& row : table.rows) {
        EXPECT_TRUE(parse_number(row.cells[torque])) << row.cells[note];
        EXPECT_EQ(row.cells[note], "");
    }
    const std::string page = read_text(scratch.file("sweep/index.html"));
    EXPECT_NE(page.find("4 of 4 runs complete."), std::string::npos);
    EXPECT_NE(page.find("--load 30,50 --slip=20,60,20 --set wheel.lug_pairs=0"), std::string::npos);
    EXPECT_NE(page.find("id=\"torque_Nm\""), std::string::npos);
    for (const char* file : {"figures/torque_Nm.svg", "figures/torque_Nm.csv", "load-30-slip-20/contact_sheet.png",
                             "load-30-slip-20/travel.gif"})
        EXPECT_TRUE(fs::exists(scratch.file("sweep/") + file)) << file;
    EXPECT_EQ(read_text(scratch.file("sweep/load-30-slip-20/travel.gif")).substr(0, 6), "GIF89a");

    const auto before = fs::last_write_time(scratch.file("sweep/load-50-slip-60/run.csv"));
    const ProgramEnd again = run(arguments("20:60:40", "30,50"));
    EXPECT_NE(again.errors.find("4 of them complete already"), std::string::npos) << again.errors;
    EXPECT_EQ(fs::last_write_time(scratch.file("sweep/load-50-slip-60/run.csv")), before);
}

TEST_F(Sweep, GoesOnWhereItWasStopped) {
    const Program program(arguments("20,60", "50"), scratch.file("log"));
    while (!fs::exists(scratch.file("sweep/load-50-slip-20/case.toml")))
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.send(SIGTERM);
    EXPECT_EQ(program.wait().status, 143);
    const ProgramEnd second = run(arguments("20,60", "50"));
    EXPECT_EQ(second.status, 0) << second.errors;
    EXPECT_NE(hash("sweep/load-50-slip-20"), "");
    EXPECT_NE(hash("sweep/load-50-slip-60"), "");
}

TEST_F(Sweep, SaysWhatIsWrongBeforeItWrites) {
    for (const char* slips : {"a", "0:70", "0:70:0", "70:0:10", "1,,2", "0:1e9:1", "100"}) {
        const ProgramEnd outcome = run(arguments(slips, "50"));
        EXPECT_EQ(outcome.status, 2) << slips << ": " << outcome.errors;
        EXPECT_NE(outcome.errors.find(slips), std::string::npos) << outcome.errors;
    }
    EXPECT_FALSE(fs::exists(scratch.file("sweep")));
}

}  // namespace
}  // namespace ifedem

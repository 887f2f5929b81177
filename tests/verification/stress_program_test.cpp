// Chapter 4's way through the program: a travel that averages contact forces, `stress`, `soil`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "support/scratch.hpp"

namespace ifedem {
namespace {

/// A smooth wheel on 500 discs: a second or two.
constexpr const char* small_case = R"(name = "small"
[bed]
length_m = 0.5
disc_count = 500
levelled_count = 490
[wheel]
lug_pairs = 0
load_N = 60
[travel]
slip_percent = 30
start_x_m = 0.25
distance_m = 0.02
acceleration_time_s = 0.02
[stages]
consolidation_s = 0.2
sinkage_s = 0.2
[record]
stress_segments = 1000
stress_blocks = 4
stress_from_x_m = 0.254
stress_to_x_m = 0.266
final_stress = "write"
checkpoint_interval_s = 0
)";

int run_program(const std::string& arguments) {
    const std::string quiet = std::string(IFEDEM_PROGRAM) + " " + arguments + " > /dev/null 2>&1";
    const int status = std::system(quiet.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

struct SmallRun {
    Scratch scratch;
    SmallRun() { std::ofstream(scratch.file("case.toml")) << small_case; }
    /// "run case.toml -o NAME" with its own stage cache.
    [[nodiscard]] int run(const std::string& name, const std::string& more = "") const {
        return run_program("run " + scratch.file("case.toml") + " -o " + scratch.file(name) + " --stages " +
                           scratch.file("stages") + " --quiet " + more);
    }
};

/// name → value of a measurements.csv.
std::map<std::string, double> read_measures(const std::string& path) {
    std::map<std::string, double> values;
    std::istringstream lines(read_text(path));
    std::string line;
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("name,value,units,scatter,n,note")) << line;
    while (std::getline(lines, line)) {
        const auto comma = line.find(',');
        values[line.substr(0, comma)] = std::strtod(line.c_str() + comma + 1, nullptr);
    }
    return values;
}

/// Growth of the wheel's vertical momentum over the averaging window, from contact_balance.csv.
double mean_inertia_N(const std::string& directory) {
    std::istringstream lines(read_text(directory + "/contact_balance.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("block,steps,drawbar_N,torque_Nm,effective_radius_m,impulse_x_Ns,impulse_y_Ns,"))
        << line;
    double steps = 0, impulse_Ns = 0;
    while (std::getline(lines, line)) {
        std::vector<double> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(std::strtod(cell.c_str(), nullptr));
        steps += cells.at(1), impulse_Ns += cells.at(6);
    }
    return impulse_Ns / (steps * read_case(directory + "/case.toml").time_step_s);
}

TEST(StressProgram, identities_hold_in_a_travel) {
    const SmallRun small;
    ASSERT_EQ(small.run("a"), 0);
    ASSERT_EQ(run_program("stress " + small.scratch.file("a") + " -o " + small.scratch.file("out")), 0);
    const auto m = read_measures(small.scratch.file("out/measurements.csv"));
    EXPECT_LE(m.at("identity_horizontal"), 0.005);
    EXPECT_LE(m.at("identity_vertical"), 0.005);
    EXPECT_LE(m.at("identity_torque"), 0.005);
    EXPECT_LE(m.at("identity_H"), 0.01);
    EXPECT_LE(m.at("identity_vectors"), 0.002);
    EXPECT_LE(m.at("identity_splines"), 1e-3);
    EXPECT_LE(m.at("identity_quadrature"), 1e-6);
    // The wheel bounces, so that its short window carries W and what its momentum grew by.
    EXPECT_NEAR(m.at("load_N_s30"), 60 + mean_inertia_N(small.scratch.file("a")), 1e-3 * 60);
    EXPECT_LT(m.at("entry_deg_s30"), 90);
    EXPECT_GT(m.at("exit_deg_s30"), m.at("entry_deg_s30"));
    for (const char* name : {"curves.csv", "angles.csv", "relative_peak.csv", "performance.csv", "load.csv"})
        EXPECT_FALSE(read_text(small.scratch.file(std::string("out/") + name)).empty()) << name;
}

/// Lines NAME_sSLIP: a claim of NAME over slips is a curve through them.
std::ptrdiff_t count_slips(const std::map<std::string, double>& measured, const std::string& name) {
    return std::ranges::count_if(measured, [&](const auto& line) { return line.first.starts_with(name + "_s"); });
}

// A claim that names what nobody measures would wait for ever as not-computable.
TEST(StressProgram, measures_all_that_the_claims_name) {
    const SmallRun small;
    std::string runs;
    for (const char* slip : {"-5", "1", "7.5", "22", "37.5", "55"}) {
        ASSERT_EQ(small.run(slip, std::string("--set travel.slip_percent=") + slip), 0);
        runs += small.scratch.file(slip) + " ";
    }
    ASSERT_EQ(run_program("stress " + runs + "-o " + small.scratch.file("out")), 0);
    auto measured = read_measures(small.scratch.file("out/measurements.csv"));
    // What the sensitivity runs measure: how the controllers follow with other gains.
    ASSERT_EQ(small.run("text"), 0);
    std::string others;
    for (const auto& [name, change] :
         std::map<std::string, std::string>{{"drawbarI10", "--set control.drawbar.integral_N_m_s=1e5"},
                                            {"drawbarP10", "--set control.drawbar.proportional_N_m=1e5"},
                                            {"torqueI10", "--set control.torque.integral_Nm_rad_s=1e4"},
                                            {"torqueP10", "--set control.torque.proportional_Nm_rad=1e4"}}) {
        ASSERT_EQ(small.run(name, change), 0);
        others += " " + small.scratch.file(name);
    }
    const std::string gains = "sh " IFEDEM_SOURCE_DIR "/reproductions/chapter4/gains.sh " + small.scratch.file("gains");
    ASSERT_EQ(std::system((gains + others).c_str()), 0);
    EXPECT_TRUE(read_measures(small.scratch.file("gains/measurements.csv")).empty()) << "without the default run";
    ASSERT_EQ(std::system((gains + " " + small.scratch.file("text") + others).c_str()), 0);
    measured.merge(read_measures(small.scratch.file("gains/measurements.csv")));
    // Three discs deep, the bed has no bulk; a centimetre of travel leaves no surface behind the wheel.
    const std::set<std::string> too_small{"bulk_density", "porosity", "void_ratio", "surface_rougher_s22",
                                          "surface_higher_s22"};
    std::istringstream lines(read_text(IFEDEM_SOURCE_DIR "/reproductions/chapter4/claims.csv"));
    std::size_t named = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto from = line.find("measured:");
        if (from == std::string::npos) continue;
        const std::string name = line.substr(from + 9, line.find(',', from) - from - 9);
        ++named;
        EXPECT_TRUE(measured.contains(name) || count_slips(measured, name) >= 3 || too_small.contains(name)) << name;
    }
    EXPECT_GT(named, 30U);
}

TEST(StressProgram, a_resumed_run_writes_the_same_stress) {
    const SmallRun small;
    ASSERT_EQ(small.run("a"), 0);
    ASSERT_EQ(small.run("b", "--stop-at-step 13500"), 0);  // within the window
    ASSERT_TRUE(std::filesystem::exists(small.scratch.file("b/checkpoint.h5")));
    ASSERT_EQ(run_program("resume " + small.scratch.file("b") + " --stages " + small.scratch.file("stages")), 0);
    for (const char* name : {"contact_stress.csv", "contact_blocks.csv", "contact_balance.csv", "stress.csv"}) {
        const std::string a = read_text(small.scratch.file(std::string("a/") + name));
        EXPECT_GT(a.size(), 200U);
        EXPECT_EQ(a, read_text(small.scratch.file(std::string("b/") + name))) << name;
    }
}

// run.csv says that a run is whole: it must not stand beside tables that are missing.
TEST(StressProgram, a_run_whose_tables_cannot_be_written_is_not_finished) {
    namespace fs = std::filesystem;
    const SmallRun small;
    ASSERT_EQ(small.run("a"), 0);
    ASSERT_EQ(small.run("b", "--stop-at-step 13500"), 0);
    const std::string in_the_way = small.scratch.file("b/contact_blocks.csv");
    fs::create_directories(in_the_way + "/not-empty");
    const std::string resume = "resume " + small.scratch.file("b") + " --stages " + small.scratch.file("stages");
    EXPECT_EQ(run_program(resume), 4);
    EXPECT_FALSE(fs::exists(small.scratch.file("b/run.csv")));
    fs::remove_all(in_the_way);
    EXPECT_EQ(run_program(resume), 0);
    EXPECT_TRUE(fs::exists(small.scratch.file("b/run.csv")));
    EXPECT_EQ(read_text(in_the_way), read_text(small.scratch.file("a/contact_blocks.csv")));
}

TEST(StressProgram, refuses_a_run_without_contact_stress) {
    const SmallRun small;
    ASSERT_EQ(small.run("a", "--set record.stress_segments=0"), 0);
    EXPECT_FALSE(std::filesystem::exists(small.scratch.file("a/contact_stress.csv")));
    EXPECT_EQ(run_program("stress " + small.scratch.file("a") + " -o " + small.scratch.file("out")), 2);
}

// Segments count from 1: a table that says 0 must not be written before its beginning.
TEST(StressProgram, refuses_a_damaged_table) {
    const SmallRun small;
    ASSERT_EQ(small.run("a"), 0);
    const std::string path = small.scratch.file("a/contact_blocks.csv"), whole = read_text(path);
    const std::size_t line = whole.find('\n') + 1, segment = whole.find(',', line) + 1;
    for (const char* wrong : {"0", "-1", "2.5", "1002"}) {
        std::ofstream(path) << whole.substr(0, segment) + wrong + whole.substr(whole.find(',', segment));
        const std::string errors = small.scratch.file("errors");
        const std::string command = std::string(IFEDEM_PROGRAM) + " stress " + small.scratch.file("a") + " -o " +
                                    small.scratch.file("out") + " 2> " + errors;
        const int status = std::system(command.c_str());
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 2);
        EXPECT_NE(read_text(errors).find(std::string("contact_blocks.csv:2: segment = ") + wrong + " "),
                  std::string::npos)
            << read_text(errors);
    }
}

// A plate sinks deeper under more load, does not turn, and resists being dragged with no more than its friction and the
// sand in front of it can bear.
TEST(StressProgram, plates_give_soil_parameters) {
    const SmallRun small;
    const std::string plate =
        "--set wheel.shape=plate --set wheel.plate_length_m=0.08 --set record.stress_segments=0 "
        "--set stages.load_ramp_s=0.15 --set travel.distance_m=0.01 --set wheel.load_N=";
    std::string runs;
    for (const char* load : {"20", "40", "80"}) {
        ASSERT_EQ(small.run(load, plate + load), 0);
        runs += small.scratch.file(load) + " ";
    }
    ASSERT_EQ(run_program("soil " + runs + "-o " + small.scratch.file("soil")), 0);
    const auto soil = read_measures(small.scratch.file("soil/measurements.csv"));
    EXPECT_GT(soil.at("soil_pressure_modulus"), 0);
    EXPECT_GT(soil.at("soil_pressure_exponent"), 0);
    EXPECT_GT(soil.at("soil_friction"), 0);
    EXPECT_LT(soil.at("soil_friction"), 1);
    ASSERT_EQ(small.run("a"), 0);
    EXPECT_EQ(run_program("soil " + small.scratch.file("a") + " -o " + small.scratch.file("soil")), 2);
}

}  // namespace
}  // namespace ifedem

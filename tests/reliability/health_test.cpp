// Runs that must stop by themselves: exit 3, the step, the body, the value, the limit and a remedy; and one that must
// not.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

struct Outcome {
    int code = 0;
    std::string text;
};

enum class Unstable { allowed, refused };

/// The short case on a tiny bed with the given overrides.
Outcome run_with(const std::string& sets, Unstable unstable = Unstable::allowed) {
    const auto root = std::filesystem::temp_directory_path() / ("ifedem-health-" + std::to_string(getpid()));
    const std::string command = std::string(IFEDEM_PROGRAM) + " run " + IFEDEM_SOURCE_DIR +
                                "/reproductions/chapter3/cases/short.toml -o " + (root / "run").string() +
                                " --stages " + (root / "stages").string() +
                                " --quiet --force --set bed.disc_count=700 --set bed.length_m=0.5"
                                " --set travel.start_x_m=0.2 --set travel.distance_m=0.02"
                                " --set stages.consolidation_s=0.3 --set stages.sinkage_s=0.1 " +
                                sets + (unstable == Unstable::allowed ? " --allow-unstable" : "") + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) outcome.text += buffer.data();
    outcome.code = WEXITSTATUS(pclose(pipe));
    std::filesystem::remove_all(root);
    return outcome;
}

void expect_stop(const std::string& sets, const std::string& what) {
    const Outcome o = run_with(sets);
    EXPECT_EQ(o.code, 3) << o.text;
    EXPECT_NE(o.text.find("stopped at step "), std::string::npos) << o.text;
    EXPECT_NE(o.text.find(what), std::string::npos) << o.text;
    EXPECT_NE(o.text.find("limit "), std::string::npos) << o.text;
}

TEST(Health, LetsAHealthyRunPass) { EXPECT_EQ(run_with("").code, 0); }

TEST(Health, StopsAStepTooLargeForTheContacts) {
    // 2/√(2K/m) of the smallest discs is 2.6e-4 s (closed form of an isolated pair); a bed has less.
    const Outcome o = run_with("--set time_step_s=5e-4");
    EXPECT_EQ(o.code, 3) << o.text;
    EXPECT_NE(o.text.find("cause: contact-step"), std::string::npos) << o.text;
}

TEST(Health, RefusesAStepBeyondALimit) {
    for (const char* sets : {"--set time_step_s=5e-4", "--set control.scheme=explicit --set time_step_s=8e-5"}) {
        const Outcome o = run_with(sets, Unstable::refused);
        EXPECT_EQ(o.code, 2) << o.text;
        EXPECT_NE(o.text.find("times the largest stable step"), std::string::npos) << o.text;
        EXPECT_NE(o.text.find("--allow-unstable"), std::string::npos) << o.text;
    }
}

TEST(Health, StopsAnOverloadedWheel) {
    const Outcome o = run_with("--set wheel.load_N=20000");
    EXPECT_EQ(o.code, 3) << o.text;
    EXPECT_NE(o.text.find("stopped at step "), std::string::npos) << o.text;
    EXPECT_NE(o.text.find("is inverted: least Jacobian of its corners in m² (value -"), std::string::npos) << o.text;
    EXPECT_NE(o.text.find("cause: element-overload"), std::string::npos) << o.text;
}

TEST(Health, StopsAWheelThatItsControllerLost) {
    expect_stop(
        "--set control.drawbar.proportional_N_m=0 --set control.drawbar.integral_N_m_s=0"
        " --set control.drawbar.derivative_N_s_m=0 --set health.drawbar_error_limit_m=0.005",
        "the hub is too far from its target");
    expect_stop(
        "--set control.torque.proportional_Nm_rad=0 --set control.torque.integral_Nm_rad_s=0"
        " --set control.torque.derivative_Nm_s_rad=0 --set health.torque_error_limit_rad=0.05",
        "the rim's angle is too far from its target");
}

TEST(Health, StopsTooDeepAnOverlap) { expect_stop("--set health.overlap_limit=0.001", "overlap"); }

}  // namespace

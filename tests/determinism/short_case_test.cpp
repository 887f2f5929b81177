// The short case through the program itself: one hash for threads and vector widths, for interrupted and uninterrupted
// runs.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <thread>

namespace {

namespace fs = std::filesystem;

const std::string source = IFEDEM_SOURCE_DIR;

std::string read_text(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// A value of run.csv.
std::string run_value(const fs::path& directory, const std::string& name) {
    std::istringstream lines(read_text(directory / "run.csv"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(name + ",")) return line.substr(name.size() + 1, line.rfind(',') - name.size() - 1);
    return "";
}

std::string golden_hash(const std::string& name) {
    std::istringstream lines(read_text(source + "/tests/determinism/golden.csv"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(name + ",")) return line.substr(name.size() + 1);
    return "";
}

class ShortCase : public testing::Test {
protected:
    void SetUp() override {
        root_ = fs::temp_directory_path() / (std::string("ifedem-short-") + std::to_string(getpid()));
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    /// Starts the program; the child never shares a stage cache with another test unless asked.
    pid_t start(const std::vector<std::string>& arguments) {
        const pid_t child = fork();
        if (child != 0) return child;
        std::vector<char*> argv;
        std::string program = IFEDEM_PROGRAM;
        argv.push_back(program.data());
        std::vector<std::string> kept = arguments;
        for (std::string& a : kept) argv.push_back(a.data());
        argv.push_back(nullptr);
        if (freopen("/dev/null", "w", stdout) == nullptr) _exit(126);
        execv(program.c_str(), argv.data());
        _exit(127);
    }
    int wait(pid_t child) {
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    std::vector<std::string> run_arguments(const std::string& name, const std::vector<std::string>& more = {}) {
        std::vector<std::string> a = {"run",      source + "/reproductions/chapter3/cases/short.toml",
                                      "-o",       (root_ / name).string(),
                                      "--stages", (root_ / (name + "-stages")).string(),
                                      "--quiet"};
        a.insert(a.end(), more.begin(), more.end());
        return a;
    }
    fs::path root_;
};

TEST_F(ShortCase, HasThePinnedHash) {
    ASSERT_EQ(wait(start(run_arguments("one"))), 0);
    EXPECT_EQ(run_value(root_ / "one", "state_hash"), golden_hash("short"));
}

TEST_F(ShortCase, HasTheSameBitsForTwoThreadsAndScalarCode) {
    ASSERT_EQ(setenv("IFEDEM_VECTOR_WIDTH", "1", 1), 0);
    const int status = wait(start(run_arguments("scalar", {"--threads", "2"})));
    unsetenv("IFEDEM_VECTOR_WIDTH");
    ASSERT_EQ(status, 0);
    EXPECT_EQ(run_value(root_ / "scalar", "state_hash"), golden_hash("short"));
}

/// SIGTERM leaves a checkpoint and exit 143, SIGKILL leaves whatever the last checkpoint was; both resume to the same
/// end.
TEST_F(ShortCase, ResumesToTheSameEnd) {
    for (const int signal : {SIGTERM, SIGKILL}) {
        const std::string name = signal == SIGTERM ? "terminated" : "killed";
        const pid_t child = start(run_arguments(name));
        // Late enough to be travelling, which is what leaves a checkpoint in the directory.
        for (int waited = 0; waited < 3000 && read_text(root_ / name / "series.csv").size() < 60000; ++waited)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ASSERT_EQ(kill(child, signal), 0);
        ASSERT_EQ(wait(child), 128 + signal);
        ASSERT_FALSE(fs::exists(root_ / name / "run.csv")) << "the run ended before it was stopped: nothing was tested";
        ASSERT_EQ(wait(start({"resume", (root_ / name).string(), "--stages", (root_ / (name + "-stages")).string(),
                              "--quiet"})),
                  0);
        EXPECT_EQ(run_value(root_ / name, "state_hash"), golden_hash("short"));
    }
    EXPECT_EQ(read_text(root_ / "terminated" / "series.csv"), read_text(root_ / "killed" / "series.csv"));
}

/// Twenty steps anywhere in the three stages, drawn once; a briefer case.
TEST_F(ShortCase, ResumesFromTwentySteps) {
    const std::vector<std::string> brief = {
        "--set", "stages.consolidation_s=0.1", "--set", "stages.sinkage_s=0.06",
        "--set", "travel.distance_m=0.002",    "--set", "travel.acceleration_time_s=0.04"};
    ASSERT_EQ(wait(start(run_arguments("whole", brief))), 0);
    const auto steps = static_cast<std::uint32_t>(std::stoul(run_value(root_ / "whole", "total_steps")));
    const std::string hash = run_value(root_ / "whole", "state_hash");
    ASSERT_GE(hash.size(), 16U);
    std::minstd_rand draw(1);
    for (int n = 0; n < 20; ++n) {
        const std::string step = std::to_string(1 + draw() % (steps - 1)), name = "stopped-" + step;
        std::vector<std::string> arguments = run_arguments(name, brief);
        arguments.insert(arguments.end(), {"--stop-at-step", step});
        ASSERT_EQ(wait(start(arguments)), 0);
        ASSERT_TRUE(fs::exists(root_ / name / "checkpoint.h5"));
        ASSERT_EQ(wait(start({"resume", (root_ / name).string(), "--stages", (root_ / (name + "-stages")).string(),
                              "--quiet"})),
                  0);
        EXPECT_EQ(run_value(root_ / name, "state_hash"), hash) << "stopped at step " << step << " of " << steps;
        fs::remove_all(root_ / name);
    }
}

}  // namespace

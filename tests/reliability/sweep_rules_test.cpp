// The make rules of a chapter's sweep (reproductions/chapter3/sweep.mk) on tiny travels: what fails stops no other,
// what is done is not repeated, what was stopped goes on, and a changed input repeats all. Tasks of an engine share
// beds and inputs. The same for trials (reproductions/speed_accuracy/trials.mk), where a run that a health check stops
// is done.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/scratch.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int code = 0;
    std::string text;
};

class Sweep : public ::testing::Test {
protected:
    /// Travels of so many metres; `bad` has a slip that is no number.
    void write_makefile(const std::string& runs, const std::string& distance_m) const {
        std::ofstream file(scratch.file("sweep.mk"));
        file << "CHAPTER := " << scratch.file("chapter") << "\nSWEEP := " << scratch.file("sweep.mk")
             << "\nOUT := " << scratch.file("runs") << "\nSTAGES := " << scratch.file("stages") << "\nRUNS := " << runs
             << "\nruns: sweep\ninclude " << IFEDEM_SOURCE_DIR << "/reproductions/chapter3/sweep.mk\n"
             << "C := $(CHAPTER)/cases/tiny.toml\nS := --set travel.distance_m=" << distance_m << "\n"
             << "$(eval $(call bed_rule,bed,$(C),$(S)))\n$(eval $(call sunk_rule,sunk,$(C),$(S),bed))\n"
             << "$(foreach r,a b,$(eval $(call travel_rule,$(r),$(C),$(S),sunk)))\n"
             << "$(eval $(call travel_rule,bad,$(C),$(S) --set travel.slip_percent=many,sunk))\n"
             << "travels: $(addprefix $(OUT)/,$(addsuffix /run.csv,$(RUNS)))\n";
    }
    /// Trials: `wild` has a step that a health check stops; `bad` as above.
    void write_trials(const std::string& runs, const std::string& distance_m) const {
        std::ofstream file(scratch.file("sweep.mk"));
        file << "CHAPTER := " << scratch.file("chapter") << "\nSWEEP := " << scratch.file("sweep.mk")
             << "\nOUT := " << scratch.file("runs") << "\nSTAGES := " << scratch.file("stages") << "\nRUNS := " << runs
             << "\nruns: sweep\ninclude " << IFEDEM_SOURCE_DIR << "/reproductions/chapter3/sweep.mk\ninclude "
             << IFEDEM_SOURCE_DIR << "/reproductions/speed_accuracy/trials.mk\n"
             << "C := $(CHAPTER)/cases/tiny.toml\nS_all := --set travel.distance_m=" << distance_m << "\n"
             << "S_a := $(S_all)\nS_wild := $(S_all) --set time_step_s=2.4e-4 --allow-unstable\n"
             << "S_bad := $(S_all) --set travel.slip_percent=many\n"
             << "$(foreach r,a wild bad,$(eval $(call try_prepare_rule,sunk-$(r),$(C),$(S_$(r)),,)))\n"
             << "$(foreach r,a wild bad,$(eval $(call trial_rule,$(r),$(C),$(S_$(r)),sunk-$(r))))\n"
             << "travels: $(addprefix $(OUT)/,$(addsuffix /ended,$(RUNS)))\n";
    }
    void write_case(const std::string& more) const {
        std::ofstream(scratch.file("chapter/cases/tiny.toml"))
            << "base = \"" << IFEDEM_SOURCE_DIR
            << "/reproductions/chapter3/cases/short.toml\"\n[bed]\ndisc_count = 1500\n"
            << "[stages]\nconsolidation_s = 0.2\nsinkage_s = 0.1\n[record]\ncheckpoint_interval_s = 0.02\n"
            << more;
    }
    void SetUp() override {
        fs::create_directories(scratch.file("chapter/cases"));
        std::ofstream(scratch.file("chapter/realisations.mk")) << "PHASE_1 := 0\n";
        write_case("");
    }
    [[nodiscard]] std::string command() const {
        return std::string("env -u MAKEFLAGS make --no-print-directory -f ") + scratch.file("sweep.mk") +
               " runs JOBS=1 IFEDEM=" + IFEDEM_PROGRAM + " 2>&1";
    }
    /// What an engine starts on another machine: the file of a run, with the inputs as they are.
    [[nodiscard]] std::string task(const std::string& run) const {
        return std::string("env -u MAKEFLAGS make --no-print-directory -f ") + scratch.file("sweep.mk") + " TASK=1 " +
               scratch.file("runs/" + run + "/run.csv") + " 2>&1";
    }
    [[nodiscard]] Outcome run_make() const { return run_shell(command()); }
    [[nodiscard]] static Outcome run_shell(const std::string& line) {
        Outcome outcome;
        FILE* pipe = popen(line.c_str(), "r");
        std::array<char, 4096> buffer{};
        while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) outcome.text += buffer.data();
        outcome.code = WEXITSTATUS(pclose(pipe));
        return outcome;
    }
    [[nodiscard]] auto finished(const std::string& run) const {
        return fs::last_write_time(scratch.file("runs/" + run + "/run.csv"));
    }

    [[nodiscard]] pid_t start_make() const {
        const pid_t make = fork();
        if (make == 0) {
            execl("/bin/sh", "sh", "-c", ("exec " + command() + " > " + scratch.file("make.log")).c_str(), nullptr);
            _exit(127);
        }
        return make;
    }
    /// Whether a process makes the bed, within ten seconds of `wanted`.
    [[nodiscard]] bool bed_is_being_made(bool wanted) const {
        const std::string lock = scratch.file("runs/ready/bed.lock");
        const auto is_held = [&] {
            return fs::exists(lock) && run_shell("flock --nonblock " + lock + " true").code != 0;
        };
        for (int k = 0; k < 1000 && is_held() != wanted; ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return is_held();
    }

    /// Stops make while run `a` travels 0.2 m.
    void stop() const {
        const pid_t make = start_make();
        // Stopped once the travel has a checkpoint.
        const std::string checkpoint = scratch.file("runs/a/checkpoint.h5");
        for (int k = 0;
             k < 6000 && !fs::exists(checkpoint) && kill(make, 0) == 0 && waitpid(make, nullptr, WNOHANG) == 0; ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ASSERT_TRUE(fs::exists(checkpoint)) << read_text(scratch.file("make.log"));
        kill(make, SIGTERM);
        int status = 0;
        waitpid(make, &status, 0);
        // The program may still be writing its last checkpoint when make is gone.
        const std::string log = scratch.file("runs/logs/a.log");
        for (int k = 0; k < 3000 && read_text(log).find("goes on from step") == std::string::npos; ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ASSERT_FALSE(fs::exists(scratch.file("runs/a/run.csv")));
    }

    /// The same, then goes on.
    void stop_and_go_on() const {
        ASSERT_NO_FATAL_FAILURE(stop());
        const auto begun = fs::last_write_time(scratch.file("runs/a/case.toml"));
        const Outcome second = run_make();
        ASSERT_EQ(second.code, 0) << second.text;
        EXPECT_EQ(fs::last_write_time(scratch.file("runs/a/case.toml")), begun);  // it did not begin anew
        const std::string facts = read_text(scratch.file("runs/a/run.csv"));
        const auto number = [&](const std::string& name) {
            const auto at = facts.find("\n" + name + ",");
            return std::stol(facts.substr(at + name.size() + 2));
        };
        EXPECT_EQ(number("steps"), number("total_steps") - 7500);  // both parts of the travel
    }

    Scratch scratch;
};

TEST_F(Sweep, AFailedRunStopsNoOtherAndDoneWorkIsNotRepeated) {
    write_makefile("a bad b", "0.01");
    const Outcome first = run_make();
    EXPECT_NE(first.code, 0);
    EXPECT_NE(first.text.find("failed: bad"), std::string::npos) << first.text;
    EXPECT_NE(first.text.find("slip_percent is a text"), std::string::npos) << first.text;
    EXPECT_EQ(first.text.find("failed: a"), std::string::npos) << first.text;
    ASSERT_TRUE(fs::exists(scratch.file("runs/a/run.csv")) && fs::exists(scratch.file("runs/b/run.csv"))) << first.text;

    const auto before = finished("b");
    fs::last_write_time(scratch.file("chapter/cases/tiny.toml"), fs::file_time_type::clock::now());  // same text
    write_makefile("a b", "0.01");
    EXPECT_EQ(run_make().code, 0);
    EXPECT_EQ(finished("b"), before);

    write_case("series_interval_s = 0.001\n");
    EXPECT_EQ(run_make().code, 0);
    EXPECT_GT(finished("b"), before);
}

TEST_F(Sweep, WhatWasStoppedGoesOnFromItsCheckpoint) {
    write_makefile("a", "0.2");
    stop_and_go_on();
}

TEST_F(Sweep, WhatHasADamagedCheckpointBeginsAnew) {
    write_makefile("a", "0.2");
    ASSERT_NO_FATAL_FAILURE(stop());
    fs::resize_file(scratch.file("runs/a/checkpoint.h5"), 1000);
    const Outcome second = run_make();
    EXPECT_EQ(second.code, 0) << second.text;
    EXPECT_TRUE(fs::exists(scratch.file("runs/a/run.csv")));
    const std::string log = read_text(scratch.file("runs/logs/a.log"));
    EXPECT_NE(log.find("The run begins anew."), std::string::npos) << log;
}

TEST_F(Sweep, StoppingMakeStopsTheBedToo) {
    write_makefile("a", "0.01 --set stages.consolidation_s=1000");
    const pid_t make = start_make();
    ASSERT_TRUE(bed_is_being_made(true)) << read_text(scratch.file("make.log"));
    kill(make, SIGTERM);
    waitpid(make, nullptr, 0);
    EXPECT_FALSE(bed_is_being_made(false));
}

TEST_F(Sweep, TasksThatNeedTheSameBedMakeItOnce) {
    write_makefile("a b", "0.01");
    // A program that keeps what the rules drop: how many steps each `prepare` made.
    std::ofstream(scratch.file("program")) << "#!/bin/sh\n"
                                           << IFEDEM_PROGRAM << " \"$@\" | tee -a " << scratch.file("said") << "\n";
    fs::permissions(scratch.file("program"), fs::perms::owner_all);
    const std::string with = " IFEDEM=" + scratch.file("program");
    const Outcome both = run_shell("env -u MAKEFLAGS make -s -f " + scratch.file("sweep.mk") + with + " " +
                                   scratch.file("runs/inputs.txt") + "; " + task("a") + with + " & " + task("b") +
                                   with + "; first=$?; wait $! && exit $first");
    ASSERT_EQ(both.code, 0) << both.text;
    std::istringstream said(read_text(scratch.file("said")));
    std::vector<long> steps;
    for (std::string line; std::getline(said, line);)
        if (const auto at = line.find("steps="); line.starts_with("performance"))
            steps.push_back(std::stol(line.substr(at + 6)));
    // Two beds and two sunk wheels asked for, one of each made, and two travels.
    std::sort(steps.begin(), steps.end());
    ASSERT_EQ(steps.size(), 6U);
    EXPECT_EQ(steps[1], 0);
    EXPECT_GT(steps[2], 0);
    const auto hash = [&](const std::string& run) {
        const std::string facts = read_text(scratch.file("runs/" + run + "/run.csv"));
        return facts.substr(facts.find("state_hash"), 30);
    };
    EXPECT_EQ(hash("a"), hash("b"));
}

TEST_F(Sweep, ATaskWithOtherInputsIsRefused) {
    write_makefile("a", "0.01");
    const std::string with = std::string(" IFEDEM=") + IFEDEM_PROGRAM, inputs = scratch.file("runs/inputs.txt");
    ASSERT_EQ(run_shell("env -u MAKEFLAGS make -s -f " + scratch.file("sweep.mk") + with + " " + inputs).code, 0);
    const std::string before = read_text(inputs);
    write_case("series_interval_s = 0.001\n");
    const Outcome refused = run_shell(task("a") + with);
    EXPECT_NE(refused.code, 0);
    EXPECT_NE(refused.text.find("does not fit"), std::string::npos) << refused.text;
    EXPECT_EQ(read_text(inputs), before);
    EXPECT_FALSE(fs::exists(scratch.file("runs/a")));
}

TEST_F(Sweep, AnEngineThatCannotBeUsedIsRefused) {
    write_makefile("a", "0.01");
    const auto refusal = [&](const std::string& arguments) {
        const Outcome outcome = run_shell(command() + " " + arguments);
        EXPECT_NE(outcome.code, 0);
        return outcome.text;
    };
    EXPECT_NE(refusal("ENGINE=steam").find("ENGINE=steam is not known"), std::string::npos);
    const std::string parallel = refusal("ENGINE=parallel HOSTS=nowhere");
    EXPECT_TRUE(parallel.find("HOSTS=nowhere is no file") != std::string::npos ||
                parallel.find("GNU parallel is not found") != std::string::npos)
        << parallel;
    EXPECT_FALSE(fs::exists(scratch.file("runs/a")));
}

TEST_F(Sweep, ATrialThatWasStoppedGoesOnFromItsCheckpoint) {
    write_trials("a", "0.2");
    stop_and_go_on();
}

TEST_F(Sweep, ATrialThatAHealthCheckStopsIsDone) {
    write_trials("wild bad a", "0.01");
    const Outcome first = run_make();
    EXPECT_NE(first.code, 0);
    EXPECT_NE(first.text.find("failed: bad"), std::string::npos) << first.text;
    EXPECT_EQ(first.text.find("failed: wild"), std::string::npos) << first.text;
    EXPECT_TRUE(fs::exists(scratch.file("runs/a/run.csv"))) << first.text;
    ASSERT_TRUE(fs::exists(scratch.file("runs/wild/stopped.txt"))) << first.text;
    EXPECT_FALSE(fs::exists(scratch.file("runs/wild/run.csv")));
    EXPECT_EQ(read_text(scratch.file("runs/wild/stopped.txt")).find("stopped at step"), 0U);

    const auto before = fs::last_write_time(scratch.file("runs/wild/ended"));
    write_trials("wild a", "0.01");
    EXPECT_EQ(run_make().code, 0);
    EXPECT_EQ(fs::last_write_time(scratch.file("runs/wild/ended")), before);
}

}  // namespace
}  // namespace ifedem

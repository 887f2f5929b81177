// What happens to a run from outside, through the program itself: it is killed, asked to stop, its files are damaged,
// there is no space, somebody else is in its directory.
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/random.hpp"
#include "model/case.hpp"
#include "record/checkpoint.hpp"
#include "record/frame_file.hpp"
#include "reliability/tally.hpp"
#include "support/program.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

const std::string tiny_case = std::string(IFEDEM_SOURCE_DIR) + "/tests/reliability/tiny.toml";

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }
void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }
double draw_share(Random& random) { return static_cast<double>(random.below(1'000'000)) / 1e6; }

/// A directory of runs, each with a stage cache of its own, so that every run goes through all stages.
class Runs {
public:
    [[nodiscard]] std::string directory(const std::string& name) const { return scratch_.file(name); }
    [[nodiscard]] std::string log(const std::string& name) const { return scratch_.file(name + ".log"); }
    [[nodiscard]] std::vector<std::string> run_arguments(const std::string& name) const {
        return {"run", tiny_case, "-o", directory(name), "--stages", directory(name) + "-stages", "--quiet"};
    }
    [[nodiscard]] std::vector<std::string> resume_arguments(const std::string& name) const {
        return {"resume", directory(name), "--stages", directory(name) + "-stages", "--quiet"};
    }
    [[nodiscard]] Program start(const std::string& name) const { return {run_arguments(name), log(name)}; }
    [[nodiscard]] Program resume(const std::string& name) const { return {resume_arguments(name), log(name)}; }
    void remove(const std::string& name) const {
        fs::remove_all(directory(name));
        fs::remove_all(directory(name) + "-stages");
    }

    /// What is wrong with a run that should have ended like an undisturbed one.
    [[nodiscard]] std::string end_fault(const std::string& name, const std::string& whole) const {
        if (run_value(directory(name), "state_hash") != run_value(directory(whole), "state_hash")) return "other hash";
        for (const char* file : {"series.csv", "results.h5", "discs.xdmf", "wheel.xdmf", "case.toml", "snapshot.png"}) {
            if (read_text(directory(name) + "/" + file) != read_text(directory(whole) + "/" + file))
                return std::string("other ") + file;
        }
        if (fs::exists(directory(name) + "/lock")) return "lock left";
        return "";
    }

    /// What is wrong with the files that a stopped run left: all can be read, at most one frame is missing.
    [[nodiscard]] std::string file_fault(const std::string& name) const {
        const std::string dir = directory(name);
        try {
            if (fs::exists(dir + "/checkpoint.h5")) (void)read_checkpoint(dir + "/checkpoint.h5");
            if (!fs::exists(dir + "/results.h5")) return "";
            const FrameReader reader(dir + "/results.h5");
            for (std::uint64_t k = 0; k < reader.frames().size(); ++k) (void)reader.read(k);
            if (reader.frames().size() + 1 < frames_due(dir)) return "more than one frame lost";
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

private:
    /// Frames that a run has come past, by the last whole line of its series; a line comes before its frame.
    static std::uint64_t frames_due(const std::string& directory) {
        std::istringstream lines(read_text(directory + "/series.csv"));
        std::string line, last;
        while (std::getline(lines, line) && !lines.eof()) last = line;
        if (last.empty() || last.starts_with("time_s")) return 0;
        const double interval_s = read_case(directory + "/case.toml").record.frame_interval_s;
        return 1 + static_cast<std::uint64_t>(std::stod(last) / interval_s * (1 + 1e-9));
    }

    Scratch scratch_;
};

/// An undisturbed run, and how long one takes.
class Faults : public testing::Test {
protected:
    void SetUp() override {
        const Clock::time_point begin = Clock::now();
        ASSERT_EQ(runs.start("whole").wait().status, 0);
        duration_s = seconds_since(begin);
    }

    /// After whatever happened to run `name`: it can be gone on with and ends like the whole one.
    [[nodiscard]] std::string resume_fault(const std::string& name) const {
        // Nothing can be resumed before there is a case; then the same command works again.
        const bool begun = fs::exists(runs.directory(name) + "/case.toml");
        const ProgramEnd end = (begun ? runs.resume(name) : runs.start(name)).wait();
        if (end.status != 0 || end.errors.find("begins anew") != std::string::npos)
            return "exit " + std::to_string(end.status) + ": " + end.errors;
        return runs.end_fault(name, "whole");
    }

    /// A whole run without its pictures: the command that its note names draws them, and it ends like the whole one.
    [[nodiscard]] std::string lost_picture_fault(const std::string& name) const {
        const std::string directory = runs.directory(name);
        if (fs::exists(directory + "/checkpoint.h5")) return "checkpoint left";
        const ProgramEnd end = Program({"picture", directory, "-o", directory}, runs.log(name)).wait();
        if (end.status != 0) return "exit " + std::to_string(end.status) + ": " + end.errors;
        return runs.end_fault(name, "whole");
    }

    Runs runs;
    double duration_s = 0;
};

TEST_F(Faults, KilledAtRandomMoments) {
    FaultTally tally("SIGKILL at a random moment, then resume");
    Random random{1};
    const int wanted = trials(100, 6);
    for (int tries = 0; tally.tried() < wanted && tries < 20 * wanted; ++tries) {
        const Program program = runs.start("killed");
        sleep_s(draw_share(random) * duration_s);
        program.send(SIGKILL);
        bool killed = program.wait().by_signal;
        std::string trouble = runs.file_fault("killed");
        if (killed && tries % 2 == 0 && fs::exists(runs.directory("killed/case.toml"))) {  // every other one twice
            const Program again = runs.resume("killed");
            sleep_s(draw_share(random) * duration_s);
            again.send(SIGKILL);
            (void)again.wait();
            trouble += runs.file_fault("killed");
        }
        if (killed) tally.count(trouble + resume_fault("killed"));
        runs.remove("killed");
    }
    EXPECT_EQ(tally.tried(), wanted) << "most runs ended before they were killed: nothing was tested";
}

TEST_F(Faults, AskedToStopAtRandomMoments) {
    FaultTally tally("SIGTERM or SIGINT: checkpoint within a second and exit 143 or 130, then resume");
    Random random{2};
    const int wanted = trials(50, 4);
    for (int tries = 0; tally.tried() < wanted && tries < 20 * wanted; ++tries) {
        const int signal = tally.tried() % 2 == 0 ? SIGTERM : SIGINT;
        const Program program = runs.start("stopped");
        sleep_s(draw_share(random) * duration_s);
        const Clock::time_point begin = Clock::now();
        program.send(signal);
        const ProgramEnd outcome = program.wait();
        if (outcome.status != 0) {  // else it was past its last step
            std::string trouble = runs.file_fault("stopped");
            if (seconds_since(begin) > 1) trouble += "took longer than a second; ";
            if (outcome.status != 128 + signal) trouble += "exit " + std::to_string(outcome.status) + "; ";
            // The few milliseconds before the program listens end it without a word, and without a step made.
            if (!outcome.by_signal && !fs::exists(runs.directory("stopped/checkpoint.h5")))
                trouble += "no checkpoint; ";
            tally.count(trouble + resume_fault("stopped"));
        }
        runs.remove("stopped");
    }
    EXPECT_EQ(tally.tried(), wanted) << "most runs ended before they were stopped: nothing was tested";
}

TEST_F(Faults, AResumedRunCostsWhatAllItsPartsDo) {
    std::vector<std::string> arguments = runs.run_arguments("part");
    arguments.insert(arguments.end(), {"--stop-at-step", "10800"});
    ASSERT_EQ(Program(arguments, runs.log("part")).wait().status, 0);
    const Spent first = read_checkpoint(runs.directory("part/checkpoint.h5")).spent;
    EXPECT_EQ(first.steps, 10800U);
    EXPECT_GT(first.cpu_s, 0);
    EXPECT_GT(first.wall_s, 0);
    ASSERT_EQ(runs.resume("part").wait().status, 0);
    EXPECT_EQ(run_value(runs.directory("part"), "steps"), run_value(runs.directory("whole"), "steps"));
    constexpr double rounding_s = 0.005;  // run.csv has hundredths
    EXPECT_GE(std::stod(run_value(runs.directory("part"), "cpu_s")), first.cpu_s - rounding_s);
    EXPECT_GE(std::stod(run_value(runs.directory("part"), "wall_s")), first.wall_s - rounding_s);
}

// ---- damaged files -------------------------------------------------------------------------------------------------

void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::string read_all_frames(const std::string& path) {
    const FrameReader reader(path);
    std::string all = reader.header().case_text;
    for (std::uint64_t k = 0; k < reader.frames().size(); ++k) {
        const Frame frame = reader.read(k);
        for_each_column(frame, [&](const char*, const char*, Extent, const auto& member) {
            if constexpr (requires { member.data(); })
                all.append(reinterpret_cast<const char*>(member.data()), member.size() * sizeof(member[0]));
            else
                all.append(reinterpret_cast<const char*>(&member), sizeof member);
        });
    }
    return all;
}

std::string read_checkpoint_hash(const std::string& path) { return to_hex(hash_state(read_checkpoint(path).state)); }

enum class Allowed { nothing, same_data };

/// Flips one bit after another in a copy of the file. `allowed`: whether it may be read if what is read is right.
template <class Read>
void flip_bits(FaultTally& tally, const std::string& path, int times, Allowed allowed, const Read& read,
               Random& random) {
    const std::string good = read_text(path), expected = read(path);
    for (int n = 0; n < times; ++n) {
        std::string bytes = good;
        char& byte = bytes[random.below(bytes.size())];
        byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << random.below(8)));
        write_text(path, bytes);
        std::string trouble = "accepted";
        try {
            if (read(path) == expected && allowed == Allowed::same_data) trouble = "";
        } catch (const Error& error) {
            trouble = error.code() == ExitCode::io ? "" : "wrong exit code";
        }
        tally.count(trouble);
    }
    write_text(path, good);
}

TEST_F(Faults, FlippedBits) {
    Random random{3};
    const std::string whole = runs.directory("whole/results.h5");
    {
        FaultTally tally("one bit flipped in a finished results.h5");
        flip_bits(tally, whole, trials(400, 100), Allowed::nothing, read_all_frames, random);
    }
    std::vector<std::string> arguments = runs.run_arguments("part");
    arguments.insert(arguments.end(), {"--stop-at-step", "10800"});
    ASSERT_EQ(Program(arguments, runs.log("part")).wait().status, 0);
    {
        FaultTally tally("one bit flipped in a checkpoint");
        flip_bits(tally, runs.directory("part/checkpoint.h5"), trials(300, 50), Allowed::nothing, read_checkpoint_hash,
                  random);
    }
    FaultTally tally("one bit flipped in an unfinished results.h5 (refused or beside the data)");
    flip_bits(tally, runs.directory("part/results.h5"), trials(300, 50), Allowed::same_data, read_all_frames, random);
}

TEST_F(Faults, FilesCutOff) {
    FaultTally tally("results.h5 cut off at a random place");
    Random random{4};
    const std::string path = runs.directory("whole/results.h5"), good = read_text(path);
    for (int n = 0; n < trials(100, 20); ++n) {
        write_text(path, good.substr(0, random.below(good.size())));
        std::string trouble = "accepted";
        try {
            (void)read_all_frames(path);
        } catch (const Error& error) {
            trouble = error.code() == ExitCode::io ? "" : "wrong exit code";
        }
        tally.count(trouble);
    }
}

TEST_F(Faults, ADamagedStageIsSimulatedAnew) {
    for (const auto& entry : fs::recursive_directory_iterator(runs.directory("whole-stages"))) {
        if (entry.path().filename() == "checkpoint.h5") fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
    }
    fs::rename(runs.directory("whole-stages"), runs.directory("again-stages"));
    const ProgramEnd outcome = runs.start("again").wait();
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.errors.find("The stage is simulated anew."), std::string::npos) << outcome.errors;
    EXPECT_EQ(runs.end_fault("again", "whole"), "");
}

TEST_F(Faults, ADamagedRunBeginsAnew) {
    for (const std::string file : {"checkpoint.h5", "results.h5"}) {
        std::vector<std::string> arguments = runs.run_arguments("part");
        arguments.insert(arguments.end(), {"--stop-at-step", "10800"});
        ASSERT_EQ(Program(arguments, runs.log("part")).wait().status, 0);
        fs::resize_file(runs.directory("part/" + file), fs::file_size(runs.directory("part/" + file)) - 1);
        const ProgramEnd outcome = runs.resume("part").wait();
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_NE(outcome.errors.find(file), std::string::npos) << outcome.errors;
        EXPECT_NE(outcome.errors.find("The run begins anew."), std::string::npos) << outcome.errors;
        EXPECT_EQ(runs.end_fault("part", "whole"), "");
        runs.remove("part");
    }
}

TEST_F(Faults, ACacheThatCannotBeWrittenCostsOnlyTime) {
    write_text(runs.directory("part-stages"), "no directory");
    const ProgramEnd outcome = runs.start("part").wait();
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.errors.find("The consolidation is not kept for other runs."), std::string::npos)
        << outcome.errors;
    EXPECT_EQ(runs.end_fault("part", "whole"), "");
}

// A run that goes on with one case under the name of another would be taken for the other's.
TEST_F(Faults, AChangedCaseIsNotTakenUp) {
    std::vector<std::string> arguments = runs.run_arguments("part");
    arguments.insert(arguments.end(), {"--stop-at-step", "10800"});
    ASSERT_EQ(Program(arguments, runs.log("part")).wait().status, 0);
    const std::string path = runs.directory("part/case.toml"), own = read_text(path);
    const auto at = own.find("slip_percent = ");
    ASSERT_NE(at, std::string::npos);
    std::string changed = own;
    write_text(path, changed.insert(at + 15, "-"));
    const ProgramEnd outcome = runs.resume("part").wait();
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("travel.slip_percent is not what the run was begun with"), std::string::npos)
        << outcome.errors;
    write_text(path, own);
    EXPECT_EQ(resume_fault("part"), "");
}

// It would go by unseen, and the run to its end.
TEST_F(Faults, AStopBeforeTheCachedStagesIsRefused) {
    const auto stop_at = [&](const char* step) {
        std::vector<std::string> arguments = runs.run_arguments("part");
        arguments.insert(arguments.end(), {"--stop-at-step", step});
        return Program(arguments, runs.log("part")).wait();
    };
    ASSERT_EQ(stop_at("10800").status, 0);
    fs::remove_all(runs.directory("part"));  // not its stages
    const ProgramEnd outcome = stop_at("2000");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("--stop-at-step 2000 has passed (the run begins at step 10000"), std::string::npos)
        << outcome.errors;
    EXPECT_EQ(resume_fault("part"), "");
}

// ---- no space ------------------------------------------------------------------------------------------------------

/// The run `name` met a full disk. What is wrong with how it took it?
std::string full_disk_fault(const Runs& runs, const std::string& name, const ProgramEnd& outcome,
                            const std::string& reason) {
    if (outcome.status != 4) return "exit " + std::to_string(outcome.status) + ": " + outcome.errors;
    if (outcome.errors.find(reason) == std::string::npos) return "unclear message: " + outcome.errors;
    return runs.file_fault(name);
}

/// The run is whole, but gnuplot is missing or could not write.
bool lacks_picture(const ProgramEnd& outcome) {
    return outcome.status == 0 && outcome.errors.find("`ifedem picture") != std::string::npos;
}

TEST_F(Faults, GnuplotIsMissing) {
    const auto prepare = [] { setenv("PATH", "/none", 1); };
    const ProgramEnd outcome = Program(runs.run_arguments("plain"), runs.log("plain"), prepare).wait();
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_TRUE(lacks_picture(outcome)) << outcome.errors;
    EXPECT_FALSE(fs::exists(runs.directory("plain/snapshot.png")));
    EXPECT_EQ(lost_picture_fault("plain"), "");
}

/// Without privileges: no file may grow past a limit, which write(2) reports like a full disk.
TEST_F(Faults, NoFileMayGrow) {
    FaultTally tally("file size limit reached at a random place, then resume");
    Random random{5};
    const int wanted = trials(20, 4);
    for (int tries = 0; tally.tried() < wanted && tries < 20 * wanted; ++tries) {
        const rlim_t limit = 100 + random.below(fs::file_size(runs.directory("whole/results.h5")) + 20'000);
        const auto prepare = [limit] {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit both{limit, limit};
            setrlimit(RLIMIT_FSIZE, &both);
        };
        const ProgramEnd outcome = Program(runs.run_arguments("full"), runs.log("full"), prepare).wait();
        if (lacks_picture(outcome)) tally.count(lost_picture_fault("full"));
        if (outcome.status != 0) tally.count(full_disk_fault(runs, "full", outcome, "File too") + resume_fault("full"));
        runs.remove("full");
    }
    EXPECT_EQ(tally.tried(), wanted);
}

/// A file system in memory with a size of its own, at the place where a run is to go.
class SmallDisk {
public:
    explicit SmallDisk(std::string path) : path_(std::move(path)) { fs::create_directories(path_); }
    ~SmallDisk() {
        if (mounted_) umount2(path_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    bool set_size(std::uint64_t bytes) {
        const std::string options = "size=" + std::to_string(bytes);
        const unsigned long flags = mounted_ ? MS_REMOUNT : 0;
        const bool done = mount("tmpfs", path_.c_str(), "tmpfs", flags, options.c_str()) == 0;
        mounted_ = mounted_ || done;
        return done;
    }

private:
    std::string path_;
    bool mounted_ = false;
};

TEST_F(Faults, PrivilegedFullDisk) {
    if (!SmallDisk(runs.directory("try")).set_size(4096))
        GTEST_SKIP() << "not run: mounting a file system needs privileges";
    FaultTally tally("disk full at a random point, then resume with space");
    Random random{6};
    const int wanted = trials(20, 20);
    constexpr std::uint64_t page = 4096, most = 900'000;
    for (int tries = 0; tally.tried() < wanted && tries < 20 * wanted; ++tries) {
        SmallDisk disk(runs.directory("full"));
        ASSERT_TRUE(disk.set_size(page * (2 + random.below(most / page))));
        const ProgramEnd outcome = runs.start("full").wait();
        if (outcome.status != 0 || lacks_picture(outcome)) {
            std::string trouble;
            if (outcome.status != 0) trouble = full_disk_fault(runs, "full", outcome, "No space left");
            ASSERT_TRUE(disk.set_size(100 * most));
            tally.count(trouble + (outcome.status != 0 ? resume_fault("full") : lost_picture_fault("full")));
        }
        fs::remove_all(runs.directory("full-stages"));
    }
    EXPECT_EQ(tally.tried(), wanted);
}

// ---- places --------------------------------------------------------------------------------------------------------

TEST_F(Faults, TwoRunsIntoOneDirectory) {
    FaultTally tally("two runs into one directory");
    for (int n = 0; n < trials(10, 2); ++n) {
        const Program first = runs.start("shared");
        while (!fs::exists(runs.directory("shared/case.toml"))) sleep_s(1e-3);
        std::vector<std::string> forced = runs.run_arguments("shared");
        forced.emplace_back("--force");
        const ProgramEnd second = Program(forced, runs.log("second")).wait();
        const ProgramEnd third = Program(runs.resume_arguments("shared"), runs.log("third")).wait();
        std::string trouble;
        if (second.status != 2 || second.errors.find("is in use") == std::string::npos)
            trouble += "run: " + std::to_string(second.status) + " " + second.errors;
        if (third.status != 2 || third.errors.find("is in use") == std::string::npos)
            trouble += "resume: " + std::to_string(third.status) + " " + third.errors;
        if (first.wait().status != 0) trouble += "the first run was disturbed";
        tally.count(trouble + runs.end_fault("shared", "whole"));
        runs.remove("shared");
    }
}

/// As a user who may not write there; the super-user may write everywhere.
void drop_privileges() {
    constexpr uid_t nobody = 65534;
    if (getuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0)) _exit(126);
}

TEST_F(Faults, PlacesThatCannotBeWritten) {
    FaultTally tally("read-only directory, file or missing parent as output");
    Scratch scratch;
    fs::create_directory(scratch.file("read-only"));
    fs::permissions(scratch.path, fs::perms::others_exec | fs::perms::owner_all);
    fs::permissions(scratch.file("read-only"), fs::perms::owner_read | fs::perms::owner_exec);
    write_text(scratch.file("file"), "text");
    for (const std::string name : {"read-only/run", "read-only", "file", "file/run", "/proc/none/run"}) {
        const std::string place = name.starts_with("/") ? name : scratch.file(name);
        const ProgramEnd outcome =
            Program({"run", tiny_case, "-o", place, "--quiet", "--stages", scratch.file("stages")}, scratch.file("log"),
                    drop_privileges)
                .wait();
        const bool clear = (outcome.status == 2 || outcome.status == 4) && outcome.errors.find(name) < 200 &&
                           std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1;
        tally.count(clear ? "" : name + ": exit " + std::to_string(outcome.status) + ", " + outcome.errors);
    }
    EXPECT_EQ(read_text(scratch.file("file")), "text");
}

TEST_F(Faults, PathsThatNeedQuotes) {
    FaultTally tally("path with spaces, quotes and other letters");
    for (const std::string name : {"with spaces", "it's \"quoted\"", "$(echo dollar) `x` ; &", "京都 Räder", "-o"}) {
        const ProgramEnd outcome = runs.start(name).wait();
        tally.count(outcome.status == 0 ? runs.end_fault(name, "whole") : name + ": " + outcome.errors);
    }
}

TEST_F(Faults, ForceEmptiesOnlyRuns) {
    fs::create_directory(runs.directory("home"));
    write_text(runs.directory("home/thesis.txt"), "text");
    std::vector<std::string> forced = runs.run_arguments("home");
    forced.emplace_back("--force");
    const ProgramEnd outcome = Program(forced, runs.log("home")).wait();
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("holds no run"), std::string::npos) << outcome.errors;
    EXPECT_EQ(read_text(runs.directory("home/thesis.txt")), "text");
    forced[3] = runs.directory("whole");
    EXPECT_EQ(Program(forced, runs.log("home")).wait().status, 0);
}

}  // namespace
}  // namespace ifedem

#include "record/results.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "record/frame_file.hpp"
#include "record/snapshot.hpp"
#include "support/scratch.hpp"

/// HDF5 1.10 keeps the memory of a file that it cannot close because the disk is full.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }  // NOLINT: the sanitizer's name

namespace ifedem {
namespace {

constexpr double step_s = 0.25;

Case small_case() {
    Case c;
    c.time_step_s = step_s;
    c.record.series_interval_s = c.record.frame_interval_s = c.record.checkpoint_interval_s = step_s;
    c.record.energy_interval_s = step_s;
    c.bed.disc_count = 50;
    return c;
}

WheelMesh two_quads() {
    WheelMesh wheel;
    wheel.mesh.node_m = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
    wheel.mesh.quad = {{0, 1, 4, 3}, {1, 2, 5, 4}};
    wheel.mesh.part = {Part::rim, Part::lug};
    return wheel;
}

/// A state whose every recorded number follows from its step, so that a reader can tell what it should find. The list
/// is in falling order of ids; the wheel is there from the second stage on.
State state_at(std::uint64_t total, std::size_t discs = 50) {
    State state;
    state.progress =
        total < 40 ? Progress{Stage::consolidation, total, total} : Progress{Stage::sinkage, total - 40, total};
    for (std::size_t k = discs; k-- > 0;) {
        Disc disc;
        disc.x_m = static_cast<double>(total) + 1e-3 * static_cast<double>(k);
        disc.y_m = -disc.x_m;
        disc.radius_m = 0.125 * static_cast<double>(k + 1);
        state.discs.disc.push_back(disc);
        state.discs.id.push_back(static_cast<std::uint32_t>(k));
    }
    if (total >= 40) {
        for (const Vec2 node : two_quads().mesh.node_m)
            state.wheel.position_m.push_back(node + Vec2{static_cast<double>(total), 0});
    }
    state.wheel.rim.position_m = {static_cast<double>(total), 1};
    state.wheel.rim.angle_rad = 0.5 * static_cast<double>(total);
    return state;
}

Frame frame_at(std::uint64_t total, std::size_t discs = 50) {
    const State state = state_at(total, discs);
    FrameFields fields;
    for (const std::uint32_t id : state.discs.id) {
        fields.disc_speed_m_s.push_back(static_cast<float>(id + total));
        fields.disc_pressure_Pa.push_back(static_cast<float>(id * total));
    }
    return make_frame(state, static_cast<double>(state.progress.step) * step_s, fields);
}

/// What a frame must hold after reading, from the definition of state_at and not by way of the writer. "" if it does.
std::string fault_of(const Frame& frame, std::uint64_t total, std::size_t discs = 50) {
    const auto t = static_cast<double>(total);
    if (frame.progress.total_steps != total || frame.disc_id.size() != discs) return "wrong frame or number of discs";
    if (frame.progress.stage != (total < 40 ? Stage::consolidation : Stage::sinkage)) return "stage";
    if (frame.time_s != step_s * static_cast<double>(total < 40 ? total : total - 40)) return "time";
    for (std::size_t k = 0; k < discs; ++k) {
        const auto id = static_cast<double>(k);
        const bool same = frame.disc_id[k] == k && frame.disc_position_m[k].x == t + 1e-3 * id &&
                          frame.disc_position_m[k].y == -(t + 1e-3 * id) &&
                          frame.disc_radius_m[k] == static_cast<float>(0.125 * (id + 1)) &&
                          frame.disc_speed_m_s[k] == static_cast<float>(k + total) &&
                          frame.disc_pressure_Pa[k] == static_cast<float>(k * total);
        if (!same) return "disc " + std::to_string(k);
    }
    if (frame.wheel_position_m.size() != (total < 40 ? 0U : 6U)) return "number of nodes";
    for (std::size_t k = 0; k < frame.wheel_position_m.size(); ++k) {
        const Vec2 expected = two_quads().mesh.node_m[k] + Vec2{t, 0};
        if (frame.wheel_position_m[k].x != expected.x || frame.wheel_position_m[k].y != expected.y) return "node";
    }
    return frame.hub_position_m.x == t && frame.hub_angle_rad == 0.5 * t ? "" : "hub";
}

SeriesRow row_at(std::uint64_t total) {
    SeriesRow row;
    row.stage = total < 40 ? Stage::consolidation : Stage::sinkage;
    row.time_s = step_s * static_cast<double>(total < 40 ? total : total - 40);
    row.wheel_x_m = 0.1 * static_cast<double>(total);
    row.torque_Nm = 1.0 / static_cast<double>(total + 3);
    return row;
}

/// A run that records each step from `first` to `last` and makes a "checkpoint" (a flush) after the last.
void record_steps(Recorder& recorder, std::uint64_t first, std::uint64_t last) {
    for (std::uint64_t total = first; total <= last; ++total) {
        recorder.add_series(row_at(total));
        if (total % 2 == 0) recorder.add_frame(frame_at(total));
    }
    recorder.flush();
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t result = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
    return result;
}

TEST(Series, HasTheContractsColumns) {
    const Scratch scratch;
    Recorder recorder(scratch.file("run"), small_case(), two_quads());
    SeriesRow row;
    row.time_s = 0.002;
    row.stage = Stage::travel;
    row.wheel_x_m = 1;
    row.sinkage_m = -0.03;
    row.slip = 0.6;
    row.effective_radius_m = 0.15;
    row.vertical_force_N = 170;
    row.gross_tractive_effort_N = 90;
    row.drawbar_pull_N = 40.5;
    row.net_traction_N = 41;
    row.motion_resistance_N = -49;
    row.torque_Nm = 1e-9;
    recorder.add_series(row);
    const std::string text = read_text(scratch.file("run/series.csv"));
    const std::size_t second = text.find('\n') + 1;
    EXPECT_TRUE(
        text.starts_with("time_s,stage,wheel_x_m,sinkage_m,slip,effective_radius_m,vertical_force_N,"
                         "gross_tractive_effort_N,drawbar_pull_N,net_traction_N,motion_resistance_N,torque_Nm"))
        << text;
    EXPECT_TRUE(text.substr(second).starts_with("0.002,travel,1,-0.03,0.6,0.15,170,90,40.5,41,-49,1e-09")) << text;
    EXPECT_EQ(count(text.substr(0, second), ","), count(text.substr(second), ",")) << "names and values";
    EXPECT_EQ(read_text(scratch.file("run/case.toml")), to_toml(small_case()));
}

TEST(Frames, ReadBackWhileTheRunGoesOn) {
    const Scratch scratch;
    const std::string path = scratch.file("run/results.h5");
    Recorder recorder(scratch.file("run"), small_case(), two_quads());
    EXPECT_TRUE(FrameReader(path).frames().empty());
    for (std::uint64_t k = 0; k < 70; ++k) {  // past two enlargements of the file
        recorder.add_frame(frame_at(k));
        ASSERT_EQ(FrameReader(path).frames().size(), k + 1);
    }
    const FrameReader during(path);
    for (std::uint64_t k = 0; k < 70; ++k) EXPECT_EQ(fault_of(during.read(k), k), "") << "frame " << k;
    EXPECT_THROW((void)during.read(70), Error);
    recorder.finish();
    const FrameReader after(path);
    for (std::uint64_t k = 0; k < 70; ++k) EXPECT_EQ(fault_of(after.read(k), k), "") << "frame " << k;
    EXPECT_EQ(FrameReader(path).header().case_text, to_toml(small_case()));
    EXPECT_EQ(FrameReader(path).header().mesh.quad, two_quads().mesh.quad);
}

TEST(Frames, TakeAChangingNumberOfDiscs) {
    const Scratch scratch;
    const std::vector<std::size_t> counts = {50, 20, 0, 51, 200, 3};
    Recorder recorder(scratch.file("run"), small_case(), two_quads());
    for (std::size_t k = 0; k < counts.size(); ++k) recorder.add_frame(frame_at(k, counts[k]));
    for (std::size_t k = 0; k < counts.size(); ++k) {
        EXPECT_EQ(fault_of(FrameReader(scratch.file("run/results.h5")).read(k), k, counts[k]), "") << k;
    }
}

TEST(Frames, RefuseFieldsOfAnotherLength) {
    FrameFields fields;
    fields.disc_speed_m_s.resize(49);
    fields.disc_pressure_Pa.resize(50);
    EXPECT_THROW((void)make_frame(state_at(1), 0, fields), Error);
}

TEST(Resume, EndsWithTheFilesOfAnUninterruptedRun) {
    const Scratch scratch;
    {
        Recorder recorder(scratch.file("whole"), small_case(), two_quads());
        record_steps(recorder, 0, 79);
        recorder.finish();
    }
    // Checkpoints within a stage, at the first step of one, and a run that got far beyond its checkpoint.
    for (const std::uint64_t checkpoint : {std::uint64_t{10}, std::uint64_t{40}, std::uint64_t{61}}) {
        const std::string run = scratch.file("run" + std::to_string(checkpoint));
        {
            Recorder recorder(run, small_case(), two_quads());
            record_steps(recorder, 0, checkpoint);
            record_steps(recorder, checkpoint + 1, 72);
        }
        std::ofstream(run + "/series.csv", std::ios::app) << "8.25,sink";  // a torn line
        {
            Recorder recorder(run, small_case(), two_quads(), state_at(checkpoint).progress);
            record_steps(recorder, checkpoint + 1, 79);
            recorder.finish();
        }
        for (const char* name : {"series.csv", "results.h5", "discs.xdmf", "wheel.xdmf", "case.toml"}) {
            EXPECT_TRUE(read_text(run + "/" + name) == read_text(scratch.file("whole/") + name))
                << name << " after checkpoint " << checkpoint;
        }
    }
}

TEST(Resume, RefusesForeignAndMissingFiles) {
    const Scratch scratch;
    const std::string run = scratch.file("run");
    const auto resume = [&](const Case& c) {
        Recorder recorder(run, c, two_quads(), Progress{Stage::consolidation, 5, 5});
    };
    EXPECT_THROW(resume(small_case()), Error);  // nothing there
    { Recorder recorder(run, small_case(), two_quads()); }
    EXPECT_NO_THROW(resume(small_case()));
    Case other = small_case();
    other.gravity_m_s2 = 3.71;
    EXPECT_THROW(resume(other), Error);
    std::ofstream(run + "/series.csv", std::ios::app) << "not,a line\n";
    EXPECT_THROW(resume(small_case()), Error);
    std::filesystem::resize_file(run + "/results.h5", 100);
    EXPECT_THROW(resume(small_case()), Error);
}

/// Opening and closing tags match and nothing is left open. "" if so.
std::string xml_fault(const std::string& text) {
    std::vector<std::string> open;
    std::size_t at = text.find('<', 1);  // behind the declaration
    for (; at != std::string::npos; at = text.find('<', at)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos || text.find('<', at + 1) < end) return "stray bracket";
        const std::string tag = text.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" ", 1));
        if (count(tag, "\"") % 2 != 0) return "open quote in " + tag;
        if (name.starts_with("/")) {
            if (open.empty() || "/" + open.back() != name) return "closes " + name;
            open.pop_back();
        } else if (!tag.ends_with("/")) {
            open.push_back(name);
        }
        at = end;
    }
    return open.empty() ? "" : "not closed: " + open.back();
}

TEST(Xdmf, NamesWhatResultsHold) {
    const Scratch scratch;
    Recorder recorder(scratch.file("run"), small_case(), two_quads());
    for (std::uint64_t k = 30; k < 50; ++k) {
        recorder.add_frame(frame_at(k));
        const std::string discs = read_text(scratch.file("run/discs.xdmf"));
        const std::string wheel = read_text(scratch.file("run/wheel.xdmf"));
        ASSERT_EQ(xml_fault(discs), "");
        ASSERT_EQ(xml_fault(wheel), "");
        EXPECT_EQ(count(discs + wheel, "\"HyperSlab\">\n"), 0U)
            << "ParaView would show one frame for all (see xdmf.cpp)";
        EXPECT_EQ(count(discs, "<Time "), k - 29);
        EXPECT_EQ(count(wheel, "<Time "), k < 40 ? 0 : k - 39) << "no wheel before the second stage";
        // The dimensions given for a dataset are those it has in the file.
        const FrameRoom room =
            FrameFile::open(scratch.file("run/results.h5"), {to_toml(small_case()), two_quads().mesh}).room();
        const std::string rows = "Dimensions=\"" + std::to_string(room.frames) + " ";
        EXPECT_EQ(count(discs, rows + "50 2\" NumberType=\"Float\" Precision=\"8\">results.h5:/discs/position_m<"),
                  k - 29);
        EXPECT_EQ(count(discs, rows + "50\" NumberType=\"Float\" Precision=\"4\">results.h5:/discs/pressure_Pa<"),
                  k - 29);
    }
    EXPECT_EQ(count(read_text(scratch.file("run/discs.xdmf")), "NodesPerElement=\"1\""), 20U);
    EXPECT_EQ(count(read_text(scratch.file("run/discs.xdmf")), "<Time Value=\"12.25\"/>"), 1U) << "49 steps of 0.25 s";
}

constexpr std::size_t many = 4000;  // so that writing a frame takes a while

/// Records frames until it is killed; one byte to `progress` after each.
[[noreturn]] void record_for_ever(const std::string& run, int progress) {
    Recorder recorder(run, small_case(), two_quads());
    for (std::uint64_t total = 0;; ++total) {
        recorder.add_series(row_at(total));
        recorder.add_frame(frame_at(total, many));
        if (write(progress, "x", 1) != 1) _exit(1);
    }
}

/// Runs it in a child, kills it a moment after frame `first`, and returns how many frames it had finished.
std::size_t record_and_kill(const std::string& run, std::size_t first, useconds_t moment) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return 0;
    const pid_t child = fork();
    if (child == 0) record_for_ever(run, ends[1]);
    close(ends[1]);
    std::size_t finished = 0;
    char mark = 0;
    while (finished < first && read(ends[0], &mark, 1) == 1) ++finished;
    usleep(moment);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    while (read(ends[0], &mark, 1) == 1) ++finished;
    close(ends[0]);
    return finished;
}

TEST(Recorder, SurvivesBeingKilled) {
    Random random{17};
    for (std::size_t k = 0; k < 40; ++k) {
        const Scratch scratch;
        const std::string run = scratch.file("run"), results = run + "/results.h5";
        // Half of them about the frame that has the file remade in twice the size.
        const std::size_t first = k % 2 == 0 ? 15 + random.below(2) : 2 + random.below(40);
        const std::size_t finished = record_and_kill(run, first, static_cast<useconds_t>(random.below(1500)));
        ASSERT_GE(finished, first);
        const FrameReader reader(results);
        const std::size_t frames = reader.frames().size();
        EXPECT_TRUE(frames == finished || frames == finished + 1) << frames << " of " << finished;
        for (std::uint64_t f = 0; f < frames; ++f) EXPECT_EQ(fault_of(reader.read(f), f, many), "");
        const std::string discs = read_text(run + "/discs.xdmf");
        EXPECT_EQ(xml_fault(discs), "");
        EXPECT_GE(count(discs, "<Time ") + 1, frames);
        const Recorder resumed(run, small_case(), two_quads(), state_at(1).progress);  // it can be gone on with
        EXPECT_EQ(FrameReader(results).frames().size(), 2U);
        EXPECT_EQ(count(read_text(run + "/series.csv"), "\n"), 3U);
    }
}

/// Adds a frame with no file allowed to grow past `limit`: whether it came through.
bool add_with_limit(Recorder& recorder, const Frame& frame, std::uintmax_t limit) {
    const FullDisk full(limit);
    try {
        recorder.add_frame(frame);
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::io);
        return false;
    }
}

TEST(Recorder, KeepsItsFilesOnAFullDisk) {
    const Scratch scratch;
    const std::string results = scratch.file("run/results.h5");
    Recorder recorder(scratch.file("run"), small_case(), two_quads());
    // Wherever the disk is full, in any column of a frame or while the file is remade, the frames before are there.
    std::size_t frames = 0, failures = 0;
    for (std::uint64_t total = 0; total < 18; ++total) {
        const std::uintmax_t size = std::filesystem::file_size(results);
        for (std::uintmax_t part = 0; part < 20 && frames == total; ++part) {
            frames += add_with_limit(recorder, frame_at(total), size * part / 20) ? 1U : 0U;
            failures += frames == total ? 1U : 0U;
            const FrameReader reader(results);
            const std::size_t listed = reader.frames().size();
            ASSERT_TRUE(listed == frames || listed == total + 1) << listed << " after " << frames;
            for (std::uint64_t f = 0; f < listed; ++f) ASSERT_EQ(fault_of(reader.read(f), f), "") << f;
            if (listed > frames) frames = listed;  // it was a picture's text that did not fit any more
        }
        if (frames == total) frames += add_with_limit(recorder, frame_at(total), RLIM_INFINITY) ? 1U : 0U;
    }
    EXPECT_EQ(frames, 18U) << "once there is space again, the run goes on";
    EXPECT_GT(failures, 100U);
    const FullDisk full(1500);
    EXPECT_THROW(write_file_atomically(scratch.file("run/case.toml"), std::string(2000, 'x')), Error);
    EXPECT_EQ(read_text(scratch.file("run/case.toml")), to_toml(small_case()));
}

std::uint32_t big_endian(const std::string& text, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(text.at(at + k));
    return value;
}

TEST(Snapshot, DrawsTheSameBytesTwiceAndOthersForAnotherFrame) {
    const Scratch scratch;
    SnapshotOptions options;
    options.x_min_m = 40;
    options.x_max_m = 44;
    options.y_min_m = -42;
    options.y_max_m = 2;
    options.width_px = 480;  // 480 - 110 - 170 for 4 m, so 2200 px and the margins for 44 m
    options.title = "a 'quoted' {title}";
    const Mesh wheel = two_quads().mesh;
    write_snapshot_png(scratch.file("it's a.png"), {frame_at(41), {}}, wheel, options);
    write_snapshot_png(scratch.file("b.png"), {frame_at(41), {}}, wheel, options);
    write_snapshot_png(scratch.file("c.png"), {frame_at(42), {}}, wheel, options);
    const std::string picture = read_text(scratch.file("it's a.png"));
    ASSERT_EQ(picture.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(big_endian(picture, 16), 480U);
    EXPECT_EQ(big_endian(picture, 20), 2200U + 55 + 90);
    EXPECT_TRUE(picture == read_text(scratch.file("b.png")));
    EXPECT_FALSE(picture == read_text(scratch.file("c.png")));
    const SoilOutline soil{{{Vec2{41, -10}, Vec2{43, -10}, Vec2{43, -8}, Vec2{41, -8}}}, {}};
    write_snapshot_png(scratch.file("c.png"), {frame_at(41), soil}, wheel, options);
    EXPECT_FALSE(picture == read_text(scratch.file("c.png"))) << "the soil's element is not drawn";
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path))
        files += entry.is_regular_file() ? 1U : 0U;
    EXPECT_EQ(files, 3U) << "temporary files are left";
}

TEST(Snapshot, SaysWhatWentWrong) {
    const Scratch scratch;
    EXPECT_THROW(write_snapshot_png(scratch.file("none/a.png"), {frame_at(41), {}}, {}, {}), Error);
    SnapshotOptions upside_down;
    upside_down.y_max_m = -1;
    EXPECT_THROW(write_snapshot_png(scratch.file("a.png"), {frame_at(41), {}}, {}, upside_down), Error);
    const std::string old_path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    EXPECT_THROW(write_snapshot_png(scratch.file("a.png"), {frame_at(41), {}}, {}, {}), Error);
    setenv("PATH", old_path.c_str(), 1);
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path));
}

}  // namespace
}  // namespace ifedem

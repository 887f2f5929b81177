#include "record/checkpoint.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/random.hpp"
#include "support/scratch.hpp"

namespace ifedem {
namespace {

/// Random bytes: among the doubles are negative zeros, denormals, infinities and NaNs with payloads.
template <class T>
void fill(T& value, Random& random) {
    if constexpr (std::is_enum_v<T>) {
        value = static_cast<T>(random.below(4));
    } else {
        std::vector<unsigned char> bytes(sizeof value);
        for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random.next() >> 56);
        std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof value);
    }
}
template <class T>
void fill(std::vector<T>& values, Random& random) {
    values.resize(1 + random.below(300));
    for (T& value : values) fill(value, random);
}

State random_state(std::uint64_t seed) {
    State state;
    Random random{seed};
    const auto fill_member = [&](const char*, auto& member) { fill(member, random); };
    for_each_member(state, fill_member);
    for_each_soil_member(state, fill_member);
    for_each_stress_member(state, fill_member);
    for_each_mass_member(state, fill_member);
    return state;
}

template <class T>
std::string bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}
template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Name of the first member in which two states differ in a bit; empty if none does.
std::string first_difference(const State& a, const State& b) {
    std::vector<std::string> of_a;
    const auto note = [&](const char*, const auto& member) { of_a.push_back(bytes_of(member)); };
    for_each_member(a, note);
    for_each_soil_member(a, note);
    for_each_stress_member(a, note);
    for_each_mass_member(a, note);
    std::string difference;
    std::size_t k = 0;
    const auto compare = [&](const char* name, const auto& member) {
        if (of_a[k++] != bytes_of(member) && difference.empty()) difference = name;
    };
    for_each_member(b, compare);
    for_each_soil_member(b, compare);
    for_each_stress_member(b, compare);
    for_each_mass_member(b, compare);
    return difference;
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}

/// "" if the file is refused with an io error that names it; otherwise what happened instead.
std::string refusal_fault(const std::string& path) {
    try {
        (void)read_checkpoint(path);
        return "was read";
    } catch (const Error& error) {
        if (error.code() != ExitCode::io) return "wrong exit code";
        const std::string message = error.what();
        if (message.find(path) == std::string::npos || !message.ends_with("?")) return "unclear message: " + message;
        return "";
    }
}

TEST(Checkpoint, KeepsEveryBitOfEveryMember) {
    const Scratch scratch;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const State state = random_state(seed);
        write_checkpoint(scratch.file("a.h5"), state, Case{});
        const Checkpoint read = read_checkpoint(scratch.file("a.h5"));
        EXPECT_EQ(first_difference(state, read.state), "") << "seed " << seed;
        EXPECT_EQ(read.results_version, results_version);
    }
}

TEST(Checkpoint, KeepsEmptyVectorsAndTheCase) {
    const Scratch scratch;
    Case c;
    c.name = "a name with \"quotes\" and ü";
    c.time_step_s = 1e-4 / 3;
    c.soil.radii_m = {0.0021, 0.0034};
    c.soil.radii_shares = {1, 2};
    write_checkpoint(scratch.file("a.h5"), State{}, c);
    const Checkpoint read = read_checkpoint(scratch.file("a.h5"));
    EXPECT_EQ(first_difference(State{}, read.state), "");
    EXPECT_EQ(read.c.name, c.name);
    EXPECT_EQ(read.c.time_step_s, c.time_step_s);
    EXPECT_EQ(read.c.soil.radii_m, c.soil.radii_m);
    EXPECT_EQ(to_toml(read.c), to_toml(c));
}

TEST(Checkpoint, KeepsWhatWasSpentBesideTheState) {
    const Scratch scratch;
    write_checkpoint(scratch.file("a.h5"), random_state(1), Case{}, {7, 1.5, 2.5});
    write_checkpoint(scratch.file("b.h5"), random_state(1), Case{}, {8, 3.5, 4.5});
    const Checkpoint a = read_checkpoint(scratch.file("a.h5")), b = read_checkpoint(scratch.file("b.h5"));
    EXPECT_EQ(a.spent.steps, 7U);
    EXPECT_EQ(a.spent.cpu_s, 1.5);
    EXPECT_EQ(a.spent.wall_s, 2.5);
    EXPECT_EQ(b.spent.steps, 8U);
    EXPECT_EQ(first_difference(a.state, b.state), "");
    EXPECT_EQ(hash_state(a.state), hash_state(b.state));
}

TEST(Checkpoint, OneFromBeforeCostsWereKeptIsRead) {
    const Scratch scratch;
    write_checkpoint(scratch.file("a.h5"), random_state(1), Case{}, {7, 1.5, 2.5});
    std::string bytes = read_text(scratch.file("a.h5"));
    const auto name = bytes.find("spent_steps");
    ASSERT_NE(name, std::string::npos);
    bytes.replace(name, 11, "spent_stepz");  // the order of names, which HDF5 searches by, stays
    const std::span<char> image(bytes.data(), bytes.size() - 16);
    const std::uint64_t sum = checksum(std::as_bytes(image));
    std::memcpy(bytes.data() + bytes.size() - sizeof sum, &sum, sizeof sum);
    write_text(scratch.file("old.h5"), bytes);
    const Checkpoint old = read_checkpoint(scratch.file("old.h5"));
    EXPECT_EQ(first_difference(random_state(1), old.state), "");
    EXPECT_EQ(old.spent.steps, 0U);
    EXPECT_EQ(old.spent.cpu_s, 0);
}

TEST(Checkpoint, EqualStatesMakeEqualBytes) {
    const Scratch scratch;
    write_checkpoint(scratch.file("a.h5"), random_state(7), Case{});
    sleep(1);  // HDF5's object times have seconds
    write_checkpoint(scratch.file("b.h5"), random_state(7), Case{});
    EXPECT_EQ(read_text(scratch.file("a.h5")), read_text(scratch.file("b.h5")));
    write_checkpoint(scratch.file("b.h5"), random_state(8), Case{});
    EXPECT_NE(read_text(scratch.file("a.h5")), read_text(scratch.file("b.h5")));
}

TEST(Checkpoint, RefusesFlippedBits) {
    const Scratch scratch;
    write_checkpoint(scratch.file("a.h5"), random_state(3), Case{});
    const std::string good = read_text(scratch.file("a.h5"));
    EXPECT_EQ(refusal_fault(scratch.file("a.h5")), "was read");
    Random random{11};
    for (int k = 0; k < 300; ++k) {
        // A third of them in the trailer and in HDF5's own first block, which chance would rarely hit.
        const std::size_t range = k % 3 == 0 ? 64 : good.size();
        const std::size_t byte = k % 6 == 0 ? good.size() - 1 - random.below(16) : random.below(range);
        std::string bad = good;
        bad[byte] = static_cast<char>(bad[byte] ^ (1 << random.below(8)));
        write_text(scratch.file("bad.h5"), bad);
        EXPECT_EQ(refusal_fault(scratch.file("bad.h5")), "") << "byte " << byte << " of " << good.size();
    }
}

TEST(Checkpoint, RefusesTruncatedAndLengthenedFiles) {
    const Scratch scratch;
    write_checkpoint(scratch.file("a.h5"), random_state(3), Case{});
    const std::string good = read_text(scratch.file("a.h5"));
    EXPECT_EQ(refusal_fault(scratch.file("a.h5")), "was read");
    Random random{12};
    std::vector<std::size_t> sizes = {0, 1, 15, 16, 17, good.size() - 16, good.size() - 1};
    for (int k = 0; k < 300; ++k) sizes.push_back(random.below(good.size()));
    for (const std::size_t size : sizes) {
        write_text(scratch.file("bad.h5"), good.substr(0, size));
        EXPECT_EQ(refusal_fault(scratch.file("bad.h5")), "") << size << " bytes of " << good.size();
    }
    write_text(scratch.file("bad.h5"), good + '\0');
    EXPECT_EQ(refusal_fault(scratch.file("bad.h5")), "");
    std::string zeros = good;
    std::fill(zeros.begin() + static_cast<std::ptrdiff_t>(zeros.size() / 2), zeros.end() - 16, '\0');  // a full disk
    write_text(scratch.file("bad.h5"), zeros);
    EXPECT_EQ(refusal_fault(scratch.file("bad.h5")), "");
}

TEST(Checkpoint, RefusesWhatIsNoFile) {
    const Scratch scratch;
    EXPECT_EQ(refusal_fault(scratch.file("missing.h5")), "");
    EXPECT_EQ(refusal_fault(scratch.path), "");
    EXPECT_EQ(refusal_fault("/dev/zero"), "");
}

TEST(Checkpoint, FullDiskKeepsTheOldOne) {
    const Scratch scratch;
    const State old_state = random_state(1);
    write_checkpoint(scratch.file("a.h5"), old_state, Case{});
    for (const rlim_t bytes : {rlim_t{0}, rlim_t{1000}, rlim_t{20000}}) {
        ExitCode code = ExitCode::done;
        {
            const FullDisk full(bytes);
            try {
                write_checkpoint(scratch.file("a.h5"), random_state(2), Case{});
            } catch (const Error& error) {
                code = error.code();
            }
        }
        EXPECT_EQ(code, ExitCode::io) << bytes;
        EXPECT_EQ(first_difference(old_state, read_checkpoint(scratch.file("a.h5")).state), "");
        EXPECT_FALSE(std::filesystem::exists(scratch.file("a.h5.tmp"))) << "litter on a full disk";
    }
}

TEST(Checkpoint, KilledWriterLeavesOneThatReads) {
    const Scratch scratch;
    const std::string path = scratch.file("a.h5");
    const State first = random_state(1), second = random_state(2);
    write_checkpoint(path, first, Case{});
    Random random{5};
    for (int k = 0; k < 20; ++k) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (;;) {
                write_checkpoint(path, second, Case{});
                write_checkpoint(path, first, Case{});
            }
        }
        usleep(static_cast<useconds_t>(500 + random.below(15000)));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const State read = read_checkpoint(path).state;
        EXPECT_TRUE(first_difference(read, first).empty() || first_difference(read, second).empty()) << "kill " << k;
    }
}

}  // namespace
}  // namespace ifedem

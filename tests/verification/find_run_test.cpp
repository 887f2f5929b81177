// `ifedem find`: a finished run of the same case is found whatever its name, and nothing else is.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "check/csv.hpp"
#include "record/checkpoint.hpp"
#include "support/synthetic_runs.hpp"

using namespace ifedem;
using namespace ifedem::test;

namespace {

std::string find(const std::string& arguments) {
    FILE* pipe = popen((std::string(IFEDEM_PROGRAM) + " find " + arguments).c_str(), "r");
    std::string text;
    std::array<char, 256> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
    EXPECT_EQ(pclose(pipe), 0);
    return text;
}

}  // namespace

TEST(Find, TellsDiscStepsAndTheFinishedRunOfTheSameCase) {
    const auto root = fresh_directory("find");
    const SyntheticRun r{.name = "campaign-run"};
    const std::string there = write_synthetic_run(root, r);
    Case c = synthetic_case(r);
    c.name = "another name";
    c.bed.disc_count = 1000;
    const std::string wanted = (root / "wanted.toml").string();
    write_text(wanted, to_toml(c));
    write_text(there + "/case.toml", to_toml([&] {
                   Case same = c;
                   same.name = "the campaign's";
                   return same;
               }()));
    const auto finish = [&](int version) {
        write_text(there + "/run.csv", fmt::format("name,value,unit\nresults_version,{},\n", version));
    };
    finish(results_version);
    // 3 s and 8.5 s of 4e-5 s, 1000 discs: 7.5e7 and 2.125e8.
    EXPECT_EQ(find(wanted + " --among " + there), "7.5e+07 2.125e+08 " + there + "\n");
    EXPECT_EQ(find(wanted + " --set bed.seed=2 --among " + there), "7.5e+07 2.125e+08 -\n");
    finish(results_version - 1);  // an older program's
    EXPECT_EQ(find(wanted + " --among " + there), "7.5e+07 2.125e+08 -\n");
    std::filesystem::remove(there + "/run.csv");  // not finished
    EXPECT_EQ(find(wanted + " --among " + there), "7.5e+07 2.125e+08 -\n");
    std::filesystem::remove_all(root);
}

// run.csv: what is written reads back, whatever a case is called.
#include <gtest/gtest.h>

#include <fstream>

#include "check/run.hpp"
#include "core/error.hpp"
#include "support/scratch.hpp"

namespace ifedem {
namespace {

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

TEST(RunValues, ReadBackWhateverTheCaseIsCalled) {
    const std::vector<RunValue> values = {{"case", "a, \"b\"", ""}, {"cpu_s", "1.25", "s"}};
    const Scratch scratch;
    write(scratch.file("run.csv"), to_csv(values));
    const std::vector<RunValue> back = read_values(scratch.file("run.csv"));
    ASSERT_EQ(back.size(), values.size());
    for (std::size_t k = 0; k < back.size(); ++k) {
        EXPECT_EQ(back[k].name, values[k].name);
        EXPECT_EQ(back[k].value, values[k].value);
        EXPECT_EQ(back[k].unit, values[k].unit);
    }
}

TEST(RunValues, OfOrdinaryNamesStandWithoutQuotes) {
    EXPECT_EQ(to_csv({{"case", "B3-earth", ""}, {"cpu_s", "1.25", "s"}}),
              "name,value,unit\ncase,B3-earth,\ncpu_s,1.25,s\n");
}

TEST(RunValues, SayWhichLineIsFaulty) {
    const Scratch scratch;
    write(scratch.file("run.csv"), "name,value,unit\ncase,a, b,\n");
    try {
        static_cast<void>(read_values(scratch.file("run.csv")));
        FAIL() << "four cells under three columns were read";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("run.csv:2:"), std::string::npos) << error.what();
    }
    EXPECT_THROW(static_cast<void>(read_values(scratch.file("none.csv"))), Error);
}

}  // namespace
}  // namespace ifedem

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "model/case.hpp"
#include "reliability/tally.hpp"

// A case that cannot be run is told so, with the place and a way out; it is never half accepted, and nothing that a
// file may hold makes the program end otherwise.

namespace ifedem {
namespace {

namespace fs = std::filesystem;

std::string fault_of(const std::string& text) {
    try {
        (void)parse_case(text, "c");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "no fault";
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Counts the handwritten cases of all tests together.
class BadInput : public testing::Test {
protected:
    static void SetUpTestSuite() { tally = std::make_unique<FaultTally>("bad case file: its line and a remedy"); }
    static void TearDownTestSuite() { tally.reset(); }
    static std::unique_ptr<FaultTally> tally;
};
std::unique_ptr<FaultTally> BadInput::tally;

struct BadCase {
    std::string text;
    std::string fault;  ///< how the one message begins
};

/// Each text has one fault, reported with its place and a way out.
void expect_faults(FaultTally& tally, const std::vector<BadCase>& cases) {
    for (const BadCase& bad : cases) {
        const std::string fault = fault_of(bad.text);
        const bool good = fault.starts_with(bad.fault) && lines_of(fault).size() == 1 && fault.ends_with('?');
        tally.count(good ? "" : "expected: " + bad.fault + "\nreported: " + fault);
    }
}

TEST_F(BadInput, UnknownKeysAreAnsweredWithTheNearest) {
    expect_faults(
        *tally,
        {
            {"foo_bar_baz_qux = 3", "c:1:1: unknown key foo_bar_baz_qux. Look it up"},
            {"[wheel]\nlod_N = 3", "c:2:1: unknown key wheel.lod_N. Did you mean wheel.load_N?"},
            {"wheel.load = 3",
             "c:1:7: unknown key wheel.load (a key ends in its unit, and values are in SI units). Did you mean "
             "wheel.load_N?"},
            {"wheel.load_kgf = 3",
             "c:1:7: unknown key wheel.load_kgf (a key ends in its unit, and values are in SI units). Did you mean "
             "wheel.load_N?"},
            {"[travel]\n  speed_km_h = 2.6",
             "c:2:3: unknown key travel.speed_km_h (a key ends in its unit, and values are in SI units). Did you mean "
             "travel.speed_m_s?"},
            {"[wheel]\nload_N = 3\nload_kN = 0.003",
             "c:3:1: given twice (wheel.load_kN and wheel.load_N). Remove one?"},
            {"wheel.lug_height_mm = 'x'", "c:1:23: wheel.lug_height_m is a text (it must be a number, in m)"},
            {"wheel.lug_height_mm = -8", "c:1:23: wheel.lug_height_m = -0.008 is out of range"},
            {"soil.radii_mm = [2, 'x', 3]", "c:1:17: soil.radii_m is a text"},
            {"wheel.mesh_file = 'none.msh'", "c:1:19: wheel.mesh_file = \"none.msh\": there is no such file. Check"},
            {"travel.speed = 0.1",
             "c:1:8: unknown key travel.speed (a key ends in its unit, and values are in SI units). Did you mean "
             "travel.speed_m_s?"},
            {"gravity = 3.71",
             "c:1:1: unknown key gravity (a key ends in its unit, and values are in SI units). Did you mean "
             "gravity_m_s2?"},
            {"[control.drawbar]\nproportional = 1",
             "c:2:1: unknown key control.drawbar.proportional (a key ends in its unit, and values are in SI units). "
             "Did "
             "you "
             "mean control.drawbar.proportional_N_m?"},
            {"load_N = 3", "c:1:1: unknown key load_N (it stands elsewhere). Did you mean wheel.load_N?"},
            {"[whel]\nload_N = 3\nwidth_m = 0.1", "c:1:2: unknown table whel. Did you mean wheel?"},
            {"[wheel.rims]\nyoung_Pa = 3", "c:1:8: unknown table wheel.rims. Did you mean wheel.rim?"},
            {"'wheel.load_N' = 3", "c:1:1: unknown key \"wheel.load_N\" (a dot in quotes"},
            {"\"a\\u0001\\nb\" = 3", "c:1:1: unknown key a??b"},
            {"\"é\" = 3", "c:1:1: unknown key é"},
            {"'' = 3", "c:1:1: unknown key "},
        });
}

TEST_F(BadInput, WrongTypesAreNamedWithTheRightOne) {
    expect_faults(
        *tally,
        {
            {"[wheel]\nload_N = '3'",
             "c:2:10: wheel.load_N is a text (it must be a number, in N). Write it like load_N = 170.0?"},
            {"wheel.load_N = true", "c:1:16: wheel.load_N is true or false (it must be a number, in N)"},
            {"wheel.load_N = 2020-01-01", "c:1:16: wheel.load_N is a date or time (it must be a number, in N)"},
            {"wheel.load_N = [3]", "c:1:16: wheel.load_N is a list (it must be a number, in N)"},
            {"[wheel.load_N]\nx = 1", "c:1:1: wheel.load_N is a table (it must be a number, in N)"},
            {"wheel = 3",
             "c:1:1: wheel is a whole number (it must be a table of keys). Write [wheel] with its keys below?"},
            {"[[wheel]]\nload_N = 3", "c:1:3: wheel is a list (it must be a table of keys)"},
            {"bed.disc_count = 10.0", "c:1:18: bed.disc_count is a number with a fraction (it must be a whole number)"},
            {"soil.radii_m = 0.002",
             "c:1:16: soil.radii_m is a number with a fraction (it must be a list of numbers, in m)"},
            {"soil.radii_m = []", "c:1:16: soil.radii_m has 0 numbers (it must have 1 to 32)"},
            {"soil.radii_m = ['a', 1, 2]", "c:1:16: soil.radii_m is a text (it must be a list of numbers"},
            {"name = 3", "c:1:8: name is a whole number (it must be a text in quotes)"},
            {"name = ''", "c:1:8: name = \"\" is no name"},
            {"name = 'a\\nb'\nwheel.load_N = 'x'", "c:2:16: wheel.load_N is a text"},
            {"name = \"a\\nb\"", "c:1:8: name = \"a?b\" is no name"},
            {"base = 3", "c:1:8: base is no path"},
            {"control.scheme = 1", "c:1:18: control.scheme is a whole number (it must be a word in quotes)"},
            {"control.scheme = 'explizit'",
             "c:1:18: control.scheme = \"explizit\" is not known (it may be semi-implicit | explicit | prescribed). "
             "Did you mean "
             "\"explicit\"?"},
            {"integrator = 'leapfrog'",
             "c:1:14: integrator = \"leapfrog\" is not known (it may be symplectic-euler | modified-euler-one | "
             "modified-euler-two)"},
            {"wheel.body = 'Rigid'",
             "c:1:14: wheel.body = \"Rigid\" is not known (it may be rigid | rigid-rim | elastic). Did you mean "
             "\"rigid\"?"},
        });
}

TEST_F(BadInput, ValuesOutOfRangeAreNamedWithTheirRange) {
    expect_faults(
        *tally,
        {
            {"wheel.load_N = nan", "c:1:16: wheel.load_N is nan (it must be a finite number, in [0, 1e+07] N)"},
            {"wheel.load_N = -inf", "c:1:16: wheel.load_N is -inf (it must be a finite number"},
            {"contact.normal_stiffness_N_m = 0",
             "c:1:32: contact.normal_stiffness_N_m = 0 is out of range (it must be in (0, 1e+12] N/m)"},
            {"wheel.rim.poisson = 0.5", "c:1:21: wheel.rim.poisson = 0.5 is out of range (it must be in (-1, 0.5))"},
            {"wheel.rim.poisson = -1", "c:1:21: wheel.rim.poisson = -1 is out of range"},
            {"wheel.surface.young_Pa = -1", "c:1:26: wheel.surface.young_Pa = -1 is out of range"},
            {"travel.slip_percent = 100",
             "c:1:23: travel.slip_percent = 100 is out of range (it must be in (-100, 100) %)"},
            {"travel.slip_percent = -100", "c:1:23: travel.slip_percent = -100 is out of range"},
            {"bed.disc_count = 0", "c:1:18: bed.disc_count = 0 is out of range (it must be whole in [1, 1e+07])"},
            {"bed.seed = 9223372036854775807", "c:1:12: bed.seed = 9.223372036854776e+18 is out of range"},
            {"time_step_s = 0", "c:1:15: time_step_s = 0 is out of range"},
            {"time_step_s = 10", "c:1:15: time_step_s = 10 is out of range"},
            {"gravity_m_s2 = -9.81", "c:1:16: gravity_m_s2 = -9.81 is out of range"},
            {"soil.radii_m = [0.002, -0.0025, 0.003]", "c:1:16: soil.radii_m = -0.0025 is out of range"},
            {"soil.radii_shares = [3, inf, 1]", "c:1:21: soil.radii_shares is inf"},
        });
}

TEST_F(BadInput, KeysThatDoNotFitTogetherAreNamed) {
    expect_faults(
        *tally,
        {
            {"soil.radii_m = [0.002]", "c:1:16: soil.radii_m has 1 numbers and soil.radii_shares 3"},
            {"[wheel]\nrim_radius_m = 0.1302", "c:2:16: the rim leaves no room for the intermediate layer"},
            {"[wheel]\nsurface_thickness_m = 0.06", "c:2:23: the rim leaves no room for the intermediate layer"},
            {"wheel.lug_pairs = 30", "c:1:19: the lug pairs do not fit round the tread"},
            {"wheel.intermediate_rings = 1000\nwheel.gap_columns = 1000",
             "c:2:21: the wheel would have 1.21e+07 elements"},
            {"soil.radii_m = [0.1, 1.5, 0.1]", "c:1:16: the largest disc does not fit into the bed"},
            {"travel.start_x_m = 0.1", "c:1:20: the wheel starts inside the left wall"},
            {"travel.distance_m = 1.2", "c:1:21: the wheel ends inside the right wall"},
            {"record.series_interval_s = 1e-6",
             "c:1:28: record.series_interval_s = 1e-06 is less than time_step_s = 4e-05"},
            {"time_step_s = 1e-12", "c:1:15: the run would take 1.2e+13 steps"},
            {"travel.acceleration_time_s = 30", "c:1:30: the wheel ends inside the right wall"},
            {"record.stress_segments = 60\nrecord.stress_from_x_m = 1.3\nrecord.stress_to_x_m = 1.4",
             "c:2:26: the hub never comes where contact forces are averaged"},
            {"[elements]\ncolumns = 10\ndisc_columns = 2\nblock_length_m = 0.15\npattern_discs = 100000",
             "c:5:17: a block's discs do not fit into it"},
            {"bed.walls = \"discs\"\n[elements]\ncolumns = 10\nblock_length_m = 0.15",
             "c:1:13: walls of discs beside soil elements"},
            {"[elements]\ncolumns = 10\nblock_length_m = 0.15\nrows = 1\ndisc_columns = 2",
             "c:4:8: blocks of discs without elements below them"},
            {"bed.levelled_count = 1000\n[elements]\ncolumns = 10\nblock_length_m = 0.15\ndisc_columns = 2",
             "c:1:22: levelling would take discs out of prepared blocks"},
        });
}

TEST_F(BadInput, WhatIsNoCaseIsNotRead) {
    expect_faults(*tally,
                  {
                      {"", "c:1:1: the case is empty"},
                      {"# only a comment\n\n", "c:1:1: the case is empty"},
                      {"wheel.load_N = 1\nwheel.load_N = 2", "c:2:"},
                      {"[wheel]\nload_N = 1\n[wheel]\nwidth_m = 2", "c:3:"},
                      {"wheel.load_N = ", "c:1:"},
                      {"wheel.load_N = 1e999", "c:1:"},
                      {"wheel.load_N 3", "c:1:"},
                      {"name = 'x\nbed.seed = 1", "c:1:"},
                      {"[wheel\nload_N = 3", "c:1:"},
                      {"= 3", "c:1:"},
                      {"é = 3", "c:1:1: not TOML"},
                      {"gravité_m_s2 = 3", "c:1:7: not TOML"},
                      {"[wheel]é", "c:1:8: not TOML"},
                      {"bed.seed = 1\u00a0", "c:1:13: not TOML"},
                      {"bed.seed\u3000= 1", "c:1:9: not TOML"},
                      {"x = [[[[[[[[1]]]]]]]]", "c:1:"},
                      {std::string("[\x01"),
                       "c:1:2: control character 0x01 (a case is UTF-8 text without control characters). Is this the "
                       "right file?"},
                      {std::string("name = 'x'\n# \0", 14), "c:2:3: control character 0x00"},
                      {"name = 'x'\n  bed.seed\x7f = 1", "c:2:11: control character 0x7f"},
                      {"name = 'x'\rbed.seed = 1", "c:1:11: control character 0x0d"},
                      {"name = '\xff'", "c:1:9: byte 0xff is not UTF-8"},
                      {"name = '\xc0\xaf'", "c:1:9: byte 0xc0 is not UTF-8"},
                      {"name = 'm\xc3\xbc\xed\xa0\x80'", "c:1:11: byte 0xed is not UTF-8"},
                      {"name = '\xf4\x90\x80\x80'", "c:1:9: byte 0xf4 is not UTF-8"},
                      {"name = '\xf4\x80\x80\x80'", "c:1:9: private character"},
                      {"name = 'x' # \xe2\x82", "c:1:14: byte 0xe2 is not UTF-8"},
                      {"name = 'x'\n# " + std::string(3000, 'x'), "c:2:2001: the line is longer than 2000 bytes"},
                      {"\x7f"
                       "ELF\x02\x01\x01",
                       "c:1:1: control character 0x7f"},
                      {"\x89HDF\r\n\x1a\n", "c:1:1: byte 0x89 is not UTF-8"},
                  });
}

TEST_F(BadInput, AKeyGivenTwiceIsSaidToBe) {
    EXPECT_NE(fault_of("bed.seed = 1\nbed.seed = 2").find("given twice"), std::string::npos);
    EXPECT_NE(fault_of("[bed]\nseed = 1\n[bed]\nseed = 2").find("given twice"), std::string::npos);
    EXPECT_NE(fault_of("[wheel]\nlug_height_cm = 1.5\nlug_height_mm = 6")
                  .find("given twice (wheel.lug_height_mm and wheel.lug_height_cm)"),
              std::string::npos);
}

TEST_F(BadInput, EveryFaultIsListedInTheOrderOfTheFile) {
    const std::string fault = fault_of(
        "time_step_s = -1\n[travel]\nspeed = 2\n[wheel]\nload_N = 'x'\nlug_pairs = 30\n[bed]\nwalls = 'round'\nseed = "
        "1.5\n");
    const std::vector<std::string> lines = lines_of(fault);
    ASSERT_EQ(lines.size(), 6U) << fault;
    const std::array<std::string, 6> starts = {"c:1:15:", "c:3:1:", "c:5:10:", "c:8:9:", "c:9:8:", "c:6:13:"};
    for (std::size_t k = 0; k < starts.size(); ++k) EXPECT_EQ(lines[k].rfind(starts[k], 0), 0U) << lines[k];
}

TEST_F(BadInput, AFaultyValueBreaksNoRuleOnTop) {
    // The rim would be too large for the default tread, but the tread that was meant is unknown.
    const std::string fault = fault_of("wheel.rim_radius_m = 0.3\nwheel.tread_radius_m = -0.5");
    EXPECT_EQ(lines_of(fault).size(), 1U) << fault;
}

TEST_F(BadInput, EndlessFaultsAreCounted) {
    std::string text;
    for (int k = 0; k < 5000; ++k) text += "wrong" + std::to_string(k) + " = 1\n";
    const std::vector<std::string> lines = lines_of(fault_of(text));
    ASSERT_EQ(lines.size(), 201U);
    EXPECT_EQ(lines.back(), "c: and 4800 more faults. Is this the right file?");
}

// ---- files ---------------------------------------------------------------------------------------------------------

class Files : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    std::string fault_of_file(const std::string& name, ExitCode code = ExitCode::bad_input) const {
        try {
            (void)read_case((folder / name).string());
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), code);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
            return error.what();
        }
        return "no fault";
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    fs::path folder = fs::temp_directory_path() / ("ifedem_bad_input_" + std::to_string(::getpid()));
};

TEST_F(Files, AbsentDirectoryPipeAndHugeFilesAreRefused) {
    fs::create_directories(folder / "directory");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    write("huge", std::string((1U << 20) + 1, '\n'));
    write("empty", "");
    EXPECT_NE(fault_of_file("absent").find("there is no such file"), std::string::npos);
    EXPECT_NE(fault_of_file("absent/absent").find("there is no such file"), std::string::npos);
    EXPECT_NE(fault_of_file("directory").find("this is a directory"), std::string::npos);
    EXPECT_NE(fault_of_file("pipe").find("not a regular file"), std::string::npos);
    EXPECT_NE(fault_of_file("huge").find("larger than 1 MiB"), std::string::npos);
    EXPECT_NE(fault_of_file("empty").find("the case is empty"), std::string::npos);
    EXPECT_THROW((void)read_case("/dev/zero"), Error);
    EXPECT_THROW((void)read_case(""), Error);
    EXPECT_THROW((void)read_case(std::string(10000, 'x')), Error);
}

TEST_F(Files, AFileOfExactlyOneMebibyteIsRead) {
    std::string text = "name = 'long'\n";
    while (text.size() < (1U << 20)) text += '\n';
    write("large", text);
    EXPECT_EQ(read_case((folder / "large").string()).name, "long");
}

TEST_F(Files, ALinkToItselfIsRefused) {
    fs::create_symlink(folder / "loop", folder / "loop");
    EXPECT_NE(fault_of_file("loop", ExitCode::io).find("cannot be read"), std::string::npos);
}

TEST_F(Files, AByteOrderMarkAndWindowsLineEndsAreFine) {
    write("windows", "\xef\xbb\xbfname = 'x'\r\n[bed]\r\nseed = 7\r\n");
    EXPECT_EQ(read_case((folder / "windows").string()).bed.seed, 7);
}

TEST_F(BadInput, LettersOfAllLanguagesAreFineInNamesAndComments) {
    for (const std::string name :
         {"Mond-Räder", "µ = ½ §", "Łódź", "Марс", "火星 京都", "\ufb01\ufeff\ufffd", "𝜑 🚜", "\u00a0\u2003"}) {
        EXPECT_EQ(parse_case("# " + name + "\nname = \"" + name + "\" # " + name, "c").name, name);
        EXPECT_EQ(parse_case("name = '''" + name + "'''", "c").name, name);
    }
    EXPECT_EQ(parse_case("name = \"\\u00e9\\U0001F69C\"", "c").name, "é🚜");
}

// ---- nothing may end the program -----------------------------------------------------------------------------------

/// True if the text was accepted; any escape but Error fails the test.
bool survives(const std::string& text) {
    try {
        (void)parse_case(text, "c");
        return true;
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_FALSE(what.empty());
        return false;
    } catch (const std::exception& other) {
        ADD_FAILURE() << "escaped: " << other.what() << "\ntext: " << testing::PrintToString(text);
        return false;
    }
}

TEST_F(BadInput, DeepNestingDoesNotFillTheStack) {
    std::string deep = "[";
    for (int k = 0; k < 990; ++k) deep += "a.";
    deep += "a]\n";
    for (int k = 0; k < 990; ++k) deep += "b.";
    deep += "b = [{";
    std::string endless = deep;
    for (int k = 0; k < 400000; ++k) endless += "c.";
    EXPECT_FALSE(survives(endless + "c = 1}]"));
    EXPECT_FALSE(survives(deep + "c = 1}]"));
    EXPECT_FALSE(survives("x = " + std::string(1000, '[')));
    EXPECT_FALSE(survives("x = " + std::string(900, '[') + std::string(900, ']')));
    std::string tables = "x = ";
    for (int k = 0; k < 300; ++k) tables += "{a=";
    EXPECT_FALSE(survives(tables));
    std::string broken_lines = "x = ";
    for (int k = 0; k < 100000; ++k) broken_lines += "[\n";
    EXPECT_FALSE(survives(broken_lines));
}

TEST_F(BadInput, EveryByteAfterEveryTokenIsSurvived) {
    const std::vector<std::string> tokens = {"[",    "[[",     "a",        "a.",    "a=",
                                             "a=1",  "a=1.",   "a=-",      "a=0x",  "a=\"",
                                             "a='",  "a=\"\\", "a=[",      "a={",   "a=t",
                                             "a=n",  "a=1e",   "a=\"\"\"", "a='''", "a=1_",
                                             "a=0b", "\"",     "'",        "#",     "a=1979-05-27T07:32:0"};
    for (const std::string& token : tokens) {
        for (int byte = 0; byte < 256; ++byte) {
            survives(token + static_cast<char>(byte));
            survives(token + static_cast<char>(byte) + "\nb = 1");
        }
    }
}

std::string mutate(std::string text, Random& random) {
    static const std::vector<std::string> scraps = {
        "[",    "]",          "{",   "}",     "=",       "\"", "'",     "\"\"\"",     ".",
        "\n",   "nan",        "inf", "1e999", "-",       "_",  "0x",    "\\u",        "#",
        ",",    "[[",         "]]",  "true",  "base = ", "é",  "京",    "\xc3",       "\xff",
        "\x01", "1979-05-27", " ",   "\t",    "\r",      "\\", "wheel", "wheel.rim.", "99999999999999999999"};
    const std::uint64_t edits = 1 + random.below(6);
    for (std::uint64_t k = 0; k < edits && !text.empty(); ++k) {
        const std::size_t at = random.below(text.size());
        switch (random.below(5)) {
            case 0:
                text[at] = static_cast<char>(random.below(256));
                break;
            case 1:
                text.insert(at, scraps[random.below(scraps.size())]);
                break;
            case 2:
                text.erase(at, 1 + random.below(20));
                break;
            case 3:
                text.resize(at);
                break;
            default:
                text.insert(at, text.substr(random.below(text.size()), random.below(40)));
        }
    }
    return text;
}

TEST_F(BadInput, MutatedCasesAreReadOrRefusedAndNothingElse) {
    const std::string whole = to_toml(Case{});
    const std::string small =
        "name = \"x\"\n[wheel]\nload_N = 1.5e2\nrim = {poisson = 0.3, young_Pa = 1_000}\n[soil]\nradii_m = "
        "[0.002, 2.5e-3, 0.003] # mm\n";
    Random random{20260101};
    int accepted = 0;
    constexpr int trials = 6000;
    for (int k = 0; k < trials; ++k) {
        if (survives(mutate(k % 10 == 0 ? whole : small, random))) ++accepted;
    }
    EXPECT_GT(accepted, trials / 200);  // else the mutations only ever break the first byte
    EXPECT_LT(accepted, trials);
}

TEST_F(BadInput, RandomBytesAreRefused) {
    Random random{7};
    for (int k = 0; k < 2000; ++k) {
        std::string text(random.below(200), '\0');
        for (char& c : text) c = static_cast<char>(random.below(256));
        survives(text);
    }
}

}  // namespace
}  // namespace ifedem

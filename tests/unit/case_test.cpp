#include "model/case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/error.hpp"
#include "core/random.hpp"
#include "model/case_keys.hpp"

namespace ifedem {
namespace {

/// A file for the time of a test.
class Folder {
public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("ifedem_case_test_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path = path_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }

private:
    std::filesystem::path path_;
};

std::string fault_of(const std::string& text, const std::vector<Override>& overrides = {}) {
    try {
        (void)parse_case(text, "case.toml", overrides);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "no fault";
}

constexpr auto every_key = R"(
name = "all keys"
gravity_m_s2 = 3.71
time_step_s = 5e-6
integrator = "modified-euler-two"
[soil]
radii_m = [0.004, 0.005]
radii_shares = [1, 4.5]
density_kg_m3 = 2601
thickness_m = 0.11
[contact]
normal_stiffness_N_m = 1.1e5
tangential_stiffness_N_m = 2.6e4
friction_soil = 0.61
friction_wall = 0.41
friction_wheel = 0.11
consolidation_friction_soil = 0.01
consolidation_friction_wall = 0.02
damping_ratio = 0.21
rolling_factor = 1.1
rolling_chord = "half"
rolling_scheme = "sign"
contact_end = "attraction"
[bed]
length_m = 1.6
disc_count = 5000
seed = 42
walls = "discs"
[wheel]
body = "elastic"
load_N = 64.4
width_m = 0.12
rim_radius_m = 0.08
tread_radius_m = 0.14
surface_thickness_m = 0.021
lug_height_m = 0.009
lug_thickness_m = 0.0061
lug_gap_m = 0.019
lug_pairs = 11
lug_phase_deg = -7.5
rim_rings = 3
intermediate_rings = 5
surface_rings = 4
gap_columns = 6
pitch_columns = 7
plane = "strain"
damping_frame = "absolute"
mesh_file = "none.msh"
mesh_checksum = "0123456789abcdef"
[wheel.rim]
young_Pa = 2e8
poisson = 0.31
density_kg_m3 = 3001
damping_1_s = 1.1
[wheel.intermediate]
young_Pa = 3e5
poisson = 0.32
density_kg_m3 = 1001
damping_1_s = 1.2
[wheel.surface]
young_Pa = 4.1e6
poisson = 0.48
density_kg_m3 = 1002
damping_1_s = 10.1
[wheel.lug]
young_Pa = 4.2e6
poisson = 0.47
density_kg_m3 = 5001
damping_1_s = 10.2
[travel]
slip_percent = -10
speed_m_s = 0.2
acceleration_time_s = 1.5
distance_m = 0.7
start_x_m = 0.35
slip_radius = "lug-tip"
[control]
scheme = "explicit"
[control.drawbar]
proportional_N_m = 1
integral_N_m_s = 2
derivative_N_s_m = 3
[control.torque]
proportional_Nm_rad = 4
integral_Nm_rad_s = 5
derivative_Nm_s_rad = 6
[stages]
consolidation_s = 2.64
sinkage_s = 2.1
[record]
series_interval_s = 0.003
frame_interval_s = 0.26
checkpoint_interval_s = 1.25
energy_interval_s = 0
[health]
overlap_limit = 0.31
drawbar_error_limit_m = 0.03
torque_error_limit_rad = 0.2
)";

TEST(Case, EveryKeyReachesItsMember) {
    const Case c = parse_case(every_key, "all.toml");
    EXPECT_EQ(c.name, "all keys");
    EXPECT_EQ(c.gravity_m_s2, 3.71);
    EXPECT_EQ(c.time_step_s, 5e-6);
    EXPECT_EQ(c.integrator, Integrator::modified_euler_two);
    EXPECT_EQ(c.soil.radii_m, (std::vector<double>{0.004, 0.005}));
    EXPECT_EQ(c.soil.radii_shares, (std::vector<double>{1, 4.5}));
    EXPECT_EQ(c.soil.density_kg_m3, 2601);
    EXPECT_EQ(c.soil.thickness_m, 0.11);
    EXPECT_EQ(c.contact.normal_stiffness_N_m, 1.1e5);
    EXPECT_EQ(c.contact.tangential_stiffness_N_m, 2.6e4);
    EXPECT_EQ(c.contact.friction_soil, 0.61);
    EXPECT_EQ(c.contact.friction_wall, 0.41);
    EXPECT_EQ(c.contact.friction_wheel, 0.11);
    EXPECT_EQ(c.contact.consolidation_friction_soil, 0.01);
    EXPECT_EQ(c.contact.consolidation_friction_wall, 0.02);
    EXPECT_EQ(c.contact.damping_ratio, 0.21);
    EXPECT_EQ(c.contact.rolling_factor, 1.1);
    EXPECT_EQ(c.contact.rolling_chord, RollingChord::half);
    EXPECT_EQ(c.contact.rolling_scheme, RollingScheme::sign);
    EXPECT_EQ(c.contact.contact_end, ContactEnd::attraction);
    EXPECT_EQ(c.bed.length_m, 1.6);
    EXPECT_EQ(c.bed.disc_count, 5000);
    EXPECT_EQ(c.bed.seed, 42);
    EXPECT_EQ(c.bed.walls, WallKind::discs);
    EXPECT_EQ(c.wheel.body, WheelBody::elastic);
    EXPECT_EQ(c.wheel.load_N, 64.4);
    EXPECT_EQ(c.wheel.width_m, 0.12);
    EXPECT_EQ(c.wheel.rim_radius_m, 0.08);
    EXPECT_EQ(c.wheel.tread_radius_m, 0.14);
    EXPECT_EQ(c.wheel.surface_thickness_m, 0.021);
    EXPECT_EQ(c.wheel.lug_height_m, 0.009);
    EXPECT_EQ(c.wheel.lug_thickness_m, 0.0061);
    EXPECT_EQ(c.wheel.lug_gap_m, 0.019);
    EXPECT_EQ(c.wheel.lug_pairs, 11);
    EXPECT_EQ(c.wheel.lug_phase_deg, -7.5);
    EXPECT_EQ(c.wheel.rim_rings, 3);
    EXPECT_EQ(c.wheel.intermediate_rings, 5);
    EXPECT_EQ(c.wheel.surface_rings, 4);
    EXPECT_EQ(c.wheel.gap_columns, 6);
    EXPECT_EQ(c.wheel.pitch_columns, 7);
    EXPECT_EQ(c.wheel.plane, PlaneState::strain);
    EXPECT_EQ(c.wheel.damping_frame, DampingFrame::absolute);
    EXPECT_EQ(c.wheel.mesh_file, "none.msh");
    EXPECT_EQ(c.wheel.mesh_checksum, "0123456789abcdef");
    const auto expect_material = [](const MaterialCase& m, double young, double poisson, double density,
                                    double damping) {
        EXPECT_EQ(m.young_Pa, young);
        EXPECT_EQ(m.poisson, poisson);
        EXPECT_EQ(m.density_kg_m3, density);
        EXPECT_EQ(m.damping_1_s, damping);
    };
    expect_material(c.wheel.rim, 2e8, 0.31, 3001, 1.1);
    expect_material(c.wheel.intermediate, 3e5, 0.32, 1001, 1.2);
    expect_material(c.wheel.surface, 4.1e6, 0.48, 1002, 10.1);
    expect_material(c.wheel.lug, 4.2e6, 0.47, 5001, 10.2);
    EXPECT_EQ(c.travel.slip_percent, -10);
    EXPECT_EQ(c.travel.speed_m_s, 0.2);
    EXPECT_EQ(c.travel.acceleration_time_s, 1.5);
    EXPECT_EQ(c.travel.distance_m, 0.7);
    EXPECT_EQ(c.travel.start_x_m, 0.35);
    EXPECT_EQ(c.travel.slip_radius, SlipRadius::lug_tip);
    EXPECT_EQ(c.control.scheme, ControlScheme::explicit_);
    EXPECT_EQ(c.control.drawbar.proportional, 1);
    EXPECT_EQ(c.control.drawbar.integral, 2);
    EXPECT_EQ(c.control.drawbar.derivative, 3);
    EXPECT_EQ(c.control.torque.proportional, 4);
    EXPECT_EQ(c.control.torque.integral, 5);
    EXPECT_EQ(c.control.torque.derivative, 6);
    EXPECT_EQ(c.stages.consolidation_s, 2.64);
    EXPECT_EQ(c.stages.sinkage_s, 2.1);
    EXPECT_EQ(c.record.series_interval_s, 0.003);
    EXPECT_EQ(c.record.frame_interval_s, 0.26);
    EXPECT_EQ(c.record.checkpoint_interval_s, 1.25);
    EXPECT_EQ(c.record.energy_interval_s, 0);
    EXPECT_EQ(c.health.overlap_limit, 0.31);
    EXPECT_EQ(c.health.drawbar_error_limit_m, 0.03);
    EXPECT_EQ(c.health.torque_error_limit_rad, 0.2);
}

TEST(Case, EveryWordHasItsMeaning) {
    const auto read = [](const std::string& line) { return parse_case(line, "word.toml"); };
    EXPECT_EQ(read("integrator = 'symplectic-euler'").integrator, Integrator::symplectic_euler);
    EXPECT_EQ(read("integrator = 'modified-euler-one'").integrator, Integrator::modified_euler_one);
    EXPECT_EQ(read("integrator = 'modified-euler-two'").integrator, Integrator::modified_euler_two);
    EXPECT_EQ(read("contact.contact_end = 'no-attraction'").contact.contact_end, ContactEnd::no_attraction);
    EXPECT_EQ(read("contact.contact_end = 'attraction'").contact.contact_end, ContactEnd::attraction);
    EXPECT_EQ(read("contact.rolling_scheme = 'limit'").contact.rolling_scheme, RollingScheme::limit);
    EXPECT_EQ(read("contact.rolling_scheme = 'sign'").contact.rolling_scheme, RollingScheme::sign);
    EXPECT_EQ(read("contact.rolling_chord = 'full'").contact.rolling_chord, RollingChord::full);
    EXPECT_EQ(read("contact.rolling_chord = 'half'").contact.rolling_chord, RollingChord::half);
    EXPECT_EQ(read("bed.walls = 'flat'").bed.walls, WallKind::flat);
    EXPECT_EQ(read("bed.walls = 'discs'").bed.walls, WallKind::discs);
    EXPECT_EQ(read("wheel.body = 'rigid'").wheel.body, WheelBody::rigid);
    EXPECT_EQ(read("wheel.body = 'rigid-rim'").wheel.body, WheelBody::rigid_rim);
    EXPECT_EQ(read("wheel.body = 'elastic'").wheel.body, WheelBody::elastic);
    EXPECT_EQ(read("wheel.plane = 'stress'").wheel.plane, PlaneState::stress);
    EXPECT_EQ(read("wheel.plane = 'strain'").wheel.plane, PlaneState::strain);
    EXPECT_EQ(read("wheel.damping_frame = 'rigid-motion'").wheel.damping_frame, DampingFrame::rigid_motion);
    EXPECT_EQ(read("wheel.damping_frame = 'absolute'").wheel.damping_frame, DampingFrame::absolute);
    EXPECT_EQ(read("travel.slip_radius = 'tread'").travel.slip_radius, SlipRadius::tread);
    EXPECT_EQ(read("travel.slip_radius = 'lug-tip'").travel.slip_radius, SlipRadius::lug_tip);
    EXPECT_EQ(read("control.scheme = 'semi-implicit'").control.scheme, ControlScheme::semi_implicit);
    EXPECT_EQ(read("control.scheme = 'explicit'").control.scheme, ControlScheme::explicit_);
}

TEST(CaseUnits, OtherEndingsGiveTheSameBits) {
    const std::vector<std::pair<std::string, std::string>> same = {
        {"wheel.lug_height_mm = 8", "wheel.lug_height_m = 0.008"},
        {"wheel.surface_thickness_mm = 19.8", "wheel.surface_thickness_m = 0.0198"},
        {"wheel.lug_gap_cm = 1.9", "wheel.lug_gap_m = 0.019"},
        {"wheel.load_kN = 0.1701", "wheel.load_N = 170.1"},
        {"wheel.rim.young_MPa = 199.3", "wheel.rim.young_Pa = 199.3e6"},
        {"wheel.lug.young_GPa = 0.0041", "wheel.lug.young_Pa = 0.0041e9"},
        {"wheel.lug.young_kPa = 4100", "wheel.lug.young_Pa = 4.1e6"},
        {"soil.density_g_cm3 = 2.63", "soil.density_kg_m3 = 2630"},
        {"soil.radii_mm = [2.1, 2.7, 3]", "soil.radii_m = [0.0021, 0.0027, 0.003]"},
        {"contact.normal_stiffness_N_mm = 101.3", "contact.normal_stiffness_N_m = 101300"},
        {"contact.normal_stiffness_kN_m = 101.3", "contact.normal_stiffness_N_m = 101300"},
        {"travel.speed_cm_s = 9.7", "travel.speed_m_s = 0.097"},
        {"travel.speed_mm_s = 97e0", "travel.speed_m_s = 0.097"},
        {"record.series_interval_ms = 2.3", "record.series_interval_s = 0.0023"},
        {"time_step_us = 41", "time_step_s = 41e-6"},
    };
    for (const auto& [other, own] : same)
        EXPECT_EQ(to_toml(parse_case(other, "a")), to_toml(parse_case(own, "b"))) << other;
    EXPECT_EQ(parse_case("name = 'x'", "c", {{"wheel.lug_height_mm", "8"}}).wheel.lug_height_m, 0.008);
    EXPECT_THROW((void)parse_case("wheel.load_N = 1\nwheel.load_kN = 1", "c"), Error);
    EXPECT_THROW((void)parse_case("wheel.load_mm = 1", "c"), Error) << "no key of that name";
}

struct Extent {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Extent extent_of(const Case& c, const Slot& slot) {
    const auto at = [&c](const void* member, std::size_t size) {
        const auto begin =
            static_cast<std::size_t>(static_cast<const char*>(member) - reinterpret_cast<const char*>(&c));
        return Extent{begin, begin + size};
    };
    if (const auto* choice = std::get_if<ChoiceSlot>(&slot)) return at(choice->member, sizeof(int));
    if (const auto* number = std::get_if<double*>(&slot)) return at(*number, sizeof(double));
    if (const auto* whole = std::get_if<std::int64_t*>(&slot)) return at(*whole, sizeof(std::int64_t));
    if (const auto* text = std::get_if<std::string*>(&slot)) return at(*text, sizeof(std::string));
    return at(std::get<std::vector<double>*>(slot), sizeof(std::vector<double>));
}

TEST(CaseKeys, CoverEveryMemberOnce) {
    // Slots laid side by side must fill the case up to alignment: a member without a key leaves a hole.
    Case c;
    std::vector<Extent> extents;
    for (const Key& key : case_keys()) extents.push_back(extent_of(c, key.slot(c)));
    std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) { return a.begin < b.begin; });
    std::size_t end = 0;
    for (const Extent& extent : extents) {
        EXPECT_GE(extent.begin, end) << "two keys for one member";
        EXPECT_LT(extent.begin - end, 8U) << "a member without a key at byte " << end;
        end = extent.end;
    }
    EXPECT_LT(sizeof(Case) - end, 8U);
}

TEST(CaseKeys, DefaultsSatisfyTheirOwnRangesAndRules) {
    EXPECT_NO_THROW((void)parse_case(to_toml(Case{}), "defaults.toml"));
}

TEST(CaseKeys, NamesEndInTheirUnit) {
    const std::vector<std::pair<std::string, std::string>> endings = {{"m", "_m"},
                                                                      {"s", "_s"},
                                                                      {"N", "_N"},
                                                                      {"Pa", "_Pa"},
                                                                      {"m/s", "_m_s"},
                                                                      {"m/s²", "_m_s2"},
                                                                      {"kg/m³", "_m3"},
                                                                      {"N/m", "_N_m"},
                                                                      {"1/s", "_1_s"},
                                                                      {"%", "_percent"},
                                                                      {"°", "_deg"},
                                                                      {"rad", "_rad"},
                                                                      {"N/(m s)", "_N_m_s"},
                                                                      {"N s/m", "_N_s_m"},
                                                                      {"N m/rad", "_Nm_rad"},
                                                                      {"N m/(rad s)", "_Nm_rad_s"},
                                                                      {"N m s/rad", "_Nm_s_rad"}};
    std::set<std::string_view> names;
    for (const Key& key : case_keys()) {
        EXPECT_TRUE(names.insert(key.name).second) << key.name;
        EXPECT_FALSE(key.meaning.empty()) << key.name;
        if (key.unit.empty() || key.unit == "-") continue;
        const auto ending =
            std::find_if(endings.begin(), endings.end(), [&key](const auto& e) { return e.first == key.unit; });
        ASSERT_NE(ending, endings.end()) << key.name << " has the unknown unit " << key.unit;
        EXPECT_TRUE(key.name.ends_with(ending->second)) << key.name << " in " << key.unit;
    }
}

// ---- writing and reading back --------------------------------------------------------------------------------------

/// Other bits in every value, yet near enough to the default to satisfy all rules.
Case vary(std::uint64_t seed) {
    Case c;
    Random random{seed};
    const auto near = [&random](double value) {
        const double factor = 1.0 + 1e-3 * (random.uniform() - 0.5);
        return value == 0.0 ? std::ldexp(random.uniform(), -static_cast<int>(random.below(1060))) : value * factor;
    };
    for (const Key& key : case_keys()) {
        const Slot slot = key.slot(c);
        if (const auto* number = std::get_if<double*>(&slot)) **number = near(**number);
        if (const auto* whole = std::get_if<std::int64_t*>(&slot))
            **whole += static_cast<std::int64_t>(random.below(2));
        if (const auto* text = std::get_if<std::string*>(&slot))
            **text = "µ \"quoted\" \\ # = [" + std::to_string(seed);
        if (const auto* list = std::get_if<std::vector<double>*>(&slot)) {
            for (double& value : **list) value = near(value);
        }
        if (const auto* choice = std::get_if<ChoiceSlot>(&slot)) {
            choice->set(choice->member, static_cast<int>(random.below(choice->words.size())));
        }
    }
    c.elements.columns *= 2;  // the rules: blocks end at the wall, and blocks of discs are among them
    c.elements.block_length_m = 0.5 * c.bed.length_m;
    if (c.elements.columns > 0) c.bed.walls = WallKind::flat, c.bed.levelled_count = 0;
    return c;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same_value(const Slot& a, const Slot& b) {
    if (const auto* choice = std::get_if<ChoiceSlot>(&a)) {
        return choice->get(choice->member) == choice->get(std::get<ChoiceSlot>(b).member);
    }
    if (const auto* number = std::get_if<double*>(&a)) return same_bits(**number, *std::get<double*>(b));
    if (const auto* whole = std::get_if<std::int64_t*>(&a)) return **whole == *std::get<std::int64_t*>(b);
    if (const auto* text = std::get_if<std::string*>(&a)) return **text == *std::get<std::string*>(b);
    const std::vector<double>& left = *std::get<std::vector<double>*>(a);
    const std::vector<double>& right = *std::get<std::vector<double>*>(b);
    return std::equal(left.begin(), left.end(), right.begin(), right.end(), same_bits);
}

void expect_same(Case& a, Case& b) {
    for (const Key& key : case_keys()) ASSERT_TRUE(same_value(key.slot(a), key.slot(b))) << key.name;
}

TEST(CaseWriter, WhatItWritesReadsBackToTheLastBit) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        Case original = vary(seed);
        const std::string text = to_toml(original);
        Case again = parse_case(text, "again.toml");
        expect_same(original, again);
        ASSERT_EQ(to_toml(again), text);
    }
}

TEST(CaseWriter, KeepsAwkwardNumbers) {
    Case c;
    c.wheel.lug_phase_deg = -0.0;
    c.contact.consolidation_friction_soil = 5e-324;
    c.contact.consolidation_friction_wall = 2.2250738585072011e-308;
    c.wheel.rim.young_Pa = 123456789012345.67;
    c.wheel.lug.young_Pa = 1e15;
    c.contact.friction_soil = 0.1 + 0.2;
    c.bed.seed = 9000000000000000;
    Case again = parse_case(to_toml(c), "awkward.toml");
    expect_same(c, again);
    EXPECT_TRUE(std::signbit(again.wheel.lug_phase_deg));
}

TEST(CaseWriter, StatesEveryKeyWithItsUnitAndMeaning) {
    std::string text = "\n";
    text += to_toml(Case{});
    EXPECT_NE(text.find("[wheel.intermediate]\n"), std::string::npos);
    for (const Key& key : case_keys()) {
        EXPECT_NE(text.find(fmt::format("\n{} = ", leaf_of(key.name))), std::string::npos) << key.name;
        EXPECT_NE(text.find(key.meaning), std::string::npos) << key.name;
        EXPECT_NE(text.find(key.unit), std::string::npos) << key.name;
    }
}

TEST(CaseWriter, SubsetHoldsTheAskedKeysAndNoOthers) {
    Case c;
    c.name = "x";
    c.gravity_m_s2 = 9.81;
    c.time_step_s = 4e-5;
    c.bed = {1.5, 19468, 1, WallKind::flat, 0};
    c.wheel.lug.young_Pa = 4e6;
    EXPECT_EQ(
        to_toml_subset(c, {"bed"}),
        "bed.length_m = 1.5\nbed.disc_count = 19468\nbed.seed = 1\nbed.walls = \"flat\"\nbed.levelled_count = 0\n");
    EXPECT_EQ(to_toml_subset(c, {"bed.seed", "gravity_m_s2"}), "gravity_m_s2 = 9.81\nbed.seed = 1\n");
    EXPECT_EQ(to_toml_subset(c, {"gravity_m_s2", "bed.seed", "bed.seed"}), "gravity_m_s2 = 9.81\nbed.seed = 1\n");
    EXPECT_EQ(to_toml_subset(c, {""}),
              "name = \"x\"\ngravity_m_s2 = 9.81\ntime_step_s = 4e-05\nintegrator = \"symplectic-euler\"\n");
    const std::string wheel = to_toml_subset(c, {"wheel"});
    EXPECT_NE(wheel.find("wheel.lug.young_Pa = 4000000.0\n"), std::string::npos);
    EXPECT_EQ(wheel.find("bed."), std::string::npos);
    EXPECT_EQ(to_toml_subset(c, {}), "");
    EXPECT_THROW((void)to_toml_subset(c, {"whel"}), Error);
    EXPECT_THROW((void)to_toml_subset(c, {"whee"}), Error);
}

TEST(CaseWriter, SubsetFollowsEachOfItsValues) {
    for (const Key& key : case_keys()) {
        Case c;
        Case other = vary(1);
        const std::vector<std::string> only{std::string(key.name)};
        const bool same = same_value(key.slot(c), key.slot(other));
        EXPECT_EQ(to_toml_subset(c, only) == to_toml_subset(other, only), same) << key.name;
    }
}

TEST(CaseManual, NamesEveryKey) {
    const std::string manual = describe_keys();
    for (const Key& key : case_keys()) {
        EXPECT_NE(manual.find(fmt::format("  {} ", leaf_of(key.name))), std::string::npos) << key.name;
        EXPECT_NE(manual.find(fmt::format("{}\n      {}", describe_range(key), key.meaning)), std::string::npos)
            << key.name;
    }
    EXPECT_NE(manual.find("[control.torque]"), std::string::npos);
}

// ---- base cases ----------------------------------------------------------------------------------------------------

TEST(CaseBase, GivesTheDefaultsOfTheFileThatNamesIt) {
    const Folder folder;
    folder.write("common/earth.toml", "name = 'earth'\n[wheel]\nload_N = 130\nwidth_m = 0.2\n");
    folder.write("common/mars.toml", "base = 'earth.toml'\ngravity_m_s2 = 3.71\nwheel.load_N = 64.4\n");
    const std::string path = folder.write("slip.toml", "base = 'common/mars.toml'\ntravel.slip_percent = 30\n");
    const Case c = read_case(path);
    EXPECT_EQ(c.name, "earth");
    EXPECT_EQ(c.gravity_m_s2, 3.71);
    EXPECT_EQ(c.wheel.load_N, 64.4);
    EXPECT_EQ(c.wheel.width_m, 0.2);
    EXPECT_EQ(c.travel.slip_percent, 30);
    EXPECT_EQ(c.time_step_s, Case{}.time_step_s);  // stated by none
    EXPECT_EQ(to_toml(c).find("base"), std::string::npos);
}

TEST(CaseBase, RulesHoldForTheResolvedCaseOnly) {
    // The base alone would not do: its three radii have two shares.
    const Folder folder;
    folder.write("base.toml", "soil.radii_m = [0.002, 0.003, 0.004]\nsoil.radii_shares = [1, 2]\n");
    const std::string path = folder.write("case.toml", "base = 'base.toml'\nsoil.radii_m = [0.002, 0.003]\n");
    EXPECT_EQ(read_case(path).soil.radii_m.size(), 2U);
}

TEST(CaseBase, FaultsAreNamedInTheFileWhereTheyStand) {
    const Folder folder;
    const std::string base = folder.write("base.toml", "name = 'b'\nwheel.load = 3\n");
    const std::string path = folder.write("case.toml", "base = 'base.toml'\n\ngravity_m_s2 = 'much'\n");
    try {
        (void)read_case(path);
        FAIL() << "no fault";
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(base + ":2:"), std::string::npos) << what;
        EXPECT_NE(what.find(path + ":3:16: gravity_m_s2 is a text"), std::string::npos) << what;
    }
}

TEST(CaseBase, CirclesAndAbsentBasesAreFaults) {
    const Folder folder;
    const std::string a = folder.write("a.toml", "base = 'b.toml'\n");
    folder.write("b.toml", "base = './x/../a.toml'\n");
    const std::string self = folder.write("self.toml", "base = 'self.toml'\n");
    const std::string absent = folder.write("absent.toml", "\nbase = 'nowhere.toml'\n");
    const auto fault = [](const std::string& path) -> std::string {
        try {
            (void)read_case(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "no fault";
    };
    EXPECT_NE(fault(a).find("b.toml:1:8: base = \"./x/../a.toml\" leads back to itself"), std::string::npos)
        << fault(a);
    EXPECT_NE(fault(self).find("leads back to itself"), std::string::npos);
    EXPECT_NE(fault(absent).find("absent.toml:2:8: base = \"nowhere.toml\": there is no such file"), std::string::npos)
        << fault(absent);
}

TEST(CaseRules, RefuseWhatHasNoMeaning) {
    EXPECT_NE(fault_of("contact.tangential_stiffness_N_m = 0").find("Set the frictions to 0"), std::string::npos);
    const std::string blocks =
        "bed.length_m = 2.4\ntime_step_s = 4e-5\n"
        "elements = { columns = 16, block_length_m = 0.15, first_disc_column = 3, disc_columns = 5, pattern_s = ";
    EXPECT_NO_THROW((void)parse_case(blocks + "0.0081 }", "c.toml"));  // a step of 4 µs: 1/100 of the mass
    EXPECT_NE(fault_of(blocks + "0.0079 }").find("prepared in 1975 steps"), std::string::npos);
    EXPECT_NE(fault_of(blocks + "0.0079 }").find("Raise it to 0.008 s or more?"), std::string::npos);
}

// ---- --set ---------------------------------------------------------------------------------------------------------

TEST(CaseOverride, WinsOverTheFileAndLaterOverEarlier) {
    const Case c =
        parse_case("wheel.load_N = 50\nbed.seed = 2", "c.toml",
                   {{"wheel.load_N", "70"}, {"bed.seed", "3"}, {"bed.seed", "4"}, {"wheel.rim.young_Pa", "1e8"}});
    EXPECT_EQ(c.wheel.load_N, 70);
    EXPECT_EQ(c.bed.seed, 4);
    EXPECT_EQ(c.wheel.rim.young_Pa, 1e8);
}

TEST(CaseOverride, TakesWordsWithAndWithoutQuotesAndLists) {
    const Case c = parse_case("name = 'x'", "c.toml",
                              {{"control.scheme", "explicit"},
                               {"wheel.body", "\"elastic\""},
                               {"name", "123"},
                               {"soil.radii_m", "[0.004, 0.005]"},
                               {"soil.radii_shares", "[1,1]"}});
    EXPECT_EQ(c.control.scheme, ControlScheme::explicit_);
    EXPECT_EQ(c.wheel.body, WheelBody::elastic);
    EXPECT_EQ(c.name, "123");
    EXPECT_EQ(c.soil.radii_m, (std::vector<double>{0.004, 0.005}));
}

TEST(CaseOverride, CanMendAFaultyRuleButNotAFaultyValue) {
    EXPECT_EQ(parse_case("wheel.lug_pairs = 40", "c.toml", {{"wheel.lug_pairs", "10"}}).wheel.lug_pairs, 10);
    EXPECT_NE(fault_of("wheel.lug_pairs = -1", {{"wheel.lug_pairs", "10"}}).find("out of range"), std::string::npos);
}

TEST(CaseOverride, FaultsNameTheSetting) {
    const auto expect = [](const Override& setting, const std::string& message) {
        const std::string fault = fault_of("name = 'x'", {setting});
        EXPECT_EQ(fault.rfind("--set " + setting.key + "=" + setting.value + ": " + message, 0), 0U) << fault;
    };
    expect({"wheel.load", "3"},
           "unknown key wheel.load (a key ends in its unit, and values are in SI units). Did you mean wheel.load_N?");
    expect({"wheel.load_N", "-3"}, "wheel.load_N = -3 is out of range");
    expect({"wheel.load_N", "heavy"}, "wheel.load_N is a text (it must be a number, in N)");
    expect({"wheel.load_N", "[3"}, "the value is not TOML");
    expect({"wheel.load_N", ""}, "the value is not TOML");
    expect({"bed.seed", "2.0"}, "bed.seed is a number with a fraction (it must be a whole number)");
    expect({"control.scheme", "implicit"},
           "control.scheme = \"implicit\" is not known (it may be semi-implicit | explicit | prescribed)");
    expect({"wheel", "3"}, "wheel is a table");
    expect({"base", "x.toml"}, "base belongs into the file");
    expect({"", "3"}, "unknown key");
    EXPECT_NE(fault_of("name = 'x'", {{"bed.seed", "2\nwheel.load_N = 3"}}).find("not one line of text"),
              std::string::npos);
    EXPECT_NE(
        fault_of("name = 'x'", {{"wheel.lug_pairs", "40"}}).find("--set wheel.lug_pairs=40: the lug pairs do not fit"),
        std::string::npos);
}

// A case that is committed can be read where it stands, whatever its base is.
TEST(CommittedCases, can_be_read) {
    namespace fs = std::filesystem;
    int read = 0;
    for (const char* folder : {"reproductions", "reports", "tests"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(fs::path(IFEDEM_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != ".toml") continue;
            EXPECT_NO_THROW((void)read_case(entry.path().string())) << entry.path();
            ++read;
        }
    EXPECT_GE(read, 20);
}

}  // namespace
}  // namespace ifedem

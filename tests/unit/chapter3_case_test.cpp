// The cases of chapter 3 against every input that it prints (Tables 3-1 to 3-4, sections 3.2 to 3.4). Each input row of
// the ledger stands in one of three ways: the cases hold it as printed, a case deviates from it by a choice of
// choices.csv, or it is nothing that a case could hold.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "check/csv.hpp"
#include "check/ledger.hpp"
#include "check/metrics.hpp"
#include "dem/dem_constants.hpp"
#include "fem/mesh.hpp"
#include "model/case.hpp"

namespace ifedem {
namespace {

const std::vector<std::string> all{"whole", "B3-earth", "B6-earth", "B3-mars", "B6-mars"};
const std::vector<std::string> fitted{"B3-earth", "B6-earth", "B3-mars", "B6-mars"};
const std::string chapter = IFEDEM_SOURCE_DIR "/reproductions/chapter3/";

std::string join(const std::vector<double>& numbers) {
    std::string text;
    for (const double x : numbers) text += fmt::format("{}{:.9g}", text.empty() ? "" : ";", x);
    return text;
}

/// All numbers of a text without their signs: "24 (12x2)" and "40-80" have three and two.
std::vector<double> numbers_in(std::string_view text) {
    std::vector<double> numbers;
    const char *at = text.data(), *const end = at + text.size();
    while (at != end) {
        double number = 0;
        const bool starts = *at >= '0' && *at <= '9';
        at = starts ? std::from_chars(at, end, number).ptr : at + 1;
        if (starts) numbers.push_back(number);
    }
    return numbers;
}

/// What follows `NAME := ` in a makefile of the chapter.
std::string variable(const std::string& makefile, const std::string& name) {
    const std::string text = "\n" + read_text(chapter + makefile), start = "\n" + name + " := ";
    const std::size_t at = text.find(start);
    EXPECT_NE(at, std::string::npos) << makefile << " has no " << name;
    if (at == std::string::npos) return "";
    const std::size_t begin = at + start.size();
    return text.substr(begin, text.find('\n', begin) - begin);
}

std::vector<double> sorted(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

/// The value of a key that is a word.
std::string word(const Case& c, const std::string& key) { return split(to_toml_subset(c, {key}), '"').at(1); }

struct NamedCase {
    std::string name;
    Case c;
    [[nodiscard]] bool is(std::string_view part) const { return name.find(part) != std::string::npos; }
};

NamedCase read_named(const std::string& name, const std::vector<Override>& overrides = {}) {
    return {name, read_case(chapter + "cases/" + name + ".toml", overrides)};
}

const std::vector<NamedCase>& cases() {
    static const std::vector<NamedCase> read = [] {
        std::vector<NamedCase> each;
        for (const std::string& name : all) each.push_back(read_named(name));
        return each;
    }();
    return read;
}

bool any(const NamedCase&) { return true; }
bool mars(const NamedCase& s) { return s.is("mars"); }
bool earth(const NamedCase& s) { return !mars(s); }
bool b6(const NamedCase& s) { return s.is("B6"); }
bool b3(const NamedCase& s) { return !b6(s); }

std::string young_MPa(const Case& c) {
    const WheelCase& w = c.wheel;
    return join(
        {1e-6 * w.rim.young_Pa, 1e-6 * w.intermediate.young_Pa, 1e-6 * w.surface.young_Pa, 1e-6 * w.lug.young_Pa});
}

std::string poisson(const Case& c) {
    const WheelCase& w = c.wheel;
    return join({w.rim.poisson, w.intermediate.poisson, w.surface.poisson, w.lug.poisson});
}

std::string window_cm(Case c, double slip_percent) {
    c.travel.slip_percent = slip_percent;
    const Window w = averaging_window(c);
    return join({1e2 * w.from_m, 1e2 * w.to_m});
}

struct Input {
    std::string id;
    bool (*applies_to)(const NamedCase&);
    std::string (*held)(const Case&);
    std::string printed = "";  ///< empty: the numbers of the ledger's value; else what its words say
};

const std::vector<Input> inputs{
    {"D019", any, [](const Case& c) { return word(c, "control.scheme"); }, "explicit"},
    {"D020", any, [](const Case& c) { return word(c, "control.scheme"); }, "explicit"},
    {"D025", any, [](const Case& c) { return word(c, "travel.slip_radius"); }, "effective"},
    {"D026", any, [](const Case& c) { return join({static_cast<double>(make_wheel_mesh(c.wheel).mesh.quad.size())}); }},
    {"D027", any,
     [](const Case& c) { return join({static_cast<double>(make_wheel_mesh(c.wheel).mesh.node_m.size())}); }},
    {"D033", any,
     [](const Case& c) { return fmt::format("{} {}", c.contact.rolling_factor, word(c, "contact.rolling_chord")); },
     "1 full"},
    {"D034", any,
     [](const Case& c) { return join({c.travel.speed_of == SpeedOf::hub ? 1e3 * c.travel.speed_m_s : 0.0}); }},
    {"D037", any,
     [](const Case&) {
         const std::vector<double> slips = numbers_in(variable("chapter.mk", "SLIPS"));
         return join({slips.at(0), slips.at(1), slips.back()});
     }},
    {"D038", earth,
     [](const Case& c) {
         return join({sorted(numbers_in(variable("chapter.mk", "LOADS"))).at(0), c.wheel.load_N});
     }},
    {"D039", any, [](const Case& c) { return join({static_cast<double>(c.bed.disc_count)}); }},
    {"D040", any,
     [](const Case& c) {
         return join({1e3 * c.soil.radii_m[0], 1e3 * c.soil.radii_m[1], 1e3 * c.soil.radii_m[2]});
     }},
    {"D041", earth, [](const Case& c) { return join({c.time_step_s}); }},
    {"D044", any,
     [](const Case& c) {
         const DemConstants k = make_dem_constants(c, c.contact.friction_soil, c.contact.friction_wall);
         return fmt::format("discs {}, wheel {}", k.soil.rolling_chords, k.wheel.rolling_chords);
     },
     "discs 1, wheel 1"},
    // One number for soil on soil and soil on walls; none is negative.
    {"D045", any,
     [](const Case& c) {
         return join({std::max(c.contact.consolidation_friction_soil, c.contact.consolidation_friction_wall)});
     }},
    {"D046", any, [](const Case& c) { return join({2e3 * (c.wheel.tread_radius_m + c.wheel.lug_height_m)}); }},
    {"D047", any, [](const Case& c) { return join({2e3 * c.wheel.rim_radius_m}); }},
    {"D048", any, [](const Case& c) { return join({1e3 * c.wheel.width_m}); }},
    {"D049", any, [](const Case&) { return join(sorted(numbers_in(variable("chapter.mk", "LOADS")))); }},
    {"D050", any,
     [](const Case& c) {
         const auto pairs = static_cast<double>(c.wheel.lug_pairs);
         return join({2 * pairs, pairs, 2});
     }},
    {"D051", any, [](const Case& c) { return join({1e3 * c.wheel.lug_height_m}); }},
    // The 10 mm/s are the experiment's.
    {"D053", any,
     [](const Case& c) {
         return join({10, 1e3 * c.travel.speed_m_s});
     }},
    {"D054", any, [](const Case& c) { return join({1e3 * c.travel.distance_m}); }},
    {"D055", b3, young_MPa},
    {"D056", b6, young_MPa},
    {"D057", b3, poisson},
    {"D058", b6, poisson},
    {"D059", any,
     [](const Case& c) {
         const WheelCase& w = c.wheel;
         return join({w.rim.density_kg_m3, w.intermediate.density_kg_m3, w.surface.density_kg_m3, w.lug.density_kg_m3,
                      c.soil.density_kg_m3});
     }},
    // One key for all three kinds of contact: wheel, discs, walls.
    {"D060", any,
     [](const Case& c) {
         const double kn = 1e-3 * c.contact.normal_stiffness_N_m;
         return join({kn, kn, kn});
     }},
    {"D061", any,
     [](const Case& c) {
         const double ks = 1e-3 * c.contact.tangential_stiffness_N_m;
         return join({ks, ks, ks});
     }},
    {"D062", any,
     [](const Case& c) {
         const ContactCase& k = c.contact;
         return join({k.friction_wheel, k.friction_soil, k.consolidation_friction_soil, k.friction_wall,
                      k.consolidation_friction_wall});
     }},
    {"D063", any, [](const Case& c) { return join({c.control.drawbar.proportional}); }},
    {"D064", any, [](const Case& c) { return join({c.control.drawbar.integral}); }},
    {"D065", any, [](const Case& c) { return join({c.control.drawbar.derivative}); }},
    {"D066", any, [](const Case& c) { return join({c.control.torque.proportional}); }},
    {"D067", any, [](const Case& c) { return join({c.control.torque.integral}); }},
    {"D068", any, [](const Case& c) { return join({c.control.torque.derivative}); }},
    {"D069", earth, [](const Case& c) { return join({c.stages.consolidation_s}); }},
    {"D070", earth, [](const Case& c) { return join({c.stages.sinkage_s}); }},
    {"D071", any, [](const Case& c) { return join({c.travel.acceleration_time_s}); }},
    {"D072", any, [](const Case& c) { return join({1e2 * c.travel.distance_m}); }},
    {"D073", any, [](const Case& c) { return window_cm(c, 60); }},
    {"D074", any, [](const Case& c) { return window_cm(c, 70); }},
    {"D103", mars, [](const Case& c) { return join({c.wheel.load_N}); }},
    {"D104", mars, [](const Case& c) { return join({c.stages.consolidation_s}); }},
    {"D105", mars, [](const Case& c) { return join({c.stages.sinkage_s}); }},
    {"D106", mars, [](const Case& c) { return join({c.time_step_s}); }},
    {"D124", any, [](const Case& c) { return join({1e3 * (c.wheel.tread_radius_m + c.wheel.lug_height_m)}); }},
};

struct Deviation {
    std::string id;
    std::vector<std::string> in;  ///< cases
    std::string held;
    std::string choice;  ///< a key of choices.csv
    std::string reason;
};

const std::vector<Deviation> deviates{
    {"D019", all, "semi-implicit", "control.scheme",
     "with the error at the beginning of a step the loop is stable only below 2 m/K_d; both forms converge to one "
     "motion"},
    {"D020", all, "semi-implicit", "control.scheme", "as D019, below 2 J/K_d"},
    {"D025", all, "tread", "travel.slip_radius",
     "r_e follows from the slip; the unloaded radius is the one length known before a run"},
    {"D026",
     {"whole"},
     "312",
     "wheel.rim_rings",
     "493 quads cannot have 444 nodes; of the 444 that they are read as, a rigid rim takes 2 rings of 48 and the core "
     "of 36"},
    {"D026", fitted, "264", "wheel.rim_rings", "a ring of 48 less in the intermediate layer: nothing moves by 5 %"},
    {"D027", {"whole"}, "384", "wheel.rim_rings", "as D026: 493 without 2 rings of 48 and the core's 13"},
    {"D027", fitted, "336", "wheel.rim_rings", "as D026"},
    {"D039", fitted, "12834", "bed.disc_count", "three quarters of the depth in a shorter bin: nothing moves by 5 %"},
    {"D041",
     {"whole"},
     "4e-05",
     "time_step_s",
     "a rigid rim under semi-implicit control leaves the contacts' limit alone"},
    {"D041", {"B3-earth", "B6-earth"}, "8e-05", "time_step_s", "twice that of the whole scene: nothing moves by 5 %"},
    {"D106", {"B3-mars", "B6-mars"}, "8e-05", "time_step_s", "as on Earth"},
};

const std::map<std::string, std::string> no_key{
    {"D021", "which angle the torque's loop sees is the program's; all nodes of a rigid rim turn by the same"},
    {"D022", "how H follows from T: metrics.hpp, after the run"},
    {"D023", "the sign of P_d: the series has −P"},
    {"D024", "how R follows from H and P: metrics.hpp, after the run"},
    {"D028", "how the stiffness follows from load and deflection: `ifedem stiffness`"},
    {"D100", "how the deflection follows from the least radius: metrics.hpp, after the run"},
};

const Ledger& ledger() {
    static const Ledger rows = read_ledger(IFEDEM_SOURCE_DIR);
    return rows;
}

const Deviation* find_deviation(const std::string& id, const std::string& name) {
    for (const Deviation& d : deviates)
        if (d.id == id && std::find(d.in.begin(), d.in.end(), name) != d.in.end()) return &d;
    return nullptr;
}

TEST(Chapter3Case, uses_the_printed_inputs_or_deviates_as_listed) {
    std::size_t listed = 0, met = 0;
    for (const Deviation& d : deviates) listed += d.in.size();
    for (const Input& input : inputs) {
        const std::string printed =
            input.printed.empty() ? join(numbers_in(ledger().at(input.id).value)) : input.printed;
        ASSERT_FALSE(printed.empty()) << input.id;
        for (const NamedCase& one : cases()) {
            if (!input.applies_to(one)) continue;
            const std::string held = input.held(one.c);
            const Deviation* const d = find_deviation(input.id, one.name);
            EXPECT_EQ(held, d ? d->held : printed) << input.id << " in " << one.name << (d ? ": " + d->reason : "");
            if (!d) continue;
            ++met;
            EXPECT_NE(held, printed) << input.id << " in " << one.name << " is as printed: no deviation any more";
        }
    }
    // Also a deviation of a case or row that is not compared is out of date.
    EXPECT_EQ(met, listed);
}

TEST(Chapter3Case, every_input_row_is_held_or_deviates_or_has_no_key) {
    std::set<std::string> compared, deviating;
    for (const Input& input : inputs) EXPECT_TRUE(compared.insert(input.id).second) << input.id << " stands twice";
    for (const Deviation& d : deviates) deviating.insert(d.id);
    std::set<std::string> left = compared;
    for (const auto& [id, reason] : no_key) EXPECT_TRUE(left.insert(id).second) << id << " is compared and has no key";
    for (const std::string& id : deviating) EXPECT_TRUE(compared.count(id)) << id << " deviates and is not compared";
    for (const auto& [id, row] : ledger()) {
        if (row.chapter != 3 || row.kind != "input") continue;
        EXPECT_EQ(left.erase(id), 1U) << id << " (" << row.quantity << ") is in none of the lists";
    }
    EXPECT_TRUE(left.empty()) << *left.begin() << " is no input of chapter 3";
}

TEST(Chapter3Case, every_deviation_is_a_stated_choice) {
    const CsvTable choices = read_csv(chapter + "choices.csv");
    std::set<std::string> keys;
    for (const CsvRow& row : choices.rows)
        for (const std::string& key : split(row.cells[choices.require("key")], ' ')) keys.insert(key);
    for (const Deviation& d : deviates) EXPECT_TRUE(keys.count(d.choice)) << d.id << ": " << d.choice;
}

TEST(Chapter3Case, conditions_of_the_printed_inputs_hold) {
    for (const NamedCase& s : cases())  // "3:2:1 by number"
        EXPECT_EQ(s.c.soil.radii_shares, numbers_in(ledger().at("D040").condition)) << s.name;
    const std::vector<double> slips = numbers_in(variable("chapter.mk", "SLIPS"));
    EXPECT_EQ(slips.size(), numbers_in(ledger().at("D037").condition).at(0));  // "8 levels"
    for (std::size_t k = 1; k < slips.size(); ++k) EXPECT_EQ(slips[k] - slips[k - 1], slips[1] - slips[0]);
}

// The sweep names a run by its load and sets it; the cases' own load must be among them.
TEST(Chapter3Case, sweep_has_the_load_of_each_case) {
    const std::string makefile = read_text(chapter + "chapter.mk");
    for (const std::string& name : fitted) {
        const double load_N = read_named(name).c.wheel.load_N;
        EXPECT_NE(makefile.find(fmt::format("{}-{:g}N", name, load_N)), std::string::npos) << name;
    }
}

TEST(Chapter3Case, whole_scene_of_the_makefiles_is_that_of_the_case) {
    std::vector<Override> sets;
    for (const std::string& part : split(variable("whole.mk", "WHOLE"), ' ')) {
        const std::size_t equals = part.find('=');
        if (equals != std::string::npos) sets.push_back({part.substr(0, equals), part.substr(equals + 1)});
    }
    ASSERT_FALSE(sets.empty());
    for (const Override& change : list_changes(read_named("whole").c, read_named("B3-earth", sets).c))
        ADD_FAILURE() << change.key << " = " << change.value;
}

// Only FIDELITY=dissertation takes the printed steps: $(if $(filter mars,…),MARS,EARTH).
TEST(Chapter3Case, fidelity_run_takes_the_printed_steps) {
    const std::vector<std::string> parts = split(variable("chapter.mk", "TEXT_STEP"), ',');
    ASSERT_GE(parts.size(), 2U);
    EXPECT_EQ(numbers_in(parts[parts.size() - 2]), numbers_in(ledger().at("D106").value));
    EXPECT_EQ(numbers_in(parts[parts.size() - 1]), numbers_in(ledger().at("D041").value));
}

}  // namespace
}  // namespace ifedem

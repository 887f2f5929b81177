#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>

namespace {
/// A function, for gcc refuses a bare throw where toml++ asserts in a noexcept function.
[[noreturn]] void fail_toml(const char* expression) { throw std::logic_error(expression); }
}  // namespace

// toml++ 3.3.0 asserts on some malformed input. find_bad_text() turns away what is known to do so; should anything be
// left, its assertions throw here (header-only, this file only) and become an ordinary fault.
#undef NDEBUG
#define TOML_HEADER_ONLY 1
#define TOML_MAX_NESTED_VALUES 4  // no key needs more than 1; each level may hold a line's worth of nested tables
#define TOML_ASSERT(expr) ((expr) ? static_cast<void>(0) : fail_toml(#expr))
#include <toml++/toml.h>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "model/case_advice.hpp"
#include "model/case_checks.hpp"
#include "model/case_keys.hpp"
#include "model/case_text.hpp"
#include "model/case_units.hpp"

namespace ifedem {
namespace {

constexpr std::size_t most_faults = 200;  // more only says that it is the wrong file
constexpr std::size_t longest_list = 32;  // so that a list keeps on one line
constexpr std::size_t longest_text = 200;
constexpr std::size_t longest_path = 1500;
constexpr std::size_t largest_mesh = std::size_t{64} << 20;
constexpr std::string_view base_key = "base";
constexpr std::string_view mesh_file_key = "wheel.mesh_file";

struct Fault {
    toml::source_position at;
    std::string message;
};

/// What reading gathers: the case so far, where each value came from, and all that was wrong.
struct Reading {
    Case value;
    std::map<std::string_view, std::string> origin;  ///< "file:line:column" or "--set …" of the keys that were given
    std::set<std::string_view> faulty;               ///< keys whose value could not be taken
    bool complete = true;                            ///< false if a file could not be parsed at all
    std::string mesh_folder;                         ///< of the file that named the mesh
    std::vector<std::string> faults;
    std::size_t fault_count = 0;
};

void add_fault(Reading& reading, const std::string& origin, const std::string& message) {
    if (++reading.fault_count <= most_faults) reading.faults.push_back(origin + ": " + message);
}

std::string place(const std::string& name, toml::source_position at) {
    return fmt::format("{}:{}:{}", name, at.line, at.column);
}

std::string_view name_type(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::string:
            return "a text";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number with a fraction";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

std::string text_of(const toml::node& node) { return show_letters(node.value<std::string>().value_or("")); }

/// What the key takes, for "it must be …".
std::string_view name_type(const Slot& slot) {
    struct Namer {
        std::string_view operator()(const double*) const { return "a number"; }
        std::string_view operator()(const std::int64_t*) const { return "a whole number"; }
        std::string_view operator()(const std::string*) const { return "a text in quotes"; }
        std::string_view operator()(const std::vector<double>*) const { return "a list of numbers"; }
        std::string_view operator()(const ChoiceSlot&) const { return "a word in quotes"; }
    };
    return std::visit(Namer{}, slot);
}

// ---- one value into its slot: each returns what is wrong, or nothing ------------------------------------------------

using Trouble = std::optional<std::string>;

std::string say_wrong_type(const Key& key, const Slot& slot, const toml::node& node) {
    Case defaults;
    const std::string unit = key.unit.empty() || key.unit == "-" ? "" : fmt::format(", in {}", key.unit);
    return fmt::format("{} is {} (it must be {}{}). Write it like {} = {}?", key.name, name_type(node), name_type(slot),
                       unit, leaf_of(key.name), write_value(key.slot(defaults)));
}

Trouble store(const Key& key, double* member, const toml::node& node) {
    if (!node.is_number()) return say_wrong_type(key, member, node);
    const double value = node.value<double>().value_or(0.0);
    Trouble trouble = find_range_fault(key, value);
    if (!trouble) *member = value;
    return trouble;
}

Trouble store(const Key& key, std::int64_t* member, const toml::node& node) {
    if (!node.is_integer()) return say_wrong_type(key, member, node);
    const std::int64_t value = node.value<std::int64_t>().value_or(0);
    Trouble trouble = find_range_fault(key, static_cast<double>(value));
    if (!trouble) *member = value;
    return trouble;
}

/// On one line, so that it reads back as it was written.
bool is_one_line(std::string_view text) {
    return !find_bad_text(text) && text.find_first_of("\n\t") == std::string_view::npos;
}

Trouble store(const Key& key, std::string* member, const toml::node& node) {
    if (!node.is_string()) return say_wrong_type(key, member, node);
    const std::string value = text_of(node);
    Case defaults;
    const bool optional = std::get<std::string*>(key.slot(defaults))->empty();
    const std::size_t longest = optional ? longest_path : longest_text;
    if ((value.empty() && !optional) || value.size() > longest || !is_one_line(value)) {
        return fmt::format("{} = \"{}\" is no {} (it must be {} to {} bytes on one line). Choose another?", key.name,
                           printable(value), optional ? "text" : "name", optional ? 0 : 1, longest);
    }
    *member = value;
    return std::nullopt;
}

Trouble store(const Key& key, std::vector<double>* member, const toml::node& node) {
    const toml::array* list = node.as_array();
    if (list == nullptr) return say_wrong_type(key, member, node);
    if (list->empty() || list->size() > longest_list) {
        return fmt::format("{} has {} numbers (it must have 1 to {}). Correct the list?", key.name, list->size(),
                           longest_list);
    }
    std::vector<double> values(list->size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!(*list)[k].is_number()) return say_wrong_type(key, member, (*list)[k]);
        if (Trouble trouble = store(key, &values[k], (*list)[k])) return trouble;
    }
    *member = values;
    return std::nullopt;
}

Trouble store(const Key& key, const ChoiceSlot& choice, const toml::node& node) {
    if (!node.is_string()) return say_wrong_type(key, choice, node);
    const std::string value = text_of(node);
    const auto found = std::find(choice.words.begin(), choice.words.end(), value);
    if (found != choice.words.end()) {
        choice.set(choice.member, static_cast<int>(found - choice.words.begin()));
        return std::nullopt;
    }
    const std::string_view near = nearest_word(value, choice.words);
    return fmt::format("{} = \"{}\" is not known (it may be {}). {}?", key.name, printable(value), describe_range(key),
                       near.empty() ? std::string("Choose one of these") : fmt::format("Did you mean \"{}\"", near));
}

Trouble store(Reading& reading, const Key& key, const toml::node& node, const std::string& origin) {
    const Slot slot = key.slot(reading.value);
    Trouble trouble = std::visit([&key, &node](const auto& member) { return store(key, member, node); }, slot);
    if (trouble) {
        reading.faulty.insert(key.name);
    } else {
        reading.faulty.erase(key.name);
        reading.origin[key.name] = origin;
    }
    return trouble;
}

// ---- one file ------------------------------------------------------------------------------------------------------

/// A number, or a list of numbers, given in another unit, as it stands in the key's own; null for anything else.
std::unique_ptr<toml::node> to_own_unit(const toml::node& node, int power) {
    const auto shift = [power](const toml::node& n) { return shift_point(n.value<double>().value_or(0.0), power); };
    if (node.is_number()) return std::make_unique<toml::value<double>>(shift(node));
    const toml::array* list = node.as_array();
    if (list == nullptr || !std::ranges::all_of(*list, [](const toml::node& n) { return n.is_number(); }))
        return nullptr;
    auto shifted = std::make_unique<toml::array>();
    for (const toml::node& n : *list) shifted->push_back(shift(n));
    return shifted;
}

Trouble store_variant(Reading& reading, const UnitVariant& variant, const toml::node& node, const std::string& origin) {
    const Key& key = *find_key(variant.key);
    const auto shifted = to_own_unit(node, variant.power);
    return store(reading, key, shifted ? *shifted : node, origin);
}

/// Where the mesh's path starts from, and that an earlier layer's checksum does not stand for a new file.
void note_mesh(Reading& reading, const Key& key, const toml::table* table, const std::string& folder) {
    if (key.name != mesh_file_key) return;
    reading.mesh_folder = folder;
    if (table == nullptr || !table->contains("mesh_checksum")) reading.value.wheel.mesh_checksum.clear();
}

/// Stores every value of `table`, whose keys begin with `prefix`.
void store_table(Reading& reading, const toml::table& table, const std::string& prefix, const std::string& name,
                 std::vector<Fault>& faults) {
    std::map<std::string, std::string> in_units;  ///< key → how it stands there in other units than its own
    for (const auto& [toml_key, node] : table) {
        const std::string path = prefix + show_letters(toml_key.str());
        const toml::source_position key_at = toml_key.source().begin;
        const bool quoted_dot = toml_key.str().find('.') != std::string_view::npos;
        const toml::source_position at = node.source().begin;
        if (path == base_key) continue;
        if (quoted_dot) {
            faults.push_back(
                {key_at, fmt::format("unknown key \"{}\" (a dot in quotes does not reach into a table). Leave the "
                                     "quotes out?",
                                     printable(path))});
        } else if (const Key* key = find_key(path)) {
            if (const Trouble trouble = store(reading, *key, node, place(name, at))) faults.push_back({at, *trouble});
            note_mesh(reading, *key, &table, std::filesystem::path(name).parent_path().string());
        } else if (const auto variant = find_unit_variant(path)) {
            const auto [other, first] = in_units.try_emplace(variant->key, path);
            if (const bool own = table.contains(leaf_of(variant->key)); own || !first) {
                faults.push_back({key_at, fmt::format("given twice ({} and {}). Remove one?", path,
                                                      own ? variant->key : other->second)});
            } else if (const Trouble trouble = store_variant(reading, *variant, node, place(name, at))) {
                faults.push_back({at, *trouble});
            }
        } else if (!is_table(path)) {
            const std::string_view kind = node.is_table() ? "table" : "key";
            const std::string advice = faults.size() < most_faults ? advise_key(path) : "";
            faults.push_back({key_at, fmt::format("unknown {} {}{}", kind, printable(path), advice)});
        } else if (node.is_table()) {
            store_table(reading, *node.as_table(), path + ".", name, faults);
        } else {
            faults.push_back(
                {key_at, fmt::format("{0} is {1} (it must be a table of keys). Write [{0}] with its keys below?", path,
                                     name_type(node))});
        }
    }
}

/// The text as TOML; a text that is none is reported and gives nothing.
std::optional<toml::table> parse(Reading& reading, const std::string& text, const std::string& name) {
    reading.complete = false;
    if (const auto bad = find_bad_text(text)) {
        add_fault(reading, fmt::format("{}:{}:{}", name, bad->line, bad->column), bad->message);
        return std::nullopt;
    }
    // Not toml++'s own skipping of the mark: hide_letters() would move it out of its sight.
    const std::string_view body = std::string_view(text).substr(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
    try {
        toml::table table = toml::parse(hide_letters(body), name);
        reading.complete = true;
        return table;
    } catch (const toml::parse_error& error) {
        const std::string what = show_letters(error.description());
        const bool twice = what.find("redefine") != std::string::npos;
        add_fault(reading, place(name, error.source().begin),
                  twice ? fmt::format("given twice ({}). Remove one?", what)
                        : fmt::format("not TOML ({}). Correct it?", what));
    } catch (const std::exception& error) {
        add_fault(reading, name + ":1:1", fmt::format("not TOML (the reader gave up: {}). Correct it?", error.what()));
    }
    return std::nullopt;
}

std::filesystem::path identify(const std::string& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
    return error ? std::filesystem::path(path) : whole;
}

void read_layer(Reading& reading, const std::string& text, const std::string& name,
                std::vector<std::filesystem::path>& chain);

/// Reads the case that `node` of the file `name` names as its base.
void read_base(Reading& reading, const toml::node& node, const std::string& name,
               std::vector<std::filesystem::path>& chain) {
    const std::string origin = place(name, node.source().begin);
    const std::string base = text_of(node);
    if (!node.is_string() || base.empty() || base.find('\0') != std::string::npos) {
        reading.complete = false;
        return add_fault(reading, origin,
                         "base is no path (it must be a text in quotes). Write it like base = \"other.toml\"?");
    }
    const std::string path = (std::filesystem::path(name).parent_path() / base).string();
    if (std::find(chain.begin(), chain.end(), identify(path)) != chain.end()) {
        reading.complete = false;
        return add_fault(
            reading, origin,
            fmt::format("base = \"{}\" leads back to itself (each case of the circle has another as its base). "
                        "Remove one base?",
                        printable(base)));
    }
    std::string text;
    try {
        text = read_text_file(path);
    } catch (const Error& error) {
        reading.complete = false;
        return add_fault(reading, origin, fmt::format("base = \"{}\": {}", printable(base), error.what()));
    }
    read_layer(reading, text, path, chain);
}

/// Reads a file's base, then its own values over it.
void read_layer(Reading& reading, const std::string& text, const std::string& name,
                std::vector<std::filesystem::path>& chain) {
    const auto table = parse(reading, text, name);
    if (!table) return;
    chain.push_back(identify(name));
    if (table->empty())
        add_fault(reading, name + ":1:1", "the case is empty (not even a name). Write what differs from the defaults?");
    if (const toml::node* base = table->get(base_key)) read_base(reading, *base, name, chain);
    std::vector<Fault> faults;
    store_table(reading, *table, "", name, faults);
    std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) { return a.at < b.at; });
    for (const Fault& fault : faults) add_fault(reading, place(name, fault.at), fault.message);
}

// ---- --set ---------------------------------------------------------------------------------------------------------

bool takes_words(const Key& key) {
    Case c;
    const Slot slot = key.slot(c);
    return std::holds_alternative<std::string*>(slot) || std::holds_alternative<ChoiceSlot>(slot);
}

bool is_bare_word(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
}

void apply_override(Reading& reading, const Override& setting) {
    const std::string origin = fmt::format("--set {}={}", printable(setting.key), printable(setting.value));
    const auto variant = find_unit_variant(setting.key);
    const Key* key = find_key(variant ? variant->key : setting.key);
    if (key == nullptr) {
        const std::string message =
            setting.key == base_key ? "base belongs into the file (it is where the file starts from). Write it there?"
            : is_table(setting.key) ? fmt::format("{} is a table. Set one of its keys?", setting.key)
                                    : fmt::format("unknown key {}{}", printable(setting.key), advise_key(setting.key));
        return add_fault(reading, origin, message);
    }
    Trouble trouble;
    if (find_bad_text(setting.value) || setting.value.find('\n') != std::string::npos) {
        trouble = "the value is not one line of text. Correct it?";
    } else if (takes_words(*key) && !setting.value.starts_with('"') && !setting.value.starts_with('\'')) {
        trouble = store(reading, *key, toml::value<std::string>(setting.value), origin);
    } else {
        Reading scratch;
        const auto table = parse(scratch, "value = " + setting.value, "");
        if (table) {
            const toml::node& value = *table->get("value");
            trouble = variant ? store_variant(reading, *variant, value, origin) : store(reading, *key, value, origin);
        } else if (is_bare_word(setting.value)) {
            trouble = store(reading, *key, toml::value<std::string>(setting.value), origin);
        } else {
            trouble = fmt::format("the value is not TOML. Write a value of {} like that of a file?", key->name);
        }
    }
    note_mesh(reading, *key, nullptr, "");
    if (trouble) {
        reading.faulty.insert(key->name);
        add_fault(reading, origin, *trouble);
    }
}

// ---- the whole -----------------------------------------------------------------------------------------------------

/// Rules between keys, except those of which a key is in doubt; each stands where the first key given stands.
void check_rules(Reading& reading, const std::string& name) {
    if (!reading.complete) return;
    for (const RuleFault& fault : find_rule_faults(reading.value)) {
        std::string origin;
        bool doubtful = false;
        for (const std::string_view key : fault.keys) {
            doubtful = doubtful || reading.faulty.contains(key);
            const auto given = reading.origin.find(key);
            if (origin.empty() && given != reading.origin.end()) origin = given->second;
        }
        if (!doubtful) add_fault(reading, origin.empty() ? name + ":1:1" : origin, fault.message);
    }
}

/// A mesh that is named for the first time gets its whole path and its checksum. In a case that was resolved before it
/// has them, and is not looked for: reports are made where there is no mesh.
void resolve_mesh(Reading& reading) {
    WheelCase& wheel = reading.value.wheel;
    if (wheel.mesh_file.empty() || !wheel.mesh_checksum.empty() || reading.fault_count > 0) return;
    const std::string path = identify((std::filesystem::path(reading.mesh_folder) / wheel.mesh_file).string()).string();
    try {
        const std::string text = read_text_file(path, largest_mesh);
        if (path.size() > longest_path || !is_one_line(path)) fail_input("its path is no text. Move it elsewhere?");
        wheel.mesh_file = path;
        wheel.mesh_checksum = to_hex(checksum(std::as_bytes(std::span(text))));
    } catch (const Error& error) {
        add_fault(reading, reading.origin[mesh_file_key],
                  fmt::format("{} = \"{}\": {}", mesh_file_key, printable(wheel.mesh_file), error.what()));
    }
}

}  // namespace

Case parse_case(const std::string& text, const std::string& name, const std::vector<Override>& overrides) {
    Reading reading;
    std::vector<std::filesystem::path> chain;
    read_layer(reading, text, name, chain);
    for (const Override& setting : overrides) apply_override(reading, setting);
    check_rules(reading, name);
    resolve_mesh(reading);
    if (reading.fault_count > reading.faults.size()) {
        reading.faults.push_back(fmt::format("{}: and {} more faults. Is this the right file?", name,
                                             reading.fault_count - reading.faults.size()));
    }
    std::string message;
    for (const std::string& fault : reading.faults) message += (message.empty() ? "" : "\n") + fault;
    if (!message.empty()) fail_input(message);
    return reading.value;
}

Case read_case(const std::string& path, const std::vector<Override>& overrides) {
    std::string text;
    try {
        text = read_text_file(path);
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("{}: {}", path, error.what()));
    }
    return parse_case(text, path, overrides);
}

}  // namespace ifedem

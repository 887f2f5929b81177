#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "model/case_keys.hpp"

namespace ifedem {
namespace {

/// Columns a reader sees: bytes that do not continue a UTF-8 character.
std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::string pad(std::string_view text, std::size_t width) {
    const std::size_t now = width_of(text);
    return std::string(text) + std::string(now < width ? width - now : 0, ' ');
}

std::string comment_of(const Key& key) {
    return key.unit.empty() ? fmt::format("# {}: {}", describe_range(key), key.meaning)
                            : fmt::format("# {}, {}: {}", key.unit, describe_range(key), key.meaning);
}

bool belongs_to(const Key& key, std::string_view key_or_table) {
    if (key_or_table.empty()) return table_of(key.name).empty();
    return key.name == key_or_table || (key.name.starts_with(key_or_table) && key.name[key_or_table.size()] == '.');
}

bool is_empty_text(const Slot& slot) {
    const auto* text = std::get_if<std::string*>(&slot);
    return text != nullptr && (*text)->empty();
}

}  // namespace

std::string to_toml(const Case& c) {
    Case values = c;  // slots point to what may be changed; a copy keeps `c` const
    std::string text;
    std::string_view table;
    for (const Key& key : case_keys()) {
        if (table_of(key.name) != table) {
            table = table_of(key.name);
            text += fmt::format("\n[{}]\n", table);
        }
        const std::string assignment = fmt::format("{} = {}", leaf_of(key.name), write_value(key.slot(values)));
        text += pad(assignment, 44) + ' ' + comment_of(key) + '\n';
    }
    return text;
}

std::vector<Override> list_changes(const Case& from, const Case& to) {
    Case before = from, after = to;
    std::vector<Override> changes;
    for (const Key& key : case_keys()) {
        const std::string value = write_value(key.slot(after));
        if (value != write_value(key.slot(before))) changes.push_back({std::string(key.name), value});
    }
    return changes;
}

std::string to_toml_subset(const Case& c, const std::vector<std::string>& keys_or_tables) {
    Case values = c;
    for (const std::string& wanted : keys_or_tables) {
        if (!wanted.empty() && find_key(wanted) == nullptr && !is_table(wanted)) {
            fail_input(fmt::format("there is no key or table \"{}\". Correct the list of inputs?", wanted));
        }
    }
    std::string text;
    for (const Key& key : case_keys()) {
        const bool wanted = std::any_of(keys_or_tables.begin(), keys_or_tables.end(),
                                        [&key](const std::string& name) { return belongs_to(key, name); });
        // An empty text is a thing left out: cases from before there was such a key keep their names.
        if (wanted && !is_empty_text(key.slot(values)))
            text += fmt::format("{} = {}\n", key.name, write_value(key.slot(values)));
    }
    return text;
}

std::string describe_keys() {
    Case defaults;
    std::string text =
        "A case is a TOML file that states what differs from the defaults below, or from another case named by\n"
        "  base = \"other.toml\"    (a path relative to the file that names it)\n"
        "Values are in the unit that ends the key. Where that is m, N, Pa, s or kg/m³, another ending will do:\n"
        "  _mm, _cm, _kN, _kPa, _MPa, _GPa, _ms, _us, _g_cm3, _N_mm, _kN_m, _mm_s, _cm_s; lug_height_mm = 8 is\n"
        "  lug_height_m = 0.008 to the last bit.\n"
        "Each line: key, unit, default, what it may be; then what it means.\n";
    std::string_view table = "-";
    for (const Key& key : case_keys()) {
        if (table_of(key.name) != table) {
            table = table_of(key.name);
            text += table.empty() ? "\n" : fmt::format("\n[{}]\n", table);
        }
        text += fmt::format("  {} {} {} {}\n      {}\n", pad(leaf_of(key.name), 28), pad(key.unit, 12),
                            pad(write_value(key.slot(defaults)), 24), describe_range(key), key.meaning);
    }
    return text;
}

}  // namespace ifedem

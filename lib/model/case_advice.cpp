#include "model/case_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "model/case_keys.hpp"

namespace ifedem {
namespace {

/// Units that end our keys, and those that people write instead; longer ones before those they end with.
constexpr std::array<std::string_view, 51> units{
    "_N_m_s",  "_N_s_m",  "_Nm_rad_s", "_Nm_s_rad", "_Nm_rad",   "_kN_m", "_N_mm",   "_MN_m", "_N_m",
    "_kg_m3",  "_g_cm3",  "_kg_m_3",   "_cm_s2",    "_mm_s2",    "_m_s2", "_km_h",   "_cm_s", "_mm_s",
    "_m_s",    "_rad_s",  "_1_s",      "_percent",  "_per_cent", "_pct",  "_degree", "_deg",  "_rad",
    "_meters", "_metres", "_seconds",  "_newton",   "_GPa",      "_MPa",  "_kPa",    "_Pa",   "_kN",
    "_min",    "_kgf",    "_kg",       "_mm",       "_cm",       "_um",   "_km",     "_ms",   "_us",
    "_N",      "_m",      "_s",        "_g",        "_h",        "_Nm"};

std::string_view without_unit(std::string_view leaf) {
    for (const std::string_view unit : units) {
        if (leaf.size() > unit.size() && leaf.ends_with(unit)) return leaf.substr(0, leaf.size() - unit.size());
    }
    return leaf;
}

constexpr std::size_t longest_word = 80;  // nothing that long is near a key; the distance costs its square

/// Levenshtein's distance of `b`, no longer than longest_word, or `enough` where it is at least that: most words are
/// given up after their length or a few letters, and a file of nothing but unknown keys asks for all words again and
/// again.
std::size_t count_edits(std::string_view a, std::string_view b, std::size_t enough) {
    if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) >= enough) return enough;
    std::array<std::size_t, longest_word + 1> row{};
    std::iota(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(b.size()) + 1, std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0], least = i + 1;
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0U : 1U)});
            diagonal = above;
            least = std::min(least, row[j + 1]);
        }
        if (least >= enough) return enough;  // no later row has a lesser least
    }
    return std::min(row[b.size()], enough);
}

/// Keys, and the tables that they stand in.
std::vector<std::string_view> list_names() {
    std::vector<std::string_view> names;
    for (const Key& key : case_keys()) names.push_back(key.name);
    for (const Key& key : case_keys()) {
        for (std::string_view table = table_of(key.name); !table.empty(); table = table_of(table)) {
            if (std::find(names.begin(), names.end(), table) == names.end()) names.push_back(table);
        }
    }
    return names;
}

}  // namespace

std::string_view nearest_word(std::string_view unknown, std::span<const std::string_view> words) {
    if (unknown.size() > longest_word) return {};
    std::string_view best;
    std::size_t fewest = 2 + unknown.size() / 4;
    for (const std::string_view word : words) {
        const std::size_t edits = count_edits(word, unknown, fewest);
        if (edits < fewest) {
            fewest = edits;
            best = word;
        }
    }
    return best;
}

std::string advise_key(std::string_view unknown) {
    // The same word with another unit or none, in the same table or, failing that, in any.
    const std::string_view table = table_of(unknown), leaf = leaf_of(unknown), stem = without_unit(leaf);
    for (const bool same_table : {true, false}) {
        for (const Key& key : case_keys()) {
            const std::string_view name = key.name;
            if (same_table && table_of(name) != table) continue;
            if (leaf_of(name) == leaf) return fmt::format(" (it stands elsewhere). Did you mean {}?", name);
            // Only a leaf that begins with the stem has the same: most are told apart without their units.
            if (leaf_of(name).starts_with(stem) && without_unit(leaf_of(name)) == stem) {
                return fmt::format(" (a key ends in its unit, and values are in SI units). Did you mean {}?", name);
            }
        }
    }
    static const std::vector<std::string_view> names = list_names();
    const std::string_view near = nearest_word(unknown, names);
    if (!near.empty()) return fmt::format(". Did you mean {}?", near);
    return ". Look it up with \"ifedem describe\"?";
}

}  // namespace ifedem

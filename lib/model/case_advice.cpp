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

/// Levenshtein's distance.
std::size_t count_edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0U : 1U)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

constexpr std::size_t longest_word = 80;  // nothing that long is near a key; the distance costs its square

}  // namespace

std::string_view nearest_word(std::string_view unknown, std::span<const std::string_view> words) {
    if (unknown.size() > longest_word) return {};
    std::string_view best;
    std::size_t fewest = 2 + unknown.size() / 4;
    for (const std::string_view word : words) {
        const std::size_t edits = count_edits(unknown, word);
        if (edits < fewest) {
            fewest = edits;
            best = word;
        }
    }
    return best;
}

std::string advise_key(std::string_view unknown) {
    std::vector<std::string_view> names;
    for (const Key& key : case_keys()) names.push_back(key.name);
    // The same word with another unit or none, in the same table or, failing that, in any.
    for (const bool same_table : {true, false}) {
        for (const std::string_view name : names) {
            if (same_table && table_of(name) != table_of(unknown)) continue;
            if (leaf_of(name) == leaf_of(unknown)) return fmt::format(" (it stands elsewhere). Did you mean {}?", name);
            if (without_unit(leaf_of(name)) == without_unit(leaf_of(unknown))) {
                return fmt::format(" (a key ends in its unit, and values are in SI units). Did you mean {}?", name);
            }
        }
    }
    for (const Key& key : case_keys()) {
        for (std::string_view table = table_of(key.name); !table.empty(); table = table_of(table)) {
            if (std::find(names.begin(), names.end(), table) == names.end()) names.push_back(table);
        }
    }
    const std::string_view near = nearest_word(unknown, names);
    if (!near.empty()) return fmt::format(". Did you mean {}?", near);
    return ". Look it up with \"ifedem describe\"?";
}

}  // namespace ifedem

#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/case.hpp"

namespace ifedem {

// Internal to lib/model: the table that joins key, member, unit, range and sentence.

/// A member that takes one of a few words. `get` and `set` see the enumerator as its index into `words`.
struct ChoiceSlot {
    void* member = nullptr;
    int (*get)(const void* member) = nullptr;
    void (*set)(void* member, int index) = nullptr;
    std::span<const std::string_view> words;
};

/// Where a key's value lives in a case.
using Slot = std::variant<double*, std::int64_t*, std::string*, std::vector<double>*, ChoiceSlot>;

/// What a number may be. Ends are wide: they catch a wrong unit or a slip of the keyboard, not a bold idea.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;
};

struct Key {
    std::string_view name;  ///< dotted, "wheel.rim.young_Pa"
    std::string_view unit;  ///< for people; "-" for a pure number, "" for words
    Range range;            ///< of the number, or of each number of a list
    std::string_view meaning;
    Slot (*slot)(Case&) = nullptr;
};

/// All keys: the top level first, then table by table, in the order in which a case is written.
[[nodiscard]] std::span<const Key> case_keys();

/// The key of that name, or null.
[[nodiscard]] const Key* find_key(std::string_view name);

/// True for "soil", "wheel.rim", …: a name that has keys below it.
[[nodiscard]] bool is_table(std::string_view name);

/// "wheel.rim" of "wheel.rim.young_Pa"; "" at the top level.
[[nodiscard]] std::string_view table_of(std::string_view key);
/// "young_Pa" of "wheel.rim.young_Pa".
[[nodiscard]] std::string_view leaf_of(std::string_view key);

/// What may stand to the right of a key: "in (-1, 0.5)", "whole in [1, 1000]", "flat | discs".
[[nodiscard]] std::string describe_range(const Key& key);

/// The value as TOML; a number in the shortest form that reads back to the same bits.
[[nodiscard]] std::string write_value(const Slot& slot);

}  // namespace ifedem

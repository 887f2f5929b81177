#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/case_keys.hpp"

namespace ifedem {

// What the values of a case must satisfy.

/// Why this number may not be the key's, or nothing if it may.
[[nodiscard]] std::optional<std::string> find_range_fault(const Key& key, double value);

/// A rule that joins several keys and is broken.
struct RuleFault {
    std::vector<std::string_view> keys;
    std::string message;
};

/// The first range or rule that a wheel breaks which was not read from a file, or nothing.
[[nodiscard]] std::optional<std::string> find_wheel_fault(const WheelCase& wheel);

/// Rules between keys: lengths that must fit into each other, lists of one length, intervals not below the step.
[[nodiscard]] std::vector<RuleFault> find_rule_faults(const Case& c);

}  // namespace ifedem

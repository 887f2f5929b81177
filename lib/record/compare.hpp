#pragma once
#include <optional>
#include <string>

#include "model/state.hpp"

namespace ifedem {

/// The first place, in the order of for_each_member(), where two states differ in a bit: member, element (with the
/// disc's id where there is one), component and both values. Nothing if they are equal.
[[nodiscard]] std::optional<std::string> find_difference(const State& a, const State& b);

}  // namespace ifedem

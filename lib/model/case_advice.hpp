#pragma once
#include <span>
#include <string>
#include <string_view>

namespace ifedem {

// Internal to lib/model: what to say to somebody who mistyped.

/// "Did you mean …?" for a key or table that does not exist, with the reason if it is its unit.
[[nodiscard]] std::string advise_key(std::string_view unknown);

/// The word nearest to `unknown`, or "" if none is near.
[[nodiscard]] std::string_view nearest_word(std::string_view unknown, std::span<const std::string_view> words);

}  // namespace ifedem

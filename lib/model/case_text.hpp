#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ifedem {

// Internal to lib/model: what must hold before bytes may be read as TOML.

/// Where the first unreadable byte is, counted from 1 (columns in characters), and what is wrong with it.
struct TextFault {
    std::uint64_t line = 1;
    std::uint64_t column = 1;
    std::string message;
};

/// A case is UTF-8 text without control characters, in lines of at most 2000 bytes. The TOML library asserts on some
/// control characters, and a line of endless dotted keys would nest tables until the stack is full. Nor may it hold
/// private characters from U+100000, which hide_letters() needs.
[[nodiscard]] std::optional<TextFault> find_bad_text(std::string_view text);

/// Moves every letter beyond ASCII up by U+100000, and back. toml++ 3.3.0 looks such letters up in a table of spaces
/// with undefined behaviour for most of those up to U+FEFF ("é" after a key is enough), and with none beyond.
[[nodiscard]] std::string hide_letters(std::string_view text);
[[nodiscard]] std::string show_letters(std::string_view hidden);

inline constexpr std::size_t largest_case = std::size_t{1} << 20;

/// The bytes of a regular file of at most `largest` bytes. Throws Error(bad_input) for anything else and for an absent
/// file, Error(io) for one that cannot be read; the message does not name the file.
[[nodiscard]] std::string read_text_file(const std::string& path, std::size_t largest = largest_case);

/// The text for a message: on one line and not endless.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace ifedem

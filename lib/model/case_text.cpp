#include "model/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr std::size_t longest_line = 2000;

/// Bytes of the UTF-8 character at the front of `text`; 0 if there is none (Unicode 15, table 3-7).
std::size_t measure_character(std::string_view text) {
    const auto byte = [text](std::size_t k) { return static_cast<unsigned char>(k < text.size() ? text[k] : 0); };
    const auto continues = [&byte](std::size_t k) { return (byte(k) & 0xc0U) == 0x80U; };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead <= 0xdf) return continues(1) ? 2 : 0;
    if (lead >= 0xe0 && lead <= 0xef) {
        const bool overlong = lead == 0xe0 && byte(1) < 0xa0;
        const bool surrogate = lead == 0xed && byte(1) > 0x9f;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (lead >= 0xf0 && lead <= 0xf4) {
        const bool overlong = lead == 0xf0 && byte(1) < 0x90;
        const bool beyond = lead == 0xf4 && byte(1) > 0x8f;
        return continues(1) && continues(2) && continues(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

bool is_control(std::string_view text, std::size_t at) {
    const auto c = static_cast<unsigned char>(text[at]);
    if (c == '\r') return at + 1 >= text.size() || text[at + 1] != '\n';
    return (c < 0x20 && c != '\t' && c != '\n') || c == 0x7f;
}

/// UTF-8 begins U+100000 … U+10FFFF with this byte and no other character; the three bytes after it hold 16 bits.
constexpr unsigned private_lead = 0xf4;

/// Six bits to carry on a UTF-8 character.
char continuation(unsigned code, unsigned shift) { return static_cast<char>(0x80U | ((code >> shift) & 0x3fU)); }

/// The number of a valid character, less the top bits of a four-byte one.
unsigned decode(std::string_view character) {
    const unsigned lead = static_cast<unsigned char>(character[0]);
    unsigned code = character.size() == 2 ? lead & 0x1fU : character.size() == 3 ? lead & 0x0fU : 0U;
    for (const char c : character.substr(1)) code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3fU);
    return code;
}

}  // namespace

std::string hide_letters(std::string_view text) {
    std::string hidden;
    hidden.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = std::max<std::size_t>(measure_character(text.substr(at)), 1);
        const std::string_view character = text.substr(at, size);
        at += size;
        if (size != 2 && size != 3) {
            hidden += character;
            continue;
        }
        const unsigned code = decode(character);
        hidden += static_cast<char>(private_lead);
        for (const unsigned shift : {12U, 6U, 0U}) hidden += continuation(code, shift);
    }
    return hidden;
}

std::string show_letters(std::string_view hidden) {
    std::string text;
    for (std::size_t at = 0; at < hidden.size();) {
        const std::size_t size = std::max<std::size_t>(measure_character(hidden.substr(at)), 1);
        const std::string_view character = hidden.substr(at, size);
        at += size;
        if (static_cast<unsigned char>(character[0]) != private_lead || size != 4) {
            text += character;
            continue;
        }
        const unsigned code = decode(character);
        if (code < 0x800) {
            text += static_cast<char>(0xc0U | (code >> 6U));
        } else {
            text += static_cast<char>(0xe0U | (code >> 12U));
            text += continuation(code, 6U);
        }
        text += continuation(code, 0U);
    }
    return text;
}

std::optional<TextFault> find_bad_text(std::string_view text) {
    constexpr auto advice = "a case is UTF-8 text without control characters). Is this the right file?";
    std::uint64_t line = 1;
    std::uint64_t column = 1;
    std::size_t line_start = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = measure_character(text.substr(at));
        const unsigned byte = static_cast<unsigned char>(text[at]);
        if (size == 0) return TextFault{line, column, fmt::format("byte 0x{:02x} is not UTF-8 ({}", byte, advice)};
        if (byte == private_lead)
            return TextFault{line, column, "private character (nobody else knows it). Leave it out?"};
        if (is_control(text, at))
            return TextFault{line, column, fmt::format("control character 0x{:02x} ({}", byte, advice)};
        if (at - line_start >= longest_line) {
            return TextFault{line, column, fmt::format("the line is longer than {} bytes. Break it?", longest_line)};
        }
        ++column;
        at += size;
        if (byte == '\n') {
            ++line;
            column = 1;
            line_start = at;
        }
    }
    return std::nullopt;
}

std::string read_text_file(const std::string& path, std::size_t largest) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) fail_input("there is no such file. Check the path?");
    if (status.type() == fs::file_type::none)
        fail_io(fmt::format("the file cannot be read ({}). Check it?", error.message()));
    if (status.type() == fs::file_type::directory)
        fail_input("this is a directory (a case is a file). Name a file in it?");
    // A pipe could keep us waiting for ever and a device feed us for ever.
    if (status.type() != fs::file_type::regular) fail_input("this is not a regular file. Copy the case to a file?");
    std::ifstream file(path, std::ios::binary);
    if (!file) fail_io(fmt::format("the file cannot be opened ({}). Check its permissions?", std::strerror(errno)));
    const auto size = static_cast<std::size_t>(fs::file_size(path, error));  // one that grows meanwhile is cut off
    if (error) fail_io(fmt::format("the size of the file cannot be read ({}). Check it?", error.message()));
    if (size > largest) {
        fail_input(fmt::format("the file is larger than {} MiB{}. Is this the right file?", largest >> 20U,
                               largest == largest_case ? " (a case is a page)" : ""));
    }
    std::string text(size, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) fail_io("the file cannot be read to its end. Check the disk?");
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = measure_character(text.substr(at));
        if (out.size() + size > longest) return out + "...";
        const auto byte = static_cast<unsigned char>(text[at]);
        const bool plain = size > 1 || (size == 1 && byte >= 0x20 && byte != 0x7f);
        out += plain ? std::string(text.substr(at, size)) : "?";
        at += size == 0 ? 1 : size;
    }
    return out;
}

}  // namespace ifedem

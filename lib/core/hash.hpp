#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace ifedem {

/// A 64-bit FNV-1a hash taken eight bytes at a time with a final avalanche. It names states and stages;
/// it is no defence against an adversary. The value depends on bytes only, never on addresses or padding.
class Hasher {
public:
    void add(std::uint64_t word) noexcept {
        state_ = (state_ ^ word) * 0x100000001b3ULL;
        state_ ^= state_ >> 29;
    }
    void add(double value) noexcept {
        std::uint64_t word = 0;
        std::memcpy(&word, &value, sizeof word);
        add(word);
    }
    void add(std::string_view text) noexcept {
        add(static_cast<std::uint64_t>(text.size()));
        for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    }
    [[nodiscard]] std::uint64_t value() const noexcept {
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }

private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

/// A checksum of bytes and their number. Each word is mixed in by a step that loses nothing, so no change within a
/// single aligned word goes unnoticed; other damage passes with a chance of 2⁻⁶⁴.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

/// Sixteen lower-case hexadecimal digits.
[[nodiscard]] std::string to_hex(std::uint64_t value);

}  // namespace ifedem

#include "core/hash.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ifedem {

std::uint64_t checksum(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add(static_cast<std::uint64_t>(bytes.size()));
    while (!bytes.empty()) {
        const std::size_t size = std::min<std::size_t>(bytes.size(), sizeof(std::uint64_t));
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), size);
        hasher.add(word);
        bytes = bytes.subspan(size);
    }
    return hasher.value();
}

std::string to_hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace ifedem

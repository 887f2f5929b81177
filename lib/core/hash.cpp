#include "core/hash.hpp"

#include <fmt/format.h>

namespace ifedem {

std::string to_hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace ifedem

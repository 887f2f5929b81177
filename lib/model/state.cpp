#include "model/state.hpp"

#include <cstring>
#include <type_traits>

#include "core/hash.hpp"

namespace ifedem {
namespace {

/// Padding would put stray bytes into the hash, and nothing in C++ tells whether an aggregate of doubles has any: each
/// is listed here with the size of its members. A new type in the state must join the list.
template <class T>
constexpr std::size_t size_of_members = std::is_arithmetic_v<T> || std::is_enum_v<T> ? sizeof(T) : 0;
template <>
constexpr std::size_t size_of_members<Vec2> = 2 * sizeof(double);
template <>
constexpr std::size_t size_of_members<Disc> = 8 * sizeof(double);
template <>
constexpr std::size_t size_of_members<Reference> = 3 * sizeof(double);
template <>
constexpr std::size_t size_of_members<DiscAcceleration> = 4 * sizeof(double);
template <>
constexpr std::size_t size_of_members<BoundaryContact> = 2 * sizeof(std::uint32_t) + sizeof(double);
template <>
constexpr std::size_t size_of_members<RigidBody> = 6 * sizeof(double);
template <>
constexpr std::size_t size_of_members<PidState> = 4 * sizeof(double);
template <>
constexpr std::size_t size_of_members<EnergyLedger> = 6 * sizeof(double);
template <>
constexpr std::size_t size_of_members<SeriesSums> = 9 * sizeof(double);
template <>
constexpr std::size_t size_of_members<ElementShape> = 8 * sizeof(double);
template <>
constexpr std::size_t size_of_members<SegmentSum> = 8 * sizeof(double);
template <>
constexpr std::size_t size_of_members<StressBlock> = 7 * sizeof(double);
template <>
constexpr std::size_t size_of_members<AttachedDisc> = 4 * sizeof(double);
template <>
constexpr std::size_t size_of_members<ConversionRecord> = (6 + 2 * 9) * sizeof(double);

void add_bytes(Hasher& hasher, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    std::size_t at = 0;
    for (; at + sizeof(std::uint64_t) <= size; at += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + at, sizeof word);
        hasher.add(word);
    }
    if (at < size) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + at, size - at);
        hasher.add(word);
    }
}

template <class T>
void add_member(Hasher& hasher, const T& value) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) == size_of_members<T>);
    add_bytes(hasher, &value, sizeof value);
}

/// The count goes in first, so that an element cannot move from the end of one vector to the start of the next unseen.
template <class T>
void add_member(Hasher& hasher, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) == size_of_members<T>);
    hasher.add(static_cast<std::uint64_t>(values.size()));
    if (!values.empty()) add_bytes(hasher, values.data(), values.size() * sizeof(T));
}

}  // namespace

std::uint64_t hash_state(const State& state) {
    Hasher hasher;
    const auto add = [&hasher](const char*, const auto& member) { add_member(hasher, member); };
    for_each_present_member(state, add);
    return hasher.value();
}

}  // namespace ifedem

#include "core/hash.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <set>
#include <vector>

#include "core/random.hpp"
#include "model/state.hpp"

namespace ifedem {
namespace {

std::uint64_t hash_words(std::initializer_list<std::uint64_t> words) {
    Hasher hasher;
    for (const std::uint64_t word : words) hasher.add(word);
    return hasher.value();
}

TEST(Hash, HexHasSixteenLowerCaseDigits) {
    EXPECT_EQ(to_hex(0), "0000000000000000");
    EXPECT_EQ(to_hex(0xabcdef), "0000000000abcdef");
    EXPECT_EQ(to_hex(~0ULL), "ffffffffffffffff");
    EXPECT_EQ(to_hex(0x0123456789abcdefULL), "0123456789abcdef");
}

TEST(Hash, DependsOnOrderAndCount) {
    EXPECT_NE(hash_words({1, 2}), hash_words({2, 1}));
    EXPECT_NE(hash_words({0}), hash_words({0, 0}));
    EXPECT_NE(hash_words({}), hash_words({0}));
    EXPECT_EQ(hash_words({1, 2, 3}), hash_words({1, 2, 3}));
}

TEST(Hash, TextsDoNotRunIntoEachOther) {
    Hasher a;
    a.add(std::string_view("ab"));
    a.add(std::string_view("c"));
    Hasher b;
    b.add(std::string_view("a"));
    b.add(std::string_view("bc"));
    EXPECT_NE(a.value(), b.value());
}

TEST(Hash, SeesEveryBitOfADouble) {
    Random random{1};
    for (int bit = 0; bit < 64; ++bit) {
        const std::uint64_t word = random.next();
        Hasher a;
        a.add(std::bit_cast<double>(word));
        Hasher b;
        b.add(std::bit_cast<double>(word ^ (1ULL << bit)));
        EXPECT_NE(a.value(), b.value()) << bit;
    }
}

TEST(Hash, AFlippedBitFlipsHalfOfTheHash) {
    Random random{2};
    int flipped = 0;
    constexpr int trials = 6400;
    for (int k = 0; k < trials; ++k) {
        const std::uint64_t word = random.next();
        flipped += std::popcount(hash_words({word, 5}) ^ hash_words({word ^ (1ULL << (k % 64)), 5}));
    }
    EXPECT_NEAR(static_cast<double>(flipped) / trials, 32.0, 0.25);  // five standard deviations of the mean
}

TEST(Hash, NearbyInputsDoNotCollide) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < 300; ++i) {
        for (std::uint64_t j = 0; j < 300; ++j) seen.insert(hash_words({i, j}));
    }
    EXPECT_EQ(seen.size(), 90000U);
}

// ---- the state -----------------------------------------------------------------------------------------------------

template <class T>
void fill(T& value, Random& random) {
    std::array<unsigned char, sizeof(T)> bytes;
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random.next());
    std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof(T));
}

template <class T>
void fill(std::vector<T>& values, Random& random) {
    values.resize(3);
    for (T& value : values) fill(value, random);
}

State make_full_state() {
    State state;
    Random random{3};
    const auto fill_member = [&random](const char*, auto& member) { fill(member, random); };
    for_each_member(state, fill_member);
    for_each_soil_member(state, fill_member);
    for_each_stress_member(state, fill_member);
    for_each_mass_member(state, fill_member);
    return state;
}

template <class T>
void flip_bit(T& value, std::size_t byte, unsigned bit) {
    std::array<unsigned char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), static_cast<const void*>(&value), sizeof(T));
    bytes[byte] = static_cast<unsigned char>(bytes[byte] ^ (1U << bit));
    std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof(T));
}

/// Flips a bit in every byte of `value`, one at a time, and expects the hash of `state` to change and to come back.
template <class T>
void expect_hash_follows(const State& state, const char* name, T& value) {
    const std::uint64_t before = hash_state(state);
    for (std::size_t byte = 0; byte < sizeof(T); ++byte) {
        const auto bit = static_cast<unsigned>(byte % 8);
        flip_bit(value, byte, bit);
        EXPECT_NE(hash_state(state), before) << name << " byte " << byte;
        flip_bit(value, byte, bit);
    }
    EXPECT_EQ(hash_state(state), before) << name;
}

template <class T>
void expect_hash_follows(const State& state, const char* name, std::vector<T>& values) {
    for (T& value : values) expect_hash_follows(state, name, value);
    const std::uint64_t before = hash_state(state);
    const std::vector<T> kept = values;
    values.push_back(T{});
    EXPECT_NE(hash_state(state), before) << name << " one longer";
    values.resize(2);
    EXPECT_NE(hash_state(state), before) << name << " one shorter";
    values.clear();
    EXPECT_NE(hash_state(state), before) << name << " empty";
    values = kept;
    std::swap(values[0], values[1]);
    EXPECT_NE(hash_state(state), before) << name << " reordered";
    values = kept;
}

TEST(StateHash, ChangesWithEveryByteOfEveryMember) {
    State state = make_full_state();
    const auto expect = [&](const char* name, auto& member) { expect_hash_follows(state, name, member); };
    for_each_member(state, expect);
    for_each_soil_member(state, expect);
    for_each_stress_member(state, expect);
    for_each_mass_member(state, expect);
}

TEST(StateHash, TheListOfMembersIsWhole) {
    // Every member is a multiple of eight bytes, so that the state has no padding: a member left out of the list would
    // be missing from the sum.
    const State state;
    std::size_t listed = 0;
    std::size_t count = 0;
    std::set<std::string> names;
    const auto note = [&](const char* name, const auto& member) {
        listed += sizeof member;
        ++count;
        names.insert(name);
    };
    for_each_member(state, note);
    for_each_soil_member(state, note);
    for_each_stress_member(state, note);
    for_each_mass_member(state, note);
    EXPECT_EQ(listed, sizeof(State));
    EXPECT_EQ(names.size(), count) << "two members of one name";
}

TEST(StateHash, AnElementCannotMoveBetweenNeighbouringVectorsUnseen) {
    State left;
    left.pairs.i = {7, 7, 7};
    left.pairs.j = {7};
    State right;
    right.pairs.i = {7};
    right.pairs.j = {7, 7, 7};
    EXPECT_NE(hash_state(left), hash_state(right));
}

TEST(StateHash, DependsOnValuesAndNotOnAddresses) {
    const State state = make_full_state();
    State copy = state;
    copy.discs.disc.reserve(1000);
    EXPECT_EQ(hash_state(state), hash_state(copy));
    EXPECT_NE(hash_state(state), hash_state(State{}));
}

TEST(StateHash, TellsMinusZeroFromZero) {
    State state;
    const std::uint64_t before = hash_state(state);
    state.touch_position_m.x = -0.0;
    EXPECT_NE(hash_state(state), before);
}

}  // namespace
}  // namespace ifedem

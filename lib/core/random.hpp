#pragma once
#include <cstdint>
#include <utility>

namespace ifedem {

/// SplitMix64 (Steele, Lea & Flood 2014): one 64-bit word of state, the same numbers everywhere.
/// `std::mt19937` would do, but `std::*_distribution` differ between standard libraries.
struct Random {
    std::uint64_t state = 0;

    std::uint64_t next() noexcept {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// Uniform in [0, 1) with 53 bits.
    double uniform() noexcept { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    /// Uniform in [0, n) by rejection: exact, hence the same for every n on every machine.
    std::uint64_t below(std::uint64_t n) noexcept {
        const std::uint64_t limit = ~0ULL - (~0ULL % n + 1) % n;
        std::uint64_t draw = next();
        while (draw > limit) draw = next();
        return draw % n;
    }
};

/// Fisher–Yates; `std::shuffle` is not specified to give the same order in every library.
template <class Container>
void shuffle(Container& items, Random& random) {
    for (std::uint64_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[random.below(k)]);
}

}  // namespace ifedem

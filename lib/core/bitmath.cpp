#include "core/bitmath.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

// Every constant is a rounded rational or a piece of π, so that it can be checked by hand; hexadecimal because the
// decimal digits would hide how many trailing bits are zero, which is what makes the products below exact.

namespace ifedem {
namespace {

struct TwoPart {
    double high = 0.0;
    double low = 0.0;
};

/// a − b without loss: high + low (Knuth's two-sum).
TwoPart subtract_exactly(double a, double b) {
    const double difference = a - b;
    const double b_seen = a - difference;
    const double a_seen = difference + b_seen;
    return {difference, (a - a_seen) + (b_seen - b)};
}

struct Reduced {
    double high = 0.0;
    double low = 0.0;
    std::int64_t quadrant = 0;
};

/// angle − k·π/2 with k the nearest integer (Cody & Waite): π/2 in three pieces of 32 bits and a rest. k has at most 20
/// bits, so k·piece is exact; a double can come as near as 2⁻⁶⁰ to a multiple of π/2, which takes all four.
Reduced reduce(double angle_rad) {
    constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    constexpr double half_pi_1 = 0x1.921fb54400000p+0;
    constexpr double half_pi_2 = 0x1.0b4611a600000p-34;
    constexpr double half_pi_3 = 0x1.3198a2e000000p-69;
    constexpr double half_pi_4 = 0x1.b839a252049c1p-104;
    constexpr double round_to_integer = 0x1.8p52;  // adding it leaves no bits below one; odd, unlike floor(x + 1/2)
    const double k = (angle_rad * two_over_pi + round_to_integer) - round_to_integer;
    const double first = angle_rad - k * half_pi_1;
    const TwoPart second = subtract_exactly(first, k * half_pi_2);
    const TwoPart third = subtract_exactly(second.high, k * half_pi_3);
    const double rest = (second.low + third.low) - k * half_pi_4;
    const double high = third.high + rest;
    return {high, (third.high - high) + rest, static_cast<std::int64_t>(k)};
}

/// Taylor for |x| ≤ π/4; the first term left out is below 2⁻⁶³ of the value.
double sin_near_zero(double x, double low) {
    const double z = x * x;
    double p = 1.0 / 355687428096000.0;
    p = p * z - 1.0 / 1307674368000.0;
    p = p * z + 1.0 / 6227020800.0;
    p = p * z - 1.0 / 39916800.0;
    p = p * z + 1.0 / 362880.0;
    p = p * z - 1.0 / 5040.0;
    p = p * z + 1.0 / 120.0;
    p = p * z - 1.0 / 6.0;
    return x + (x * z * p + low * (1.0 - 0.5 * z));
}

double cos_near_zero(double x, double low) {
    const double z = x * x;
    double p = -1.0 / 6402373705728000.0;
    p = p * z + 1.0 / 20922789888000.0;
    p = p * z - 1.0 / 87178291200.0;
    p = p * z + 1.0 / 479001600.0;
    p = p * z - 1.0 / 3628800.0;
    p = p * z + 1.0 / 40320.0;
    p = p * z - 1.0 / 720.0;
    p = p * z + 1.0 / 24.0;
    const double half = 0.5 * z;
    const double head = 1.0 - half;  // (1 − head) − half is what this rounding lost
    return head + (((1.0 - head) - half) + (z * z * p - x * low));
}

/// atan(k/8), k = 0 … 8, in two parts.
constexpr std::array<TwoPart, 9> atan_of_eighths{{{0.0, 0.0},
                                                  {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                  {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                  {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                  {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                  {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                  {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                  {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                  {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

/// atan(small/large) for 0 ≤ small ≤ large, 0 < large: atan(c) + atan((small − c·large) / (large + c·small)) with c the
/// nearest eighth, so that the series runs over |u| ≤ 1/16.
TwoPart atan_of_ratio(double small, double large) {
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): half-way either neighbour does, and lround is a call
    const auto eighth = static_cast<std::size_t>(8.0 * (small / large) + 0.5);
    const double c = 0.125 * static_cast<double>(eighth);
    const double u = (small - c * large) / (large + c * small);
    const double z = u * u;
    double p = 1.0 / 13.0;
    p = p * z - 1.0 / 11.0;
    p = p * z + 1.0 / 9.0;
    p = p * z - 1.0 / 7.0;
    p = p * z + 1.0 / 5.0;
    p = p * z - 1.0 / 3.0;
    const TwoPart base = atan_of_eighths[eighth];
    const double high = base.high + u;  // |u| ≤ 1/16 < atan(1/8), or the base is 0: the next line is exact
    return {high, ((base.high - high) + u) + (u * z * p + base.low)};
}

}  // namespace

CosSin cos_sin(double angle_rad) noexcept {
    if (!(std::fabs(angle_rad) <= 1e6)) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    const Reduced r = reduce(angle_rad);
    const double c = cos_near_zero(r.high, r.low);
    const double s = sin_near_zero(r.high, r.low);
    switch (r.quadrant & 3) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

double atan2_fixed(double y, double x) noexcept {
    constexpr TwoPart half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
    constexpr TwoPart whole_pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
    double ax = std::fabs(x);
    double ay = std::fabs(y);
    if (!(ax <= std::numeric_limits<double>::max() && ay <= std::numeric_limits<double>::max())) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (ax == 0.0 && ay == 0.0) return 0.0;
    // Powers of two change no digit; they keep c·large from overflow and from the denormals.
    const double scale = ax > 0x1p1000 || ay > 0x1p1000 ? 0x1p-8 : (ax < 0x1p-900 && ay < 0x1p-900 ? 0x1p200 : 1.0);
    ax *= scale;
    ay *= scale;
    const bool steep = ay > ax;
    const TwoPart a = steep ? atan_of_ratio(ax, ay) : atan_of_ratio(ay, ax);
    const bool left = x < 0.0;
    double angle = a.high + a.low;
    if (steep) {
        angle =
            left ? half_pi.high + (a.high + (a.low + half_pi.low)) : half_pi.high - (a.high + (a.low - half_pi.low));
    } else if (left) {
        angle = whole_pi.high - (a.high + (a.low - whole_pi.low));
    }
    return y < 0.0 ? -angle : angle;
}

}  // namespace ifedem

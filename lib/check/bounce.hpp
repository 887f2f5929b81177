#pragma once
#include <span>

namespace ifedem {

/// The strongest oscillation of a force between 1 and 25 Hz, by Fourier transform of its samples.
struct Bounce {
    double amplitude_N = 0;
    double frequency_Hz = 0;  ///< to within 1 / duration
};

/// Samples at equal intervals; all 0 if fewer than three. Throws Error(io) if GSL has no memory.
[[nodiscard]] Bounce find_bounce(std::span<const double> force_N, double interval_s);

}  // namespace ifedem

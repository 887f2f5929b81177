#include "check/bounce.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_fft_real.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "core/error.hpp"

namespace ifedem {

Bounce find_bounce(std::span<const double> force_N, double interval_s) {
    constexpr double lowest_Hz = 1, highest_Hz = 25;  // below: the controllers' transient; above: lugs and discs
    const std::size_t n = force_N.size();
    if (n < 3) return {};
    gsl_set_error_handler_off();
    std::vector<double> line(force_N.begin(), force_N.end());
    const double mean = std::accumulate(line.begin(), line.end(), 0.0) / static_cast<double>(n);
    for (double& f : line) f -= mean;
    const std::unique_ptr<gsl_fft_real_wavetable, decltype(&gsl_fft_real_wavetable_free)> table(
        gsl_fft_real_wavetable_alloc(n), gsl_fft_real_wavetable_free);
    const std::unique_ptr<gsl_fft_real_workspace, decltype(&gsl_fft_real_workspace_free)> space(
        gsl_fft_real_workspace_alloc(n), gsl_fft_real_workspace_free);
    if (!table || !space || gsl_fft_real_transform(line.data(), 1, n, table.get(), space.get()) != 0)
        fail_io("a series could not be transformed (GSL found no memory). Free some and try again?");
    Bounce strongest;
    for (std::size_t k = 1; 2 * k < n; ++k) {  // half-complex: the real and imaginary part of line k follow each other
        const double frequency = static_cast<double>(k) / (static_cast<double>(n) * interval_s);
        if (frequency < lowest_Hz || frequency > highest_Hz) continue;
        const double amplitude = 2 / static_cast<double>(n) * std::hypot(line[2 * k - 1], line[2 * k]);
        if (amplitude > strongest.amplitude_N) strongest = {amplitude, frequency};
    }
    return strongest;
}

}  // namespace ifedem

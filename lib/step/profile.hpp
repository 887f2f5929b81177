#pragma once
#include <array>

#include "core/clock.hpp"

namespace ifedem {

enum class Phase { lists, wheel_contact, wheel_force, wheel_motion, soil_elements, conversion, discs, watch };
inline constexpr std::array<const char*, 8> phase_name = {"neighbour lists",   "wheel contact", "wheel elements",
                                                          "wheel and control", "soil elements", "conversion",
                                                          "discs and walls",   "movement watch"};

/// Seconds spent in each phase of the step; off unless asked for.
struct Profile {
    bool on = false;
    std::array<double, phase_name.size()> seconds{};
};

/// Books the time since the last call on a phase.
class Lap {
public:
    explicit Lap(Profile& profile) : profile_(profile), last_(profile.on ? now() : 0.0) {}
    void operator()(Phase phase) {
        if (!profile_.on) return;
        const double t = now();
        profile_.seconds[static_cast<std::size_t>(phase)] += t - last_;
        last_ = t;
    }

private:
    static double now() { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }
    Profile& profile_;
    double last_;
};

}  // namespace ifedem

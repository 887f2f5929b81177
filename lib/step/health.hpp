#pragma once
#include <optional>
#include <string>

#include "step/scene.hpp"

namespace ifedem {

/// Steps between two looks at the whole state.
inline constexpr std::uint64_t health_interval = 50;

/// What went wrong first; prints as "step, body, value, limit and remedy".
struct Violation {
    std::uint64_t total_steps = 0;
    std::string what;  ///< "disc 17 has left the bin"
    double value = 0;
    double limit = 0;
    std::string remedy;  ///< "Halve time_step_s …"
};

/// NaN, a lost disc, too deep an overlap, an inverted element, a control error beyond its limit. Only looks.
[[nodiscard]] std::optional<Violation> check_health(const Scene& scene, const State& state, const Workspace& work);

[[nodiscard]] std::string to_text(const Violation& v);

}  // namespace ifedem

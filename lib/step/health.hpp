#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "step/energy.hpp"
#include "step/limits.hpp"
#include "step/scene.hpp"

namespace ifedem {

/// Steps between two looks at the whole state.
inline constexpr std::uint64_t health_interval = 50;

/// Why a run fails.
enum class Cause {
    contact_step,      ///< the step is too large for the springs of contacts
    contact_dashpot,   ///< the springs would bear the step, their dashpots do not
    element_step,      ///< too large for the wheel's elements
    control_step,      ///< too large for an explicit control loop
    coupling_step,     ///< too large for disc and wheel together
    rolling_sign,      ///< the raw sign of Eq 2.18 drives discs to and fro
    contact_overload,  ///< contacts too soft for what presses on them
    element_overload,  ///< a layer too soft for what presses on it
    tunnelling,        ///< a disc has passed the wheel's surface
    wedged,            ///< a disc is pressed between two sides of the wheel
    lost_disc,         ///< a disc has left the bin
    not_a_number,      ///< from no limit that is known
    loose_bed,         ///< the wheel is put on soil that does not carry yet
    shallow_bin,       ///< the wheel is near the floor
    short_bin,         ///< the wheel is at an end wall
    beyond_discs,      ///< the wheel is among soil elements, which it does not touch
    control_windup,    ///< the integral gain is beyond what the loop can hold
    control_weak,      ///< the loop does not follow its target
    energy_drift       ///< energy comes from nowhere, no limit is exceeded
};
[[nodiscard]] std::string_view cause_name(Cause cause);

/// What went wrong first; prints as "step, what, value, limit (of a finite value), cause and remedy".
struct Violation {
    std::uint64_t total_steps = 0;
    Cause cause = Cause::not_a_number;
    std::string what;  ///< "disc 17 has left the bin"
    double value = 0;
    double limit = 0;    ///< of no meaning where the value is not finite
    std::string remedy;  ///< "Lower time_step_s."
};
[[nodiscard]] std::string to_text(const Violation& v);

/// What the checks remember of a stage. It is made from scene and state at any time and never saved: a resumed run
/// begins a new window.
struct HealthWatch {
    std::vector<StepLimit> limits;  ///< at the beginning of the stage
    // The energy budget of the present window: a 25th of the stage, and 20 samples at least.
    bool begun = false;
    std::uint64_t window_steps = 0;
    std::uint64_t window_begin = 0;
    std::uint64_t samples = 0;
    EnergyStore stored;  ///< at its beginning
    EnergyLedger ledger;
    double squares_J2 = 0;        ///< Σ (flow · interval)² over samples and kinds: the variance of the sums
    double rolling_gained_J = 0;  ///< by samples in which the rolling resistance drives
    std::size_t conversions = 0;  ///< of soil blocks, so far
    // Of a bed that should come to rest.
    std::uint64_t rest_begin = 0;
    double rest_J = 0;         ///< energy there; 0: not begun
    int restless_windows = 0;  ///< one after the other
};

/// Finds the step's limits. The first window begins with the first sample: before a step the workspace has no contacts.
[[nodiscard]] HealthWatch begin_watch(const Scene& scene, const State& state);

/// The violation of a step that is beyond a limit before it is made.
[[nodiscard]] Violation refuse_step(const State& state, const StepLimit& exceeded, const HealthWatch& watch,
                                    double step_s);

/// Abrupt failures, every health_interval steps: NaN, a lost disc, one that goes its radius in a step, too deep an
/// overlap, a disc inside the wheel, an inverted element, the wheel at floor or end wall or among soil elements, a
/// control error beyond its limit; and at the beginning of sinkage a bed with fewer than two contacts a disc (it takes
/// three to carry with friction, four without). The cause is the limit of the step that is exceeded most, else what the
/// quantity itself says. Only looks.
[[nodiscard]] std::optional<Violation> check_health(const Scene& scene, const State& state, const Workspace& work,
                                                    const HealthWatch& watch = {});

/// Gradual failures, at each sample of the energy account: at the end of a window, energy that came from nowhere.
/// In each window, stored energy + losses − work should stay, and every loss be positive. What contradicts that fails
/// if it is more than a quarter of all that was turned over, more than three standard errors of the sampled sums, and
/// more than a hundredth of the kinetic energy; a rolling resistance also, if what it gave is more than that quarter.
/// A conversion of soil and a growing load begin a new window.
/// The ledger holds the sample already. Only looks.
[[nodiscard]] std::optional<Violation> check_budget(const Scene& scene, const State& state, const Workspace& work,
                                                    const EnergyFlow& sample, double interval_s, HealthWatch& watch);

/// The same without the account, for consolidation and any integrator, where the step is beyond a limit: a bed that has
/// lost less than a tenth of its kinetic energy in each of two windows, and moves faster than some tenths of a
/// millimetre a second (10⁻⁶ of a fall by its own diameter), does not come to rest. Only looks.
[[nodiscard]] std::optional<Violation> check_rest(const Scene& scene, const State& state, const Workspace& work,
                                                  HealthWatch& watch);

}  // namespace ifedem

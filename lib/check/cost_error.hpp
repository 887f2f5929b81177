#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/statistics.hpp"

namespace ifedem {

// Cost against error: what the chart of `ifedem points` rests on, free of runs and files.

/// The work of one run: discs times steps of all three stages, and what one disc-step costs.
struct Work {
    double disc_steps = 0;
    double ns_per_disc_step = 0;
    [[nodiscard]] double cpu_s() const { return 1e-9 * disc_steps * ns_per_disc_step; }
};

/// The text's scene: its discs and step over the same simulated time, at the disc-step's cost of the finest variant.
/// Extrapolated wherever that variant has other discs or another step.
[[nodiscard]] Work fidelity_work(double discs, double step_s, double simulated_s, double ns_per_disc_step);

/// One point of a chart. What is not finite is not drawn.
struct CostError {
    double cost = 0;
    double error = 0;
};

/// The points that no other matches at less cost or beats at the same, sorted by cost. An error below `floor` counts as
/// `floor`, since scatter shows no better; so the front ends at the cheapest such point. An infinite or unknown floor
/// counts as none.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const CostError> points, double floor);

/// 95 % half-width of a mean of n paired differences by the scatter that all variants' differences share; infinite if
/// that is not known.
[[nodiscard]] double scatter_floor(const PooledScatter& scatter, std::size_t n);

/// A rectangle of the picture, in pixels, y upward.
struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;
    [[nodiscard]] bool meets(const Box& other) const {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
};

/// A mark with its text.
struct Label {
    double x = 0, y = 0;           ///< of the mark
    double width = 0, height = 0;  ///< of the text
};

/// The text's box for each label: the nearest place round its mark, inside `area`, that meets no mark and no other
/// text; the nearest of all if none is free.
[[nodiscard]] std::vector<Box> place_labels(std::span<const Label> labels, const Box& area);

}  // namespace ifedem

#include "check/cost_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ifedem {
namespace {

constexpr double mark_px = 5;  ///< half the side of what a mark covers

Box mark_of(const Label& label) { return {label.x - mark_px, label.y - mark_px, label.x + mark_px, label.y + mark_px}; }

/// The text's box when it leaves its mark in a direction: -1, 0 or 1 in x and y.
Box text_box(const Label& label, int right, int up, double distance) {
    const double left = label.x + right * distance - 0.5 * (1 - right) * label.width;
    const double bottom = label.y + up * distance - 0.5 * (1 - up) * label.height;
    return {left, bottom, left + label.width, bottom + label.height};
}

bool is_inside(const Box& box, const Box& area) {
    return box.left >= area.left && box.right <= area.right && box.bottom >= area.bottom && box.top <= area.top;
}

}  // namespace

Work fidelity_work(double discs, double step_s, double simulated_s, double ns_per_disc_step) {
    return {discs * simulated_s / step_s, ns_per_disc_step};
}

std::vector<std::size_t> pareto_front(std::span<const CostError> points, double floor) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order,
                  [&](std::size_t k) { return !std::isfinite(points[k].cost) || !std::isfinite(points[k].error); });
    const auto error_of = [&](std::size_t k) { return std::max(points[k].error, std::isfinite(floor) ? floor : 0.0); };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : error_of(a) < error_of(b);
    });
    std::vector<std::size_t> front;
    for (const std::size_t k : order)
        if (front.empty() || error_of(k) < error_of(front.back())) front.push_back(k);
    return front;
}

double scatter_floor(const PooledScatter& scatter, std::size_t n) {
    if (scatter.degrees_of_freedom < 1 || n == 0) return std::numeric_limits<double>::infinity();
    return student_t_quantile(0.975, scatter.degrees_of_freedom) * scatter.deviation /
           std::sqrt(static_cast<double>(n));
}

std::vector<Box> place_labels(std::span<const Label> labels, const Box& area) {
    constexpr std::array<std::array<int, 2>, 8> directions{
        {{1, 0}, {1, 1}, {1, -1}, {-1, 0}, {-1, 1}, {-1, -1}, {0, 1}, {0, -1}}};
    constexpr std::array distances{8.0, 16.0, 26.0, 38.0, 52.0, 70.0, 90.0, 115.0, 145.0};
    std::vector<Box> placed;
    const auto is_free = [&](const Box& box) {
        return is_inside(box, area) &&
               std::ranges::none_of(placed, [&](const Box& other) { return box.meets(other); }) &&
               std::ranges::none_of(labels, [&](const Label& other) { return box.meets(mark_of(other)); });
    };
    const auto place = [&](const Label& label) {
        for (const double distance : distances)
            for (const auto& [right, up] : directions)
                if (const Box box = text_box(label, right, up, distance); is_free(box)) return box;
        return text_box(label, 1, 0, distances.front());
    };
    for (const Label& label : labels) placed.push_back(place(label));
    return placed;
}

}  // namespace ifedem

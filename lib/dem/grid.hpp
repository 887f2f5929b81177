#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/state.hpp"

namespace ifedem {

/// Cells as wide as the largest reach of a pair of usual skins, numbered column by column so that a wheel rut stays
/// near in memory.
struct Grid {
    double x0 = 0, y0 = 0, inverse_size = 0;
    std::uint32_t columns = 0, rows = 0;
    double last_column = 0, last_row = 0;
    std::vector<std::uint32_t> begin;  ///< per cell + 1
    std::vector<std::uint32_t> item;   ///< positions before sorting, ascending within a cell

    // Held between the first and the last as doubles, since a cast of NaN or of more than 2³² is undefined.
    [[nodiscard]] std::uint32_t column(double x) const {
        return static_cast<std::uint32_t>(std::min(last_column, std::max(0.0, (x - x0) * inverse_size)));
    }
    [[nodiscard]] std::uint32_t row(double y) const {
        return static_cast<std::uint32_t>(std::min(last_row, std::max(0.0, (y - y0) * inverse_size)));
    }
    [[nodiscard]] std::uint32_t cell(const Disc& d) const { return column(d.x_m) * rows + row(d.y_m); }
};

[[nodiscard]] Grid make_grid(const std::vector<Disc>& discs, double size_m);

}  // namespace ifedem

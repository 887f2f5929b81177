#include "dem/grid.hpp"

#include <cmath>
#include <limits>

namespace ifedem {

Grid make_grid(const std::vector<Disc>& discs, double size_m) {
    Grid g;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double x1 = -infinite, y1 = -infinite;
    g.x0 = infinite, g.y0 = infinite;
    for (const Disc& d : discs) {
        // A disc that has become NaN or gone beyond all numbers has no part in the bounds; the health check names it.
        constexpr double far = 1e300;
        if (!(std::fabs(d.x_m) < far && std::fabs(d.y_m) < far)) continue;
        g.x0 = std::min(g.x0, d.x_m), x1 = std::max(x1, d.x_m);
        g.y0 = std::min(g.y0, d.y_m), y1 = std::max(y1, d.y_m);
    }
    if (!(g.x0 <= x1)) g.x0 = x1 = g.y0 = y1 = 0;  // none left
    // A lost disc must not ask for the memory of a planet: the health check will name it.
    constexpr double most_cells_a_side = 4096;
    g.inverse_size = 1.0 / std::max(size_m, std::max(x1 - g.x0, y1 - g.y0) / most_cells_a_side);
    g.columns = static_cast<std::uint32_t>((x1 - g.x0) * g.inverse_size) + 1;
    g.rows = static_cast<std::uint32_t>((y1 - g.y0) * g.inverse_size) + 1;
    g.last_column = g.columns - 1.0, g.last_row = g.rows - 1.0;
    g.begin.assign(static_cast<std::size_t>(g.columns) * g.rows + 1, 0);
    g.item.resize(discs.size());
    for (const Disc& d : discs) ++g.begin[g.cell(d) + 1];
    for (std::size_t c = 1; c < g.begin.size(); ++c) g.begin[c] += g.begin[c - 1];
    std::vector<std::uint32_t> next(g.begin.begin(), g.begin.end() - 1);
    for (std::uint32_t p = 0; p < discs.size(); ++p) g.item[next[g.cell(discs[p])]++] = p;
    return g;
}

}  // namespace ifedem

// Scenes of soil elements with discs above or beside them.
#pragma once
#include <omp.h>

#include "support/dem_scenes.hpp"

namespace ifedem::scene {

/// Discs of one kind between smooth walls on a grid of elements; tests change what they look at before begin().
inline Case make_column_case(std::int64_t columns, std::int64_t rows, double block_length_m, double block_height_m) {
    Case c;
    c.elements.columns = columns, c.elements.rows = rows;
    c.elements.block_length_m = block_length_m, c.elements.block_height_m = block_height_m;
    c.bed.length_m = static_cast<double>(columns) * block_length_m;
    return c;
}

inline Vec2 momentum_of_scene(const World& w) {
    return momentum_of(w.state).linear_Ns + momentum_Ns(w.work.soil, w.state.soil);
}

}  // namespace ifedem::scene

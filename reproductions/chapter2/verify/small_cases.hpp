#pragma once
#include "output.hpp"

namespace ifedem::chapter2 {

/// Part of the topic contact: tables of launch, block, column, spinning pair and pair limit.
void draw_small_cases(Output& out);

}  // namespace ifedem::chapter2

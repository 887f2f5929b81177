#pragma once
#include "output.hpp"

namespace ifedem::chapter2 {

// Parts of the topic elements.
void measure_membranes(Output& out);    ///< two published problems, and errors against the size of the elements
void measure_exact_waves(Output& out);  ///< a bar at its largest step, where the wave is exact at the nodes

}  // namespace ifedem::chapter2

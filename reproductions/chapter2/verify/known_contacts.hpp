#pragma once
#include "output.hpp"

namespace ifedem::chapter2 {

/// Part of the topic traction: sums over contacts whose forces are known.
void measure_known_contacts(Output& out);

}  // namespace ifedem::chapter2

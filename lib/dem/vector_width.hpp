#pragma once
#include "dem/pair_kernel.hpp"

namespace ifedem {

/// Doubles per vector: the most that this processor has, or what the environment variable IFEDEM_VECTOR_WIDTH (1, 2, 4,
/// 8) asks for. Throws Error(bad_input) for any other value, or a width that the processor lacks.
[[nodiscard]] int vector_width();

/// The kernel of that width.
[[nodiscard]] PairKernel choose_pair_kernel(int width);

}  // namespace ifedem

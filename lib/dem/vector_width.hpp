#pragma once
#include "dem/pair_kernel.hpp"

namespace ifedem {

/// The widest kernel that this processor has, or the one that the environment variable IFEDEM_VECTOR_WIDTH (1, 2, 4, 8
/// doubles) asks for. Throws Error(bad_input) for any other value, or a width that the processor lacks.
[[nodiscard]] PairKernel choose_pair_kernel();

/// Doubles per vector of the chosen kernel, for the record.
[[nodiscard]] int vector_width();

}  // namespace ifedem

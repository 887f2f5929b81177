#pragma once
#include <string>

namespace ifedem {

/// Where style.gp, sweep.gp and templates/ are: beside an installed program, or in the source it was built from.
/// Throws Error(io) if neither is there.
[[nodiscard]] std::string share_directory();

}  // namespace ifedem

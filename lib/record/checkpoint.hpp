#pragma once
#include <string>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Raised by every commit that changes a state hash; CHANGELOG says why.
inline constexpr int results_version = 1;

/// Writes the whole state to `path` (HDF5, one dataset a member of for_each_member, units in attributes, the case as text),
/// to a temporary file that is flushed, checked and renamed: a reader sees the old file or the new one, never half.
/// A whole-file checksum stands in a file beside it (`path` + ".sum") or as a trailer; read_checkpoint verifies it before HDF5 opens the file.
/// Throws Error(io).
void write_checkpoint(const std::string& path, const State& state, const Case& c);

struct Checkpoint {
    Case c;
    State state;
    int results_version = 0;
};

/// Throws Error(io) with "what is wrong (why). What to do?" for a missing, damaged or incomplete file.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

}  // namespace ifedem

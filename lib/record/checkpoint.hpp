#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Raised by every commit that changes a state hash; CHANGELOG says why.
inline constexpr int results_version = 5;

/// Writes the whole state to `path`: HDF5, one dataset a member of for_each_member with its units as an attribute, the
/// case as text; after the HDF5 data stands a checksum of the whole file. Equal states make equal bytes. The file is
/// written under another name, flushed, read back and renamed: a reader sees the old file or the new one, never half.
/// Throws Error(io).
void write_checkpoint(const std::string& path, const State& state, const Case& c);

struct Checkpoint {
    Case c;
    State state;
    int results_version = 0;
};

/// Throws Error(io) with "what is wrong (why). What to do?" for a missing, damaged or incomplete file.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

/// The same from the bytes of a file; `path` stands for it in messages.
[[nodiscard]] Checkpoint decode_checkpoint(std::vector<std::byte> image, const std::string& path);

}  // namespace ifedem

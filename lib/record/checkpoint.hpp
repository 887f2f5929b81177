#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// Raised by every commit that changes a state hash; CHANGELOG says why.
inline constexpr int results_version = 5;

/// What a run has cost so far, all its parts together. Not of the state: no hash and no comparison sees it.
struct Spent {
    std::uint64_t steps = 0;
    double cpu_s = 0;
    double wall_s = 0;
};

/// Writes the whole state to `path`: HDF5, one dataset a member of for_each_member, with its units as an attribute
/// where state_fields.hpp names fields, the case as text, what was spent; after the HDF5 data stands a checksum of the
/// whole file. Equal states, cases and costs make equal bytes. The file is written under another name, flushed, read
/// back and renamed: a reader sees the old file or the new one, never half. Throws Error(io).
void write_checkpoint(const std::string& path, const State& state, const Case& c, const Spent& spent = {});

struct Checkpoint {
    Case c;
    State state;
    int results_version = 0;
    Spent spent;  ///< nothing in checkpoints from before it was kept
};

/// Throws Error(io) with "what is wrong (why). What to do?" for a missing, damaged or incomplete file.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

/// The same from the bytes of a file; `path` stands for it in messages.
[[nodiscard]] Checkpoint decode_checkpoint(std::vector<std::byte> image, const std::string& path);

}  // namespace ifedem

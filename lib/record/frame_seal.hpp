#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "record/files.hpp"

namespace ifedem {

// The seal of results.h5: checksums behind the end of HDF5's own bytes, which HDF5 ignores. It is verified before HDF5
// opens the file (HDF5 may crash or loop on a damaged one, and a disc that stands elsewhere looks like any other).
//
// While a run goes on, the seal holds a table of where rows stand, a checksum of all that does not change, one of each
// frame, and two slots that take turns to hold the number of frames. A frame is written in the order rows and checksum,
// slot, HDF5's own frame count, with a sync after each, so that a writer killed anywhere leaves the frames before. A
// finished file gets one checksum of all its bytes instead. A side file was rejected: it can be lost or stay behind
// when results are copied, and no rename replaces two files at once.

/// Where HDF5 keeps what changes while frames are added.
struct FrameLayout {
    struct Column {
        std::uint64_t offset = 0;    ///< of frame 0's row
        std::uint64_t row_size = 0;  ///< bytes
    };
    std::uint64_t hdf5_size = 0;  ///< bytes of the HDF5 file; the seal follows
    std::uint64_t room = 0;       ///< frames that there is room for
    std::uint64_t count_offset = 0;
    std::vector<Column> columns;
};

/// Keeps the seal of a file that is being written.
class FrameSeal {
public:
    FrameSeal() = default;
    /// Appends a seal to an HDF5 file without frames, or takes up the one of a file that verify_frame_file() has
    /// found whole. Throws Error(io).
    static FrameSeal create(OpenFile& file, FrameLayout layout);
    static FrameSeal attach(const OpenFile& file, FrameLayout layout, std::uint64_t frames);

    /// After the rows of the next frame are written; `sum` is that of frame_sum(). `later` leaves the syncs out: for a
    /// file that nobody relies on yet.
    enum class Sync { now, later };
    void add_frame(OpenFile& file, std::uint64_t sum, Sync sync);
    /// After an exception of add_frame(), which may have come as far as the slot: the frame is none.
    void take_back(OpenFile& file) const;
    /// Makes the file a finished one.
    void finish(OpenFile& file) const;

private:
    FrameLayout layout_;
    std::uint64_t head_sum_ = 0;
    std::uint64_t count_ = 0;
    std::uint64_t chain_ = 0;
};

/// Checksum of one frame from its rows in the order of the layout's columns.
[[nodiscard]] std::uint64_t frame_sum(std::uint64_t number, std::span<const std::uint64_t> row_sums);

struct FrameFileStatus {
    std::uint64_t frames = 0;  ///< complete ones; taken from the seal
    bool finished = false;
    std::uint64_t hdf5_size = 0;  ///< bytes before the seal
};

/// Verifies a results.h5, one still being written too, without HDF5. Throws Error(io) if any byte is not as written.
[[nodiscard]] FrameFileStatus verify_frame_file(const std::string& path);

}  // namespace ifedem

#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fem/mesh.hpp"
#include "record/files.hpp"
#include "record/frame.hpp"

namespace ifedem {

// results.h5: every column is one contiguous dataset with a row for each frame, made with room to spare. HDF5 writes
// its own structures when the file is made, and never again: a frame is plain bytes at places known beforehand, and
// after them the number of frames. So the file is a closed, whole HDF5 file at every instant, whenever its writer is
// killed, and a reader may open it at any time. (HDF5's own appending rewrites its structures in place: a writer killed
// then leaves nothing to read. Its single-writer mode keeps them in order but leaves a mark that ordinary readers
// refuse.) When the room is used up, a file twice as large is made beside it and renamed over it.

/// Rows that the datasets have room for. Unused room is a hole in the file and takes no disk space.
struct FrameRoom {
    std::uint64_t frames = 0;
    std::uint64_t discs = 0;
    std::uint64_t nodes = 0;
    friend bool operator==(const FrameRoom&, const FrameRoom&) = default;
};

/// What stands in results.h5 once.
struct FrameFileHeader {
    std::string case_text;  ///< resolved case, attribute `case`
    Mesh mesh;              ///< wheel/quad, wheel/part
};

/// What a list of frames needs to know of each.
struct FrameInfo {
    double time_s = 0;
    Progress progress;
    std::uint64_t disc_count = 0;
    std::uint64_t node_count = 0;
};

/// The writer of results.h5.
class FrameFile {
public:
    /// A new file for `first_discs` discs, in place of any old one. Throws Error(io).
    static FrameFile create(const std::string& path, FrameFileHeader header, std::uint64_t first_discs);
    /// An existing file; throws Error(io) if it is damaged or its case or mesh is another one.
    static FrameFile open(const std::string& path, FrameFileHeader header);

    /// Returns when the frame is on the disk. After an exception the file holds the frames before it.
    void append(const Frame& frame);
    /// Forgets the frames from number `count` on.
    void truncate(std::uint64_t count);
    /// Remakes the file without spare room: equal frames, equal bytes, however often the run was interrupted.
    void shrink();

    [[nodiscard]] const std::vector<FrameInfo>& frames() const { return frames_; }
    [[nodiscard]] const FrameRoom& room() const { return room_; }
    [[nodiscard]] std::size_t quad_count() const { return header_.mesh.quad.size(); }

private:
    FrameFile(std::string path, FrameFileHeader header) : path_(std::move(path)), header_(std::move(header)) {}
    void attach();
    void remake(const FrameRoom& room);
    void write_frame(std::uint64_t number, const Frame& frame);
    void write_count(std::uint64_t count);

    std::string path_;
    FrameFileHeader header_;
    FrameRoom room_;
    OpenFile file_;
    std::vector<std::uint64_t> column_offset_;  ///< of the first row, in for_each_column's order
    std::uint64_t disc_count_offset_ = 0;
    std::uint64_t node_count_offset_ = 0;
    std::uint64_t frame_count_offset_ = 0;
    std::vector<FrameInfo> frames_;
};

/// The complete frames of a results.h5, whoever wrote it and whether or not it is still being written. Throws
/// Error(io).
[[nodiscard]] std::vector<FrameInfo> read_frame_list(const std::string& path);
/// One of them. Throws Error(io).
[[nodiscard]] Frame read_frame(const std::string& path, std::uint64_t number);
/// The case that a results.h5 belongs to, as TOML, and the mesh of its wheel. Throws Error(io).
[[nodiscard]] FrameFileHeader read_frame_header(const std::string& path);

}  // namespace ifedem

#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fem/mesh.hpp"
#include "record/files.hpp"
#include "record/frame.hpp"
#include "record/frame_seal.hpp"

namespace ifedem {

// results.h5: every column is one contiguous dataset with a row for each frame, made with room to spare. HDF5 writes
// its own structures when the file is made, and never again: a frame is plain bytes at places known beforehand, and
// after them the number of frames. So the file is a closed, whole HDF5 file at every instant, whenever its writer is
// killed, and a reader may open it at any time. (HDF5's own appending rewrites its structures in place: a writer killed
// then leaves nothing to read. Its single-writer mode keeps them in order but leaves a mark that ordinary readers
// refuse.) When the room is used up, a file twice as large is made beside it and renamed over it. Checksums stand
// behind HDF5's bytes (frame_seal.hpp), and every reader here verifies them before HDF5 opens the file.

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
    /// Forgets the frames from number `count` on: the file is remade without them.
    void truncate(std::uint64_t count);
    /// Remakes the file without spare room and gives it its last seal: equal frames, equal bytes, however often the run
    /// was interrupted. More can be added afterwards.
    void finish();

    [[nodiscard]] const std::vector<FrameInfo>& frames() const { return frames_; }
    [[nodiscard]] const FrameRoom& room() const { return room_; }
    [[nodiscard]] std::size_t quad_count() const { return header_.mesh.quad.size(); }

private:
    FrameFile(std::string path, FrameFileHeader header) : path_(std::move(path)), header_(std::move(header)) {}
    void attach();
    /// A file with the first `kept` frames replaces this one.
    void remake(const FrameRoom& room, std::uint64_t kept);

    std::string path_;
    FrameFileHeader header_;
    FrameRoom room_;
    OpenFile file_;
    FrameLayout layout_;
    FrameSeal seal_;
    bool finished_ = false;
    bool failed_ = false;  ///< the last append() threw
    std::vector<FrameInfo> frames_;
};

/// The complete frames of a results.h5, whoever wrote it and whether or not it is still being written; its checksums
/// are verified once, when it is opened. All throw Error(io).
class FrameReader {
public:
    explicit FrameReader(std::string path);
    ~FrameReader();
    FrameReader(FrameReader&&) noexcept;
    FrameReader& operator=(FrameReader&&) noexcept;

    [[nodiscard]] const std::vector<FrameInfo>& frames() const;
    [[nodiscard]] Frame read(std::uint64_t number) const;
    /// The case that the file belongs to, as TOML, and the mesh of its wheel.
    [[nodiscard]] FrameFileHeader header() const;

private:
    friend class FrameFile;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The same for one look at a file.
[[nodiscard]] std::vector<FrameInfo> read_frame_list(const std::string& path);
[[nodiscard]] Frame read_frame(const std::string& path, std::uint64_t number);
[[nodiscard]] FrameFileHeader read_frame_header(const std::string& path);

}  // namespace ifedem

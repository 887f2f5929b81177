#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace ifedem {

/// Throws Error(io): "cannot <action> '<path>' (<reason of errno>). <what to do about that reason>."
[[noreturn]] void fail_errno(const std::string& action, const std::string& path);

/// A file whose bytes are not those that were written. What it held can be made again from the case.
class DamagedFile : public Error {
public:
    explicit DamagedFile(const std::string& message) : Error(ExitCode::io, message) {}
};

[[noreturn]] inline void fail_damaged(const std::string& message) { throw DamagedFile(message); }

/// An open file that closes itself. Positions are explicit (pread, pwrite), so there is no hidden offset to lose.
class OpenFile {
public:
    OpenFile() = default;
    /// `flags` as for open(2). Throws Error(io).
    OpenFile(std::string path, int flags);
    ~OpenFile();
    OpenFile(OpenFile&& other) noexcept
        : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(path_, other.path_);
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }

    /// Writes or reads all bytes or throws Error(io); a short read is an error too.
    void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
    void read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
    [[nodiscard]] std::uint64_t size() const;
    void truncate(std::uint64_t size);
    /// Returns when the data are on the disk.
    void sync();
    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    std::string path_;
    int descriptor_ = -1;
};

/// The bytes of a regular file. Throws Error(io).
[[nodiscard]] std::vector<std::byte> read_whole_file(const std::string& path);

/// Writes to `path`.tmp, syncs, reads it back (a full disk may keep zeros), renames it over `path`.
/// `path` holds the old bytes or the new ones at every instant. Throws Error(io).
void write_bytes_atomically(const std::string& path, std::span<const std::byte> bytes);

/// The same for text.
void write_file_atomically(const std::string& path, const std::string& text);

/// Renames a finished, synced file over `path` and syncs the directory, so that the new name survives a power cut.
void replace_file(const std::string& finished, const std::string& path);

}  // namespace ifedem

#include "record/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace ifedem {
namespace {

const char* advice(int reason) {
    switch (reason) {
        case ENOSPC:
        case EDQUOT:
            return "Free disk space and resume the run?";
        case EFBIG:
            return "Raise the limit on file sizes (ulimit -f) and resume the run?";
        case EACCES:
        case EPERM:
        case EROFS:
            return "Check the permissions of the file and its directory?";
        case ENOENT:
        case ENOTDIR:
            return "Check the path?";
        default:
            return "Check the path and the disk?";
    }
}

std::string directory_of(const std::string& path) {
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
}

/// Removes a temporary file unless it has been renamed: a failure leaves no litter on a disk that may be full.
class TemporaryName {
public:
    explicit TemporaryName(std::string path) : path_(std::move(path)) {}
    ~TemporaryName() { ::unlink(path_.c_str()); }
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

private:
    std::string path_;
};

}  // namespace

void fail_errno(const std::string& action, const std::string& path) {
    const int reason = errno;
    fail_io("cannot " + action + " '" + path + "' (" + std::generic_category().message(reason) + "). " +
            advice(reason));
}

OpenFile::OpenFile(std::string path, int flags) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), flags | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail_errno("open", path_);
}

OpenFile::~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OpenFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_errno("write", path_);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

void OpenFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_errno("read", path_);
        if (got == 0)
            fail_io("'" + path_ + "' ends too early (truncated?). Use an earlier copy or run the case again?");
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
}

std::uint64_t OpenFile::size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail_errno("examine", path_);
    if (!S_ISREG(status.st_mode)) fail_io("'" + path_ + "' is not a regular file. Check the path?");
    return static_cast<std::uint64_t>(status.st_size);
}

void OpenFile::truncate(std::uint64_t size) {
    if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail_errno("truncate", path_);
}

void OpenFile::sync() {
    if (::fdatasync(descriptor_) != 0) fail_errno("write", path_);
}

std::vector<std::byte> read_whole_file(const std::string& path) {
    const OpenFile file(path, O_RDONLY);
    std::vector<std::byte> bytes(file.size());
    file.read_at(0, bytes);
    return bytes;
}

void replace_file(const std::string& finished, const std::string& path) {
    if (std::rename(finished.c_str(), path.c_str()) != 0) fail_errno("replace", path);
    OpenFile directory(directory_of(path), O_RDONLY | O_DIRECTORY);
    directory.sync();
}

void write_bytes_atomically(const std::string& path, std::span<const std::byte> bytes) {
    const std::string temporary = path + ".tmp";
    const TemporaryName cleaner(temporary);
    {
        OpenFile file(temporary, O_WRONLY | O_CREAT | O_TRUNC);
        file.write_at(0, bytes);
        file.sync();
    }
    if (!std::ranges::equal(read_whole_file(temporary), bytes)) {
        fail_io("'" + path + "' was not stored as written (the disk may be full or failing). Free disk space?");
    }
    replace_file(temporary, path);
}

void write_file_atomically(const std::string& path, const std::string& text) {
    write_bytes_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace ifedem

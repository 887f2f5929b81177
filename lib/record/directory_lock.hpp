#pragma once
#include <string>
#include <utility>

#include "record/files.hpp"

namespace ifedem {

enum class Busy { refuse, wait };  ///< what to do about a directory that another process holds

/// Keeps a directory for one process, by flock(2) on the file `lock` in it: the kernel gives it free however the
/// process ends. Where the file system has no locks, nothing is kept.
class DirectoryLock {
public:
    static constexpr const char* file_name = "lock";

    DirectoryLock() = default;
    /// Throws Error(bad_input) if another process holds it and `busy` is refuse, Error(io) if there can be no lock
    /// file.
    DirectoryLock(const std::string& directory, Busy busy);
    /// Removes the file.
    ~DirectoryLock();
    DirectoryLock(DirectoryLock&& other) noexcept
        : path_(std::exchange(other.path_, {})), file_(std::move(other.file_)) {}
    DirectoryLock& operator=(DirectoryLock&& other) noexcept {
        std::swap(path_, other.path_);
        std::swap(file_, other.file_);
        return *this;
    }

private:
    std::string path_;
    OpenFile file_;
};

}  // namespace ifedem

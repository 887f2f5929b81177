#include "record/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "core/error.hpp"

namespace ifedem {
namespace {

/// Whether `path` still names the file that is open; its last holder may have removed it since.
bool is_named(int descriptor, const std::string& path) {
    struct stat open {};
    struct stat named {};
    return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

/// False: another process holds it.
bool take(int descriptor, Busy busy) {
    const int how = LOCK_EX | (busy == Busy::refuse ? LOCK_NB : 0);
    while (::flock(descriptor, how) != 0) {
        if (errno == EWOULDBLOCK) return false;
        if (errno != EINTR) return true;  // ENOLCK, ENOTSUP: no locks here
    }
    return true;
}

}  // namespace

DirectoryLock::DirectoryLock(const std::string& directory, Busy busy) : path_(directory + "/" + file_name) {
    while (true) {
        file_ = OpenFile(path_, O_RDWR | O_CREAT);
        if (!take(file_.descriptor(), busy))
            fail_input("'" + directory + "' is in use (another run holds '" + path_ +
                       "'). Wait for it, stop it, or choose another directory?");
        if (is_named(file_.descriptor(), path_)) return;
    }
}

DirectoryLock::~DirectoryLock() {
    if (!path_.empty()) ::unlink(path_.c_str());
}

}  // namespace ifedem

#pragma once
#include <stdexcept>
#include <string>

namespace ifedem {

/// What the program returns to the shell; the numbers are part of the contract with scripts.
enum class ExitCode : int {
    done = 0,
    check_worse = 1,  ///< a check is worse than its claim expects
    bad_input = 2,    ///< nothing has been written
    health = 3,       ///< a run was stopped by a health check; the last checkpoint is kept
    io = 4,           ///< a file could not be read or written
};

/// An error with the grammar "what is wrong (why). What to do?".
/// Thrown only outside the time loop: input, files, set-up.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
    ExitCode code_;
};

[[noreturn]] inline void fail_input(const std::string& message) { throw Error(ExitCode::bad_input, message); }
[[noreturn]] inline void fail_io(const std::string& message) { throw Error(ExitCode::io, message); }

}  // namespace ifedem

#pragma once
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "support/scratch.hpp"

namespace ifedem {

/// How a program ended: its exit status, or 128 + the signal as a shell has it.
struct ProgramEnd {
    int status = 0;
    bool by_signal = false;
    std::string errors;  ///< what it printed to stderr
};

/// The program `ifedem` in a child process, its output in files of a directory that the test owns.
class Program {
public:
    /// `prepare` runs in the child before the program.
    Program(
        std::vector<std::string> arguments, std::string log, const std::function<void()>& prepare = [] {})
        : log_(std::move(log)) {
        arguments.insert(arguments.begin(), IFEDEM_PROGRAM);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        child_ = fork();
        if (child_ != 0) return;
        const int out = open("/dev/null", O_WRONLY);
        const int err = open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        dup2(out, STDOUT_FILENO);
        dup2(err, STDERR_FILENO);
        prepare();
        execv(argv[0], argv.data());
        _exit(127);
    }
    void send(int signal) const { kill(child_, signal); }
    [[nodiscard]] ProgramEnd wait() const {
        int status = 0;
        waitpid(child_, &status, 0);
        const bool by_signal = WIFSIGNALED(status);
        std::ifstream log(log_, std::ios::binary);  // may be empty
        return {by_signal ? 128 + WTERMSIG(status) : WEXITSTATUS(status), by_signal,
                std::string(std::istreambuf_iterator<char>(log), {})};
    }

private:
    std::string log_;
    pid_t child_ = 0;
};

/// A value of a run's run.csv; "" if there is none.
inline std::string run_value(const std::string& directory, const std::string& name) {
    std::ifstream lines(directory + "/run.csv");
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(name + ",")) return line.substr(name.size() + 1, line.rfind(',') - name.size() - 1);
    }
    return "";
}

}  // namespace ifedem

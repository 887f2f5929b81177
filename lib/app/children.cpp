#include "app/children.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>

#include "core/error.hpp"

namespace ifedem {
namespace {

volatile std::sig_atomic_t signal_seen = 0;
extern "C" void note_child_signal(int number) { signal_seen = number; }

/// Without SA_RESTART: a signal ends the wait for a child. Who started us may have ignored SIGCHLD, and then children
/// leave no status.
void watch_signals() {
    struct sigaction action {};
    action.sa_handler = note_child_signal;
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);
    action.sa_handler = SIG_DFL;
    sigaction(SIGCHLD, &action, nullptr);
}

/// What it prints to stdout is left out, its errors are shown.
pid_t start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "ifedem");
    std::vector<char*> raw;
    for (std::string& a : arguments) raw.push_back(a.data());
    raw.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0) fail_io(fmt::format("cannot start another process ({}). Lower --jobs?", std::strerror(errno)));
    if (child > 0) return child;
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    execv("/proc/self/exe", raw.data());
    _exit(127);
}

}  // namespace

std::vector<int> run_children(const std::vector<std::vector<std::string>>& calls, int jobs) {
    watch_signals();
    std::vector<int> status(calls.size(), -1);
    std::map<pid_t, std::size_t> running;
    std::size_t next = 0;
    while (next < calls.size() || !running.empty()) {
        if (signal_seen != 0) {
            next = calls.size();
            for (const auto& [child, call] : running) kill(child, signal_seen);
        }
        while (next < calls.size() && running.size() < static_cast<std::size_t>(jobs)) {
            running[start(calls[next])] = next;
            ++next;
        }
        if (running.empty()) break;
        int ended = 0;
        const pid_t child = waitpid(-1, &ended, 0);
        if (child < 0 && errno == EINTR) continue;
        if (child < 0) fail_io(fmt::format("lost a process ({}). Run the command again?", std::strerror(errno)));
        const auto found = running.find(child);
        if (found == running.end()) continue;
        status[found->second] = WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended);
        running.erase(found);
    }
    return status;
}

int signal_of_children() { return signal_seen; }

int report_signal() {
    fmt::print(stderr, "stopped by signal {}; the same command goes on\n", signal_of_children());
    return 128 + signal_of_children();
}

}  // namespace ifedem

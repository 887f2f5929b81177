// OpenMP for ThreadSanitizer. The system's libomp is not instrumented, so the sanitizer does not see that its barriers
// order anything and reports races where there are none. The library uses `parallel`, `barrier`, the number of threads
// and the thread's number; here these are made of what the sanitizer knows. clang's entry points (kmp.h of LLVM 14).
#include <condition_variable>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace {

class Barrier {
public:
    explicit Barrier(int threads) : threads_(threads) {}
    void wait() {
        std::unique_lock lock(mutex_);
        const unsigned long round = round_;
        if (++arrived_ == threads_) {
            arrived_ = 0;
            ++round_;
            all_here_.notify_all();
        } else {
            all_here_.wait(lock, [&] { return round_ != round; });
        }
    }

private:
    std::mutex mutex_;
    std::condition_variable all_here_;
    int threads_, arrived_ = 0;
    unsigned long round_ = 0;
};

int wanted_threads = 1;
thread_local int thread_number = 0;
thread_local int thread_count = 1;
thread_local Barrier* team = nullptr;

constexpr int most_arguments = 8;
using Microtask = void (*)(int*, int*, ...);

void call(Microtask task, int number, int count, void* const* a) {
    int own = number, zero = 0;
    switch (count) {
        case 0:
            return task(&own, &zero);
        case 1:
            return task(&own, &zero, a[0]);
        case 2:
            return task(&own, &zero, a[0], a[1]);
        case 3:
            return task(&own, &zero, a[0], a[1], a[2]);
        case 4:
            return task(&own, &zero, a[0], a[1], a[2], a[3]);
        case 5:
            return task(&own, &zero, a[0], a[1], a[2], a[3], a[4]);
        case 6:
            return task(&own, &zero, a[0], a[1], a[2], a[3], a[4], a[5]);
        case 7:
            return task(&own, &zero, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
        case 8:
            return task(&own, &zero, a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7]);
        default:
            std::fprintf(stderr, "openmp_threads.cpp: %d shared variables\n", count);
            std::abort();
    }
}

}  // namespace

extern "C" {

void omp_set_num_threads(int n) { wanted_threads = n; }
int omp_get_num_threads() { return thread_count; }
int omp_get_thread_num() { return thread_number; }
int omp_get_max_threads() { return wanted_threads; }
int __kmpc_global_thread_num(void*) { return thread_number; }  // NOLINT: LLVM's names
void __kmpc_barrier(void*, int) {                              // NOLINT
    if (team != nullptr) team->wait();
}

void __kmpc_fork_call(void*, int count, Microtask task, ...) {  // NOLINT
    void* arguments[most_arguments] = {};
    std::va_list list;
    va_start(list, task);
    for (int k = 0; k < count && k < most_arguments; ++k) arguments[k] = va_arg(list, void*);
    va_end(list);
    const int threads = team == nullptr ? wanted_threads : 1;  // no nesting
    Barrier barrier(threads);
    Barrier* const outer = team;
    const auto work = [&](int number) {
        thread_number = number;
        thread_count = threads;
        team = &barrier;
        call(task, number, count, arguments);
    };
    std::vector<std::thread> others;
    for (int number = 1; number < threads; ++number) others.emplace_back(work, number);
    work(0);
    for (std::thread& other : others) other.join();
    thread_count = 1;
    team = outer;
}
}

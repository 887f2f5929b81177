#include "dem/threads.hpp"

#include <omp.h>

#include <cstdlib>
#include <thread>

namespace ifedem {

void set_threads(int count) {
    // A step of 20,000 discs takes some 0.3 ms, and a thread that sleeps at a barrier needs a good part of that to
    // wake: with a core for each they spin. With fewer cores they sleep, since spinning ones keep the others from
    // working.
    const bool core_for_each = count <= static_cast<int>(std::thread::hardware_concurrency());
    setenv("OMP_WAIT_POLICY", count > 1 && core_for_each ? "active" : "passive", 0);
    omp_set_num_threads(count);
}

}  // namespace ifedem

#include "dem/threads.hpp"

#include <omp.h>

#include <cstdlib>
#include <thread>

namespace ifedem {

void set_threads(int count) {
    // A step of 20,000 discs takes some 0.3 ms, and a thread that sleeps at a barrier needs a good part of that to
    // wake: with a core for each it spins for a millisecond first (for ever, as "active" has it, would be a bad
    // neighbour). With fewer cores it sleeps at once, since spinning threads keep the others from working.
    if (count <= static_cast<int>(std::thread::hardware_concurrency()))
        setenv("KMP_BLOCKTIME", "1", 0);
    else
        setenv("OMP_WAIT_POLICY", "passive", 0);
    omp_set_num_threads(count);
}

}  // namespace ifedem

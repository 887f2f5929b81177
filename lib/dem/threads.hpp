#pragma once

namespace ifedem {

/// Threads of the loop over blocks of discs. To be called before the first step: OpenMP reads its wait policy once, so
/// later calls change the number alone. OMP_WAIT_POLICY in the environment has the last word (and is the only one for
/// builds by g++, whose OpenMP reads it before main).
void set_threads(int count);

}  // namespace ifedem

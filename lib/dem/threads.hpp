#pragma once

namespace ifedem {

/// Threads of the loop over blocks of discs. To be called before the first step: OpenMP reads its wait policy once, so
/// later calls change the number alone. KMP_BLOCKTIME or OMP_WAIT_POLICY in the environment have the last word (and
/// are the only one for builds by g++, whose OpenMP reads them before main).
void set_threads(int count);

}  // namespace ifedem

#include "dem/pair_kernel.hpp"

namespace ifedem {

void add_pairs_sse2(const ContactConstants& k, const PairBatch& batch) { add_pairs<2>(k, batch); }

}  // namespace ifedem

#include "dem/pair_kernel.hpp"

namespace ifedem {

void add_pairs_avx2(const ContactConstants& k, const PairBatch& batch) { add_pairs<4>(k, batch); }

}  // namespace ifedem

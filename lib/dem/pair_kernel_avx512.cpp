#include "dem/pair_kernel.hpp"

namespace ifedem {

void add_pairs_avx512(const ContactConstants& k, const PairBatch& batch) { add_pairs<8>(k, batch); }

}  // namespace ifedem

#include "dem/vector_width.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace ifedem {
namespace {

bool has_width(int width) {
    switch (width) {
        case 1:
        case 2:
            return true;
        case 4:
            return __builtin_cpu_supports("avx2") != 0;
        case 8:  // all that pair_kernel_avx512.cpp is compiled with
            return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                   __builtin_cpu_supports("avx512vl") != 0;
        default:
            return false;
    }
}

}  // namespace

int vector_width() {
    const char* asked = std::getenv("IFEDEM_VECTOR_WIDTH");
    if (asked == nullptr) return has_width(8) ? 8 : has_width(4) ? 4 : 2;
    for (const int width : {1, 2, 4, 8})
        if (std::to_string(width) == asked && has_width(width)) return width;
    fail_input(
        fmt::format("IFEDEM_VECTOR_WIDTH={}: not a width of this processor (1, 2, and 4 with AVX2, 8 with "
                    "AVX-512). Unset it to take the widest?",
                    asked));
}

PairKernel choose_pair_kernel(int width) {
    switch (width) {
        case 8:
            return add_pairs_avx512;
        case 4:
            return add_pairs_avx2;
        case 2:
            return add_pairs_sse2;
        default:
            return add_pairs<1>;
    }
}

}  // namespace ifedem

#pragma once

// A thin layer over the compilers' vector extensions: W doubles that behave like one. Only element-wise IEEE operations, so the
// bits do not depend on W. Included by translation units built for different instruction sets: everything is inlined
// by force, since a shared out-of-line copy could be taken from the unit with the newest instructions.
#define IFEDEM_INLINE [[gnu::always_inline]] inline

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ifedem {

template <int W>
struct Pack {
    using Raw [[gnu::vector_size(8 * W)]] = double;
    Raw v;
    Pack() = default;
    IFEDEM_INLINE Pack(double a) : v(Raw{} + a) {}  // implicit on purpose: constants mix with packs as with doubles
    IFEDEM_INLINE explicit Pack(const double* p) { __builtin_memcpy(&v, p, sizeof v); }
    struct FromRaw {};
    IFEDEM_INLINE Pack(FromRaw, Raw r) : v(r) {}
    IFEDEM_INLINE void store(double* p) const { __builtin_memcpy(p, &v, sizeof v); }
    IFEDEM_INLINE friend Pack operator+(Pack a, Pack b) { return {FromRaw{}, a.v + b.v}; }
    IFEDEM_INLINE friend Pack operator-(Pack a, Pack b) { return {FromRaw{}, a.v - b.v}; }
    IFEDEM_INLINE friend Pack operator*(Pack a, Pack b) { return {FromRaw{}, a.v * b.v}; }
    IFEDEM_INLINE friend Pack operator/(Pack a, Pack b) { return {FromRaw{}, a.v / b.v}; }
    IFEDEM_INLINE friend Pack min_of(Pack a, Pack b) { return {FromRaw{}, a.v < b.v ? a.v : b.v}; }
    IFEDEM_INLINE friend Pack max_of(Pack a, Pack b) { return {FromRaw{}, a.v > b.v ? a.v : b.v}; }
    IFEDEM_INLINE friend Pack select_positive(Pack condition, Pack a) {
        return {FromRaw{}, condition.v > Raw{} ? a.v : Raw{}};
    }
    IFEDEM_INLINE friend Pack root(Pack a) {
        if constexpr (W == 2) {
#if defined(__SSE2__)
            return {FromRaw{}, static_cast<Raw>(_mm_sqrt_pd(a.v))};
#endif
        } else if constexpr (W == 4) {
#if defined(__AVX__)
            return {FromRaw{}, static_cast<Raw>(_mm256_sqrt_pd(a.v))};
#endif
        } else if constexpr (W == 8) {
#if defined(__AVX512F__)
            return {FromRaw{}, static_cast<Raw>(_mm512_sqrt_pd(a.v))};
#endif
        }
        Pack r;
        for (int k = 0; k < W; ++k) r.v[k] = __builtin_sqrt(a.v[k]);
        return r;
    }
};

}  // namespace ifedem

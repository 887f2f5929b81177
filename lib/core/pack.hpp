#pragma once
#include "core/force_inline.hpp"

// A thin layer over the compilers' vector extensions: W doubles that behave like one. Only element-wise IEEE
// operations, so the bits do not depend on W.

// How wide vectors are passed to functions is no matter where none is called.
#pragma GCC diagnostic ignored "-Wpsabi"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace ifedem {

/// The compiler's vector of W doubles. Spelt out because g++ ignores a vector size that depends on a template
/// parameter.
template <int W>
struct RawVector;
template <>
struct RawVector<2> {
    using Type __attribute__((vector_size(16))) = double;
};
template <>
struct RawVector<4> {
    using Type __attribute__((vector_size(32))) = double;
};
template <>
struct RawVector<8> {
    using Type __attribute__((vector_size(64))) = double;
};

template <int W>
struct Pack {
    using Raw = typename RawVector<W>::Type;
    Raw v;
    Pack() = default;
    IFEDEM_INLINE Pack(double a) : v(Raw{} + a) {}  // implicit on purpose: constants mix with packs as with doubles
    IFEDEM_INLINE explicit Pack(const double* p) { __builtin_memcpy(&v, p, sizeof v); }
    struct FromRaw {};
    IFEDEM_INLINE Pack(FromRaw, Raw r) : v(r) {}
    IFEDEM_INLINE void store(double* p) const { __builtin_memcpy(p, &v, sizeof v); }
    IFEDEM_INLINE friend Pack operator+(Pack a, Pack b) { return {FromRaw{}, a.v + b.v}; }
    IFEDEM_INLINE friend Pack operator-(Pack a, Pack b) { return {FromRaw{}, a.v - b.v}; }
    IFEDEM_INLINE friend Pack operator-(Pack a) { return {FromRaw{}, -a.v}; }
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
        } else if constexpr (W == 4) {  // NOLINT(bugprone-branch-clone): empty where the instruction is not for all
#if defined(__AVX__)
            return {FromRaw{}, static_cast<Raw>(_mm256_sqrt_pd(a.v))};
#endif
        } else if constexpr (W == 8) {
#if defined(__AVX512F__)  // masked: the plain one warns of its own undefined operand in g++ 12
            return {FromRaw{}, static_cast<Raw>(_mm512_maskz_sqrt_pd(0xff, a.v))};
#endif
        }
        Pack r;
        for (int k = 0; k < W; ++k) r.v[k] = __builtin_sqrt(a.v[k]);
        return r;
    }
};

using Two = RawVector<2>::Type;
using Four = RawVector<4>::Type;
using Eight = RawVector<8>::Type;

template <class V>
IFEDEM_INLINE V load_as(const double* p) {
    V v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}

/// Rows of four records become columns, and columns rows.
struct FourRows {
    Four a, b, c, d;
};
IFEDEM_INLINE FourRows transpose(const FourRows& r) {
    const Four ab02 = __builtin_shufflevector(r.a, r.b, 0, 4, 2, 6),
               ab13 = __builtin_shufflevector(r.a, r.b, 1, 5, 3, 7);
    const Four cd02 = __builtin_shufflevector(r.c, r.d, 0, 4, 2, 6),
               cd13 = __builtin_shufflevector(r.c, r.d, 1, 5, 3, 7);
    return {__builtin_shufflevector(ab02, cd02, 0, 1, 4, 5), __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5),
            __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7), __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7)};
}

}  // namespace ifedem

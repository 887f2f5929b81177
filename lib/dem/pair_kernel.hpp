#pragma once
#include <cstdint>

#include "core/pack.hpp"
#include "dem/contact_law.hpp"
#include "dem/dem_workspace.hpp"
#include "model/state.hpp"

namespace ifedem {

/// A block's pairs as plain pointers: the kernels use no library code, see core/pack.hpp.
struct PairBatch {
    const Disc* disc = nullptr;
    const std::uint32_t *i = nullptr, *j = nullptr, *slot_i = nullptr, *slot_j = nullptr;
    const double* damping_Ns_m = nullptr;
    double* spring_m = nullptr;
    DiscForce* force = nullptr;
    std::uint32_t begin = 0, end = 0;
    double spring_step_s = 0;
};

/// Adds the forces of the pairs [begin, end) in order. One for each instruction set; all give the same bits.
using PairKernel = void (*)(const ContactConstants&, const PairBatch&);

void add_pairs_sse2(const ContactConstants& k, const PairBatch& batch);
void add_pairs_avx2(const ContactConstants& k, const PairBatch& batch);
void add_pairs_avx512(const ContactConstants& k, const PairBatch& batch);

/// What a pair's law needs of one disc, and what it gives to one.
template <class V>
struct PairSide {
    V x, y, vx, vy, omega, radius;
};
template <class V>
struct PairForces {
    V x, y, moment_i, moment_j, rolling, spring;
};

/// Eq 2.17 between discs i and j; the force is that on j, the opposite acts on i.
template <class V>
IFEDEM_INLINE PairForces<V> pair_forces(const ContactConstants& k, const PairSide<V>& i, const PairSide<V>& j,
                                        V damping, V spring, V spring_step) {
    const V dx = j.x - i.x, dy = j.y - i.y;
    const V distance = root(dx * dx + dy * dy);
    const V overlap = (i.radius + j.radius) - distance;
    const V inverse = 1.0 / distance;
    const V nx = dx * inverse, ny = dy * inverse;
    const V ux = i.vx - j.vx, uy = i.vy - j.vy;
    const V half_overlap = 0.5 * overlap;
    const V arm_i = i.radius - half_overlap, arm_j = j.radius - half_overlap;
    const V approach = ux * nx + uy * ny;
    const V sliding = (uy * nx - ux * ny) + (i.omega * arm_i + j.omega * arm_j);
    const V half_chord = (0.5 * inverse) * root(max_of(chord_product(overlap, i.radius, j.radius), V(0.0)));
    const auto f = contact_forces(k, overlap, approach, sliding, damping, spring, spring_step, half_chord);
    return {f.normal_N * nx - f.tangential_N * ny,
            f.normal_N * ny + f.tangential_N * nx,
            V(0.0) - f.tangential_N * arm_i,
            V(0.0) - f.tangential_N * arm_j,
            f.rolling_limit_Nm,
            f.tangential_spring_m};
}

/// One pair; also the tail of a block.
IFEDEM_INLINE void add_one_pair(const ContactConstants& k, const PairBatch& b, std::uint32_t n) {
    const Disc &di = b.disc[b.i[n]], &dj = b.disc[b.j[n]];
    const auto f = pair_forces<double>(k, {di.x_m, di.y_m, di.vx_m_s, di.vy_m_s, di.omega_rad_s, di.radius_m},
                                       {dj.x_m, dj.y_m, dj.vx_m_s, dj.vy_m_s, dj.omega_rad_s, dj.radius_m},
                                       b.damping_Ns_m[n], b.spring_m[n], b.spring_step_s);
    b.spring_m[n] = f.spring;
    DiscForce& on_i = b.force[b.slot_i[n]];
    on_i.x_N -= f.x, on_i.y_N -= f.y, on_i.moment_Nm += f.moment_i, on_i.rolling_limit_Nm += f.rolling;
    DiscForce& on_j = b.force[b.slot_j[n]];
    on_j.x_N += f.x, on_j.y_N += f.y, on_j.moment_Nm += f.moment_j, on_j.rolling_limit_Nm += f.rolling;
}

using Four = RawVector<4>::Type;

/// W discs' records, transposed: one load a record (or half of one) and shuffles instead of gathers.
template <int W>
IFEDEM_INLINE PairSide<Pack<W>> load_side(const Disc* disc, const std::uint32_t* at);

template <>
IFEDEM_INLINE PairSide<Pack<2>> load_side<2>(const Disc* disc, const std::uint32_t* at) {
    using P = Pack<2>;
    using R = P::Raw;
    const Disc &a = disc[at[0]], &b = disc[at[1]];
    return {{P::FromRaw{}, R{a.x_m, b.x_m}},
            {P::FromRaw{}, R{a.y_m, b.y_m}},
            {P::FromRaw{}, R{a.vx_m_s, b.vx_m_s}},
            {P::FromRaw{}, R{a.vy_m_s, b.vy_m_s}},
            {P::FromRaw{}, R{a.omega_rad_s, b.omega_rad_s}},
            {P::FromRaw{}, R{a.radius_m, b.radius_m}}};
}

template <>
IFEDEM_INLINE PairSide<Pack<4>> load_side<4>(const Disc* disc, const std::uint32_t* at) {
    using P = Pack<4>;
    using R = P::Raw;
    R low[4], high[4];
    for (int n = 0; n < 4; ++n) {
        __builtin_memcpy(&low[n], &disc[at[n]].x_m, 32);
        __builtin_memcpy(&high[n], &disc[at[n]].omega_rad_s, 32);
    }
    const R a = __builtin_shufflevector(low[0], low[1], 0, 4, 2, 6),
            b = __builtin_shufflevector(low[0], low[1], 1, 5, 3, 7);
    const R c = __builtin_shufflevector(low[2], low[3], 0, 4, 2, 6),
            d = __builtin_shufflevector(low[2], low[3], 1, 5, 3, 7);
    const R e = __builtin_shufflevector(high[0], high[1], 0, 4, 2, 6),
            f = __builtin_shufflevector(high[0], high[1], 1, 5, 3, 7);
    const R g = __builtin_shufflevector(high[2], high[3], 0, 4, 2, 6),
            h = __builtin_shufflevector(high[2], high[3], 1, 5, 3, 7);
    return {{P::FromRaw{}, __builtin_shufflevector(a, c, 0, 1, 4, 5)},
            {P::FromRaw{}, __builtin_shufflevector(b, d, 0, 1, 4, 5)},
            {P::FromRaw{}, __builtin_shufflevector(a, c, 2, 3, 6, 7)},
            {P::FromRaw{}, __builtin_shufflevector(b, d, 2, 3, 6, 7)},
            {P::FromRaw{}, __builtin_shufflevector(e, g, 0, 1, 4, 5)},
            {P::FromRaw{}, __builtin_shufflevector(f, h, 0, 1, 4, 5)}};
}

template <>
IFEDEM_INLINE PairSide<Pack<8>> load_side<8>(const Disc* disc, const std::uint32_t* at) {
    using P = Pack<8>;
    using R = P::Raw;
    R r[8], even[4], odd[4];
    for (int n = 0; n < 8; ++n) __builtin_memcpy(&r[n], &disc[at[n]].x_m, 64);
    for (int n = 0; n < 4; ++n) {  // columns of two records side by side: 0 0 2 2 4 4 6 6 and 1 1 3 3 5 5 7 7
        even[n] = __builtin_shufflevector(r[2 * n], r[2 * n + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        odd[n] = __builtin_shufflevector(r[2 * n], r[2 * n + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    // columns 0 and 4 of four records, then 2 and 6; the same for the odd ones
    const R e04a = __builtin_shufflevector(even[0], even[1], 0, 1, 4, 5, 8, 9, 12, 13);
    const R e04b = __builtin_shufflevector(even[2], even[3], 0, 1, 4, 5, 8, 9, 12, 13);
    const R e2a = __builtin_shufflevector(even[0], even[1], 2, 3, 6, 7, 10, 11, 14, 15);
    const R e2b = __builtin_shufflevector(even[2], even[3], 2, 3, 6, 7, 10, 11, 14, 15);
    const R o15a = __builtin_shufflevector(odd[0], odd[1], 0, 1, 4, 5, 8, 9, 12, 13);
    const R o15b = __builtin_shufflevector(odd[2], odd[3], 0, 1, 4, 5, 8, 9, 12, 13);
    const R o3a = __builtin_shufflevector(odd[0], odd[1], 2, 3, 6, 7, 10, 11, 14, 15);
    const R o3b = __builtin_shufflevector(odd[2], odd[3], 2, 3, 6, 7, 10, 11, 14, 15);
    return {{P::FromRaw{}, __builtin_shufflevector(e04a, e04b, 0, 1, 4, 5, 8, 9, 12, 13)},
            {P::FromRaw{}, __builtin_shufflevector(o15a, o15b, 0, 1, 4, 5, 8, 9, 12, 13)},
            {P::FromRaw{}, __builtin_shufflevector(e2a, e2b, 0, 1, 4, 5, 8, 9, 12, 13)},
            {P::FromRaw{}, __builtin_shufflevector(o3a, o3b, 0, 1, 4, 5, 8, 9, 12, 13)},
            {P::FromRaw{}, __builtin_shufflevector(e04a, e04b, 2, 3, 6, 7, 10, 11, 14, 15)},
            {P::FromRaw{}, __builtin_shufflevector(o15a, o15b, 2, 3, 6, 7, 10, 11, 14, 15)}};
}

/// Adds lane n of (x, y, moment, rolling) to the slot's record.
template <int W>
IFEDEM_INLINE void add_lane(DiscForce& to, const Pack<W>& x, const Pack<W>& y, const Pack<W>& moment,
                            const Pack<W>& rolling, int n) {
    to.x_N += x.v[n], to.y_N += y.v[n], to.moment_Nm += moment.v[n], to.rolling_limit_Nm += rolling.v[n];
}

/// Four lanes of four columns as four records.
IFEDEM_INLINE void transpose_four(const Four in[4], Four out[4]) {
    const Four a = __builtin_shufflevector(in[0], in[1], 0, 4, 2, 6),
               b = __builtin_shufflevector(in[0], in[1], 1, 5, 3, 7);
    const Four c = __builtin_shufflevector(in[2], in[3], 0, 4, 2, 6),
               d = __builtin_shufflevector(in[2], in[3], 1, 5, 3, 7);
    out[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5), out[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    out[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7), out[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

IFEDEM_INLINE void add_record(DiscForce& to, Four f) {
    Four old;
    __builtin_memcpy(&old, &to.x_N, 32);
    old += f;
    __builtin_memcpy(&to.x_N, &old, 32);
}

/// Sums pair by pair, i before j: the order of the scalar loop, hence its bits.
template <int W>
IFEDEM_INLINE void scatter(const PairBatch& b, std::uint32_t n, const PairForces<Pack<W>>& f) {
    const Pack<W> x = Pack<W>(0.0) - f.x, y = Pack<W>(0.0) - f.y;
    if constexpr (W == 2) {
        for (int lane = 0; lane < 2; ++lane) {
            const std::uint32_t at = n + static_cast<std::uint32_t>(lane);
            add_lane(b.force[b.slot_i[at]], x, y, f.moment_i, f.rolling, lane);
            add_lane(b.force[b.slot_j[at]], f.x, f.y, f.moment_j, f.rolling, lane);
        }
    } else {
        for (int part = 0; part < W / 4; ++part) {
            Four on_i[4], on_j[4], out_i[4], out_j[4];
            const auto quarter = [part](const Pack<W>& p) {
                Four r;
                __builtin_memcpy(&r, reinterpret_cast<const char*>(&p.v) + 32 * part, 32);
                return r;
            };
            on_i[0] = quarter(x), on_i[1] = quarter(y), on_i[2] = quarter(f.moment_i), on_i[3] = quarter(f.rolling);
            on_j[0] = quarter(f.x), on_j[1] = quarter(f.y), on_j[2] = quarter(f.moment_j), on_j[3] = on_i[3];
            transpose_four(on_i, out_i);
            transpose_four(on_j, out_j);
            for (int lane = 0; lane < 4; ++lane) {
                const std::uint32_t at = n + static_cast<std::uint32_t>(4 * part + lane);
                add_record(b.force[b.slot_i[at]], out_i[lane]);
                add_record(b.force[b.slot_j[at]], out_j[lane]);
            }
        }
    }
}

/// The law for W pairs from `n` on; their springs are stored.
template <int W>
IFEDEM_INLINE PairForces<Pack<W>> compute_pairs(const ContactConstants& k, const PairBatch& b, std::uint32_t n) {
    const auto f = pair_forces<Pack<W>>(k, load_side<W>(b.disc, b.i + n), load_side<W>(b.disc, b.j + n),
                                        Pack<W>(b.damping_Ns_m + n), Pack<W>(b.spring_m + n), b.spring_step_s);
    f.spring.store(b.spring_m + n);
    return f;
}

/// Software-pipelined: the sums of one batch wait on memory while the roots and divisions of the next are under way
/// (27 → 16 ns a particle-step with 8 lanes). Constants are copied so that no store can be thought to change them.
template <int W>
IFEDEM_INLINE void add_pairs(const ContactConstants& constants, const PairBatch& batch) {
    const ContactConstants k = constants;
    const PairBatch b = batch;
    std::uint32_t n = b.begin;
    if (n + W <= b.end) {
        auto ready = compute_pairs<W>(k, b, n);
        for (n += W; n + W <= b.end; n += W) {
            const auto next = compute_pairs<W>(k, b, n);
            scatter<W>(b, n - W, ready);
            ready = next;
        }
        scatter<W>(b, n - W, ready);
    }
    for (; n < b.end; ++n) add_one_pair(k, b, n);
}

}  // namespace ifedem

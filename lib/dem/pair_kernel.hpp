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
    double* rolling_Nm = nullptr;  ///< nullptr: Eq 2.18
    DiscForce* force = nullptr;
    std::uint32_t begin = 0, end = 0;
    double spring_step_s = 0;
};

/// Adds the forces of the pairs [begin, end) in order. One for each instruction set; all give the same bits.
using PairKernel = void (*)(const ContactConstants&, const PairBatch&);

void add_pairs_sse2(const ContactConstants& k, const PairBatch& batch);
void add_pairs_avx2(const ContactConstants& k, const PairBatch& batch);
void add_pairs_avx512(const ContactConstants& k, const PairBatch& batch);

/// Rolling resistance between discs: Eq 2.18, or other codes' spring (DemConstants::rolling_springs).
enum class PairRolling { chord, spring };

/// What a pair's law needs of one disc.
template <class V>
struct PairSide {
    V x, y, vx, vy, omega, radius;
};

/// A pair's geometry and relative motion, discs i and j.
template <class V>
struct PairMotion {
    V nx, ny;  ///< unit normal from i to j
    V overlap, chord;
    V arm_i, arm_j;  ///< from the centres to the contact point
    V ux, uy;        ///< velocity of i relative to j
    V omega_i, omega_j;
    V reduced_radius;  ///< for rolling springs only
};

/// What a pair gives to its discs; the force is that on j, the opposite acts on i.
template <class V>
struct PairForces {
    V x, y, moment_i, moment_j, rolling, spring;
};

template <PairRolling R, class V>
IFEDEM_INLINE PairMotion<V> pair_motion(const PairSide<V>& i, const PairSide<V>& j) {
    const V dx = j.x - i.x, dy = j.y - i.y;
    const V distance = root(dx * dx + dy * dy);
    const V overlap = (i.radius + j.radius) - distance;
    const V inverse = 1.0 / distance;
    const V half_overlap = 0.5 * overlap;
    const V chord = inverse * root(max_of(chord_product(distance, overlap, i.radius, j.radius), V(0.0)));
    return {dx * inverse,
            dy * inverse,
            overlap,
            chord,
            i.radius - half_overlap,
            j.radius - half_overlap,
            i.vx - j.vx,
            i.vy - j.vy,
            i.omega,
            j.omega,
            R == PairRolling::spring ? i.radius * j.radius / (i.radius + j.radius) : V(0.0)};
}

/// Eq 2.17 between discs i and j.
template <class V>
IFEDEM_INLINE PairForces<V> pair_forces(const ContactConstants& k, const PairMotion<V>& p, V damping, V spring,
                                        V spring_step) {
    const V approach = p.ux * p.nx + p.uy * p.ny;
    const V sliding = (p.uy * p.nx - p.ux * p.ny) + (p.omega_i * p.arm_i + p.omega_j * p.arm_j);
    const auto f = contact_forces(k, p.overlap, approach, sliding, damping, spring, spring_step, p.chord);
    const V backward = V(0.0) - f.tangential_N;
    return {f.normal_N * p.nx + backward * p.ny,
            f.normal_N * p.ny - backward * p.nx,
            backward * p.arm_i,
            backward * p.arm_j,
            f.rolling_limit_Nm,
            f.tangential_spring_m};
}

/// Adds the moment of a rolling spring, whose memory it advances.
template <class V>
IFEDEM_INLINE void add_rolling_spring(const ContactConstants& k, const PairMotion<V>& p, V step_s, PairForces<V>& f,
                                      V& moment_Nm) {
    const V normal = f.x * p.nx + f.y * p.ny;
    const V cap = (k.rolling_cap * p.reduced_radius) * max_of(normal, V(0.0));
    const V stiffness = k.tangential_stiffness_N_m * (p.reduced_radius * p.reduced_radius);
    moment_Nm = max_of(V(0.0) - cap, min_of(cap, moment_Nm + stiffness * ((p.omega_i - p.omega_j) * step_s)));
    f.moment_i = f.moment_i - moment_Nm, f.moment_j = f.moment_j + moment_Nm, f.rolling = V(0.0);
}

/// One pair; also the tail of a block.
template <PairRolling R>
IFEDEM_INLINE void add_one_pair(const ContactConstants& k, const PairBatch& b, std::uint32_t n) {
    const Disc &di = b.disc[b.i[n]], &dj = b.disc[b.j[n]];
    const auto motion = pair_motion<R, double>({di.x_m, di.y_m, di.vx_m_s, di.vy_m_s, di.omega_rad_s, di.radius_m},
                                               {dj.x_m, dj.y_m, dj.vx_m_s, dj.vy_m_s, dj.omega_rad_s, dj.radius_m});
    auto f = pair_forces<double>(k, motion, b.damping_Ns_m[n], b.spring_m[n], b.spring_step_s);
    b.spring_m[n] = f.spring;
    if constexpr (R == PairRolling::spring) add_rolling_spring<double>(k, motion, b.spring_step_s, f, b.rolling_Nm[n]);
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

/// W lanes of the columns x, y, moment, rolling as the first W force records, in lane order.
template <int W>
IFEDEM_INLINE void to_records(const Pack<W> (&in)[4], Four (&out)[8]);

template <>
IFEDEM_INLINE void to_records<2>(const Pack<2> (&in)[4], Four (&out)[8]) {
    out[0] = Four{in[0].v[0], in[1].v[0], in[2].v[0], in[3].v[0]};
    out[1] = Four{in[0].v[1], in[1].v[1], in[2].v[1], in[3].v[1]};
}

template <>
IFEDEM_INLINE void to_records<4>(const Pack<4> (&in)[4], Four (&out)[8]) {
    const Four a = __builtin_shufflevector(in[0].v, in[1].v, 0, 4, 2, 6),
               b = __builtin_shufflevector(in[0].v, in[1].v, 1, 5, 3, 7);
    const Four c = __builtin_shufflevector(in[2].v, in[3].v, 0, 4, 2, 6),
               d = __builtin_shufflevector(in[2].v, in[3].v, 1, 5, 3, 7);
    out[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5), out[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    out[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7), out[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

template <>
IFEDEM_INLINE void to_records<8>(const Pack<8> (&in)[4], Four (&out)[8]) {
    using R = Pack<8>::Raw;
    const R xy[2] = {__builtin_shufflevector(in[0].v, in[1].v, 0, 8, 2, 10, 4, 12, 6, 14),
                     __builtin_shufflevector(in[0].v, in[1].v, 1, 9, 3, 11, 5, 13, 7, 15)};
    const R mr[2] = {__builtin_shufflevector(in[2].v, in[3].v, 0, 8, 2, 10, 4, 12, 6, 14),
                     __builtin_shufflevector(in[2].v, in[3].v, 1, 9, 3, 11, 5, 13, 7, 15)};
    for (int odd = 0; odd < 2; ++odd) {
        const R first = __builtin_shufflevector(xy[odd], mr[odd], 0, 1, 8, 9, 2, 3, 10, 11);
        const R second = __builtin_shufflevector(xy[odd], mr[odd], 4, 5, 12, 13, 6, 7, 14, 15);
        out[odd] = __builtin_shufflevector(first, first, 0, 1, 2, 3);
        out[odd + 2] = __builtin_shufflevector(first, first, 4, 5, 6, 7);
        out[odd + 4] = __builtin_shufflevector(second, second, 0, 1, 2, 3);
        out[odd + 6] = __builtin_shufflevector(second, second, 4, 5, 6, 7);
    }
}

IFEDEM_INLINE void add_record(DiscForce& to, const Four& f) {
    Four old;
    __builtin_memcpy(&old, &to.x_N, 32);
    old += f;
    __builtin_memcpy(&to.x_N, &old, 32);
}

/// Sums pair by pair, i before j: the order of the scalar loop, hence its bits.
template <int W>
IFEDEM_INLINE void scatter(const PairBatch& b, std::uint32_t n, const PairForces<Pack<W>>& f) {
    Four on_i[8], on_j[8];
    to_records<W>({Pack<W>(0.0) - f.x, Pack<W>(0.0) - f.y, f.moment_i, f.rolling}, on_i);
    to_records<W>({f.x, f.y, f.moment_j, f.rolling}, on_j);
    for (int lane = 0; lane < W; ++lane) {
        const std::uint32_t at = n + static_cast<std::uint32_t>(lane);
        add_record(b.force[b.slot_i[at]], on_i[lane]);
        add_record(b.force[b.slot_j[at]], on_j[lane]);
    }
}

/// W pairs from `n` on.
template <PairRolling R, int W>
IFEDEM_INLINE PairMotion<Pack<W>> gather(const PairBatch& b, std::uint32_t n) {
    return pair_motion<R, Pack<W>>(load_side<W>(b.disc, b.i + n), load_side<W>(b.disc, b.j + n));
}

/// Their law; the springs are stored.
template <PairRolling R, int W>
IFEDEM_INLINE PairForces<Pack<W>> compute(const ContactConstants& k, const PairBatch& b, std::uint32_t n,
                                          const PairMotion<Pack<W>>& motion) {
    auto f = pair_forces<Pack<W>>(k, motion, Pack<W>(b.damping_Ns_m + n), Pack<W>(b.spring_m + n), b.spring_step_s);
    f.spring.store(b.spring_m + n);
    if constexpr (R == PairRolling::spring) {
        Pack<W> moment(b.rolling_Nm + n);
        add_rolling_spring<Pack<W>>(k, motion, b.spring_step_s, f, moment);
        moment.store(b.rolling_Nm + n);
    }
    return f;
}

/// Software-pipelined in three stages, so that the roots and the division of one batch are under way while the law of
/// the batch before and the sums of the one before that are done; in program order a batch would wait for each of
/// them. Constants are copied so that no store can be thought to change them.
template <PairRolling R, int W>
IFEDEM_INLINE void add_pairs_as(const ContactConstants& constants, const PairBatch& batch) {
    const ContactConstants k = constants;
    const PairBatch b = batch;
    std::uint32_t n = b.begin;
    if (n + 2 * W <= b.end) {
        auto motion = gather<R, W>(b, n);
        auto forces = compute<R, W>(k, b, n, motion);
        motion = gather<R, W>(b, n + W);
        for (n += 2 * W; n + W <= b.end; n += W) {
            const auto next = gather<R, W>(b, n);
            const auto ready = forces;
            forces = compute<R, W>(k, b, n - W, motion);
            scatter<W>(b, n - 2 * W, ready);
            motion = next;
        }
        scatter<W>(b, n - 2 * W, forces);
        scatter<W>(b, n - W, compute<R, W>(k, b, n - W, motion));
    }
    for (; n < b.end; ++n) add_one_pair<R>(k, b, n);
}

template <int W>
IFEDEM_INLINE void add_pairs(const ContactConstants& k, const PairBatch& batch) {
    if (batch.rolling_Nm == nullptr)
        add_pairs_as<PairRolling::chord, W>(k, batch);
    else
        add_pairs_as<PairRolling::spring, W>(k, batch);
}

}  // namespace ifedem

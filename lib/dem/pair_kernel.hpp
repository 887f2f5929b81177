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
    const std::uint32_t *i = nullptr, *j = nullptr;
    const double* damping_Ns_m = nullptr;
    double* spring_m = nullptr;
    double* rolling_Nm = nullptr;  ///< nullptr: Eq 2.18
    DiscForce* force = nullptr;    ///< the block's, by list position
    std::uint32_t begin = 0, end = 0;
    double spring_step_s = 0;
};

/// Adds the forces of the pairs [begin, end) in order. One for each instruction set; all give the same bits.
using PairKernel = void (*)(const ContactConstants&, const PairBatch&);

void add_pairs_sse2(const ContactConstants& k, const PairBatch& batch);
void add_pairs_avx2(const ContactConstants& k, const PairBatch& batch);
void add_pairs_avx512(const ContactConstants& k, const PairBatch& batch);

/// Rolling resistance between discs: none, Eq 2.18, or other codes' spring (DemConstants::rolling_springs).
enum class PairRolling { none, chord, spring };

/// What a pair's law needs of its discs i and j.
template <class V>
struct PairSides {
    V x, y, vx, vy;  ///< of i less those of j
    V omega_i, radius_i, omega_j, radius_j;
};

/// The same with its first root, for which all else waits.
template <class V>
struct PairDistance {
    PairSides<V> sides;
    V distance2, distance;
};

/// A pair's geometry and relative motion.
template <class V>
struct PairMotion {
    V nx, ny;  ///< unit normal from i to j
    V overlap;
    V minus_inverse;  ///< −1 / distance
    V chord;          ///< chord × distance, ≥ 0; its square until root_of_chord(). For Eq 2.18 only
    V minus_lever;    ///< −distance / (r_i + r_j): the contact point divides the distance as the radii do
    V ux, uy;         ///< velocity of i relative to j
    V rim_speed;      ///< ω_i r_i + ω_j r_j
    // For rolling springs only.
    V omega, reduced_radius;  ///< ω_i − ω_j
};

/// What a pair remembers.
template <class V>
struct PairMemory {
    V spring;   ///< Δu_s of Eq 2.17
    V rolling;  ///< moment of a rolling spring
};

/// What a pair gives to its discs: the force on j, of which i gets the opposite, and what turns them.
template <class V>
struct PairForces {
    V x, y;
    V turning;  ///< moment over radius, the same for both
    V rolling;  ///< Eq 2.18's limit, the same for both; a rolling spring's moment on j, of which i gets the opposite
    PairMemory<V> memory;
};

/// The order of the statements means nothing but time: the compiler schedules the loop by it, and a harmless change may
/// cost half as much again (README.md, "Cost"). `make bench` before and after any.
template <class V>
IFEDEM_INLINE PairDistance<V> pair_distance(const PairSides<V>& p) {
    const V distance2 = p.x * p.x + p.y * p.y;
    return {p, distance2, root(distance2)};
}

template <PairRolling R, class V>
IFEDEM_INLINE PairMotion<V> pair_motion(const PairDistance<V>& d) {
    const PairSides<V>& p = d.sides;
    const V distance2 = d.distance2, distance = d.distance;
    PairMotion<V> m;
    m.rim_speed = p.omega_i * p.radius_i + p.omega_j * p.radius_j;
    m.ux = p.vx, m.uy = p.vy;
    const V radii = p.radius_i + p.radius_j;
    const V both = -1.0 / (distance * radii);  // one division for two quotients, negative since sides are i − j
    m.minus_inverse = both * radii;
    m.overlap = radii - distance;
    m.minus_lever = distance2 * both;
    m.nx = p.x * m.minus_inverse, m.ny = p.y * m.minus_inverse;
    if constexpr (R == PairRolling::chord)
        m.chord = max_of(chord_product(distance, distance2, m.overlap, p.radius_i, p.radius_j), V(0.0));
    if constexpr (R == PairRolling::spring) {
        m.omega = p.omega_i - p.omega_j;
        m.reduced_radius = (p.radius_i * p.radius_j) * (-both * distance);
    }
    return m;
}

/// The second root: 8 lanes want it in another stage of the loop than 4.
template <PairRolling R, class V>
IFEDEM_INLINE PairMotion<V> root_of_chord(PairMotion<V> m) {
    if constexpr (R == PairRolling::chord) m.chord = root(m.chord);
    return m;
}

/// The constants as pair_forces() wants them, for chords that are negative.
IFEDEM_INLINE ContactConstants turn_chords(ContactConstants k) {
    k.rolling_chords = -k.rolling_chords;
    return k;
}

/// Eq 2.17 between discs i and j.
template <PairRolling R, class V>
IFEDEM_INLINE PairForces<V> pair_forces(const ContactConstants& k, const PairMotion<V>& p, V damping,
                                        const PairMemory<V>& old, V step_s) {
    const V minus_chord = R == PairRolling::chord ? p.minus_inverse * p.chord : V(0.0);
    const V approach = p.ux * p.nx + p.uy * p.ny;
    const V sliding = (p.uy * p.nx - p.ux * p.ny) - p.minus_lever * p.rim_speed;
    const auto f = contact_forces(k, p.overlap, approach, sliding, damping, old.spring, step_s, minus_chord);
    PairForces<V> out{f.normal_N * p.nx - f.tangential_N * p.ny,
                      f.normal_N * p.ny + f.tangential_N * p.nx,
                      f.tangential_N * p.minus_lever,
                      R == PairRolling::chord ? f.rolling_limit_Nm : V(0.0),
                      {f.tangential_spring_m, V(0.0)}};
    if constexpr (R == PairRolling::spring) {
        const V cap = (k.rolling_cap * p.reduced_radius) * max_of(f.normal_N, V(0.0));
        const V growth_Nms = (k.tangential_stiffness_N_m * step_s) * (p.reduced_radius * p.reduced_radius);
        out.rolling = max_of(-cap, min_of(cap, old.rolling + growth_Nms * p.omega));
        out.memory.rolling = out.rolling;
    }
    return out;
}

/// One pair; also the tail of a block.
template <PairRolling R>
IFEDEM_INLINE void add_one_pair(const ContactConstants& k, const PairBatch& b, std::uint32_t n) {
    constexpr bool springs = R == PairRolling::spring;
    const Disc &i = b.disc[b.i[n]], &j = b.disc[b.j[n]];
    const PairSides<double> sides{i.x_m - j.x_m, i.y_m - j.y_m, i.vx_m_s - j.vx_m_s, i.vy_m_s - j.vy_m_s,
                                  i.omega_rad_s, i.radius_m,    j.omega_rad_s,       j.radius_m};
    const PairMemory<double> old{b.spring_m[n], springs ? b.rolling_Nm[n] : 0.0};
    const auto f = pair_forces<R, double>(k, root_of_chord<R>(pair_motion<R>(pair_distance(sides))), b.damping_Ns_m[n],
                                          old, b.spring_step_s);
    b.spring_m[n] = f.memory.spring;
    if constexpr (springs) b.rolling_Nm[n] = f.memory.rolling;
    DiscForce &on_i = b.force[b.i[n]], &on_j = b.force[b.j[n]];
    on_i.x_N -= f.x, on_i.y_N -= f.y, on_i.turning_N += f.turning;
    on_i.rolling_Nm += springs ? -f.rolling : f.rolling;
    on_j.x_N += f.x, on_j.y_N += f.y, on_j.turning_N += f.turning, on_j.rolling_Nm += f.rolling;
}

IFEDEM_INLINE Four join(Two a, Two b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3); }
IFEDEM_INLINE Eight join(Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); }

// Records become columns. Shuffles are what the loop has too many of, so halves of records are put side by side by
// loads, the differences of i and j are taken before they are transposed, and 512-bit permutations by an index vector
// are avoided for unpacking and exchange of 128-bit lanes.

template <int W>
IFEDEM_INLINE PairSides<Pack<W>> load_sides(const Disc* disc, const std::uint32_t* i, const std::uint32_t* j);

template <>
IFEDEM_INLINE PairSides<Pack<2>> load_sides<2>(const Disc* disc, const std::uint32_t* i, const std::uint32_t* j) {
    using P = Pack<2>;
    const Disc &ai = disc[i[0]], &aj = disc[j[0]], &bi = disc[i[1]], &bj = disc[j[1]];
    const Two a = load_as<Two>(&ai.x_m) - load_as<Two>(&aj.x_m), b = load_as<Two>(&bi.x_m) - load_as<Two>(&bj.x_m);
    const Two c = load_as<Two>(&ai.vx_m_s) - load_as<Two>(&aj.vx_m_s),
              d = load_as<Two>(&bi.vx_m_s) - load_as<Two>(&bj.vx_m_s);
    const Two ei = load_as<Two>(&ai.omega_rad_s), fi = load_as<Two>(&bi.omega_rad_s);
    const Two ej = load_as<Two>(&aj.omega_rad_s), fj = load_as<Two>(&bj.omega_rad_s);
    const auto low = [](Two p, Two q) { return P(P::FromRaw{}, __builtin_shufflevector(p, q, 0, 2)); };
    const auto high = [](Two p, Two q) { return P(P::FromRaw{}, __builtin_shufflevector(p, q, 1, 3)); };
    return {low(a, b), high(a, b), low(c, d), high(c, d), low(ei, fi), high(ei, fi), low(ej, fj), high(ej, fj)};
}

template <>
IFEDEM_INLINE PairSides<Pack<4>> load_sides<4>(const Disc* disc, const std::uint32_t* i, const std::uint32_t* j) {
    using P = Pack<4>;
    Four d[4], ei[2], ej[2];
    for (int n = 0; n < 4; ++n) d[n] = load_as<Four>(&disc[i[n]].x_m) - load_as<Four>(&disc[j[n]].x_m);
    for (int n = 0; n < 2; ++n) {
        ei[n] = join(load_as<Two>(&disc[i[n]].omega_rad_s), load_as<Two>(&disc[i[n + 2]].omega_rad_s));
        ej[n] = join(load_as<Two>(&disc[j[n]].omega_rad_s), load_as<Two>(&disc[j[n + 2]].omega_rad_s));
    }
    const auto low = [](Four p, Four q) { return __builtin_shufflevector(p, q, 0, 4, 2, 6); };
    const auto high = [](Four p, Four q) { return __builtin_shufflevector(p, q, 1, 5, 3, 7); };
    const Four x01 = low(d[0], d[1]), y01 = high(d[0], d[1]), x23 = low(d[2], d[3]), y23 = high(d[2], d[3]);
    return {{P::FromRaw{}, __builtin_shufflevector(x01, x23, 0, 1, 4, 5)},
            {P::FromRaw{}, __builtin_shufflevector(y01, y23, 0, 1, 4, 5)},
            {P::FromRaw{}, __builtin_shufflevector(x01, x23, 2, 3, 6, 7)},
            {P::FromRaw{}, __builtin_shufflevector(y01, y23, 2, 3, 6, 7)},
            {P::FromRaw{}, low(ei[0], ei[1])},
            {P::FromRaw{}, high(ei[0], ei[1])},
            {P::FromRaw{}, low(ej[0], ej[1])},
            {P::FromRaw{}, high(ej[0], ej[1])}};
}

template <>
IFEDEM_INLINE PairSides<Pack<8>> load_sides<8>(const Disc* disc, const std::uint32_t* i, const std::uint32_t* j) {
    using P = Pack<8>;
    constexpr int first[4] = {0, 1, 4, 5};  // with first + 2 beside it: lanes come out in order
    Eight d[4], ei[2], ej[2];
    for (int n = 0; n < 4; ++n) {
        const int a = first[n], b = a + 2;
        d[n] = join(load_as<Four>(&disc[i[a]].x_m), load_as<Four>(&disc[i[b]].x_m)) -
               join(load_as<Four>(&disc[j[a]].x_m), load_as<Four>(&disc[j[b]].x_m));
    }
    const auto ends = [&](const std::uint32_t* at) {
        return join(join(load_as<Two>(&disc[at[0]].omega_rad_s), load_as<Two>(&disc[at[2]].omega_rad_s)),
                    join(load_as<Two>(&disc[at[4]].omega_rad_s), load_as<Two>(&disc[at[6]].omega_rad_s)));
    };
    for (int n = 0; n < 2; ++n) ei[n] = ends(i + n), ej[n] = ends(j + n);
    const auto low = [](Eight p, Eight q) { return __builtin_shufflevector(p, q, 0, 8, 2, 10, 4, 12, 6, 14); };
    const auto high = [](Eight p, Eight q) { return __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15); };
    // x of pairs 0 1, vx of 0 1, x of 2 3, vx of 2 3; and so on
    const Eight x03 = low(d[0], d[1]), y03 = high(d[0], d[1]), x47 = low(d[2], d[3]), y47 = high(d[2], d[3]);
    return {{P::FromRaw{}, __builtin_shufflevector(x03, x47, 0, 1, 4, 5, 8, 9, 12, 13)},
            {P::FromRaw{}, __builtin_shufflevector(y03, y47, 0, 1, 4, 5, 8, 9, 12, 13)},
            {P::FromRaw{}, __builtin_shufflevector(x03, x47, 2, 3, 6, 7, 10, 11, 14, 15)},
            {P::FromRaw{}, __builtin_shufflevector(y03, y47, 2, 3, 6, 7, 10, 11, 14, 15)},
            {P::FromRaw{}, low(ei[0], ei[1])},
            {P::FromRaw{}, high(ei[0], ei[1])},
            {P::FromRaw{}, low(ej[0], ej[1])},
            {P::FromRaw{}, high(ej[0], ej[1])}};
}

/// Columns of force records.
template <class V>
struct ForceColumns {
    V x, y, turning, rolling;
};

IFEDEM_INLINE void to_records(const ForceColumns<Two>& f, Four* out) {
    out[0] = Four{f.x[0], f.turning[0], f.y[0], f.rolling[0]};
    out[1] = Four{f.x[1], f.turning[1], f.y[1], f.rolling[1]};
}
IFEDEM_INLINE void to_records(const ForceColumns<Four>& f, Four* out) {
    const FourRows records = transpose({f.x, f.turning, f.y, f.rolling});
    out[0] = records.a, out[1] = records.b, out[2] = records.c, out[3] = records.d;
}
IFEDEM_INLINE void to_records(const ForceColumns<Eight>& f, Four* out) {
    const auto low = [](const Eight& a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3); };
    const auto high = [](const Eight& a) { return __builtin_shufflevector(a, a, 4, 5, 6, 7); };
    to_records(ForceColumns<Four>{low(f.x), low(f.y), low(f.turning), low(f.rolling)}, out);
    to_records(ForceColumns<Four>{high(f.x), high(f.y), high(f.turning), high(f.rolling)}, out + 4);
}

IFEDEM_INLINE void add_to_j(DiscForce& to, const Four& f) {
    const Four sum = load_as<Four>(&to.x_N) + f;
    __builtin_memcpy(&to.x_N, &sum, sizeof sum);
}
/// The force is the opposite one, what turns is the same (of a rolling spring's moment: the opposite too). The sums of
/// a disc's pairs wait for each other: one instruction where vectors can add and subtract in turn, else one after signs
/// that are ready before.
template <PairRolling R>
IFEDEM_INLINE void add_to_i(DiscForce& to, const Four& f) {
    const Four old = load_as<Four>(&to.x_N), less = old - f, more = old + f;
    const Four sum = R == PairRolling::spring ? old + __builtin_shufflevector(-f, f, 0, 5, 2, 3)
                                              : __builtin_shufflevector(less, more, 0, 5, 2, 7);
    __builtin_memcpy(&to.x_N, &sum, sizeof sum);
}

/// Sums pair by pair, i before j: the order of the scalar loop, hence its bits.
template <PairRolling R, int W>
IFEDEM_INLINE void scatter(const PairBatch& b, std::uint32_t n, const PairForces<Pack<W>>& f) {
    Four record[8];  // W of them
    to_records(ForceColumns<typename Pack<W>::Raw>{f.x.v, f.y.v, f.turning.v, f.rolling.v}, record);
    for (int lane = 0; lane < W; ++lane) {
        const std::uint32_t at = n + static_cast<std::uint32_t>(lane);
        add_to_i<R>(b.force[b.i[at]], record[lane]);
        add_to_j(b.force[b.j[at]], record[lane]);
    }
}

/// W pairs from `n` on.
template <int W>
IFEDEM_INLINE PairDistance<Pack<W>> gather(const PairBatch& b, std::uint32_t n) {
    return pair_distance(load_sides<W>(b.disc, b.i + n, b.j + n));
}

/// Their law; what they remember is stored.
template <PairRolling R, int W>
IFEDEM_INLINE PairForces<Pack<W>> compute(const ContactConstants& k, const PairBatch& b, std::uint32_t n,
                                          const PairMotion<Pack<W>>& motion) {
    using P = Pack<W>;
    const PairMemory<P> old{P(b.spring_m + n), R == PairRolling::spring ? P(b.rolling_Nm + n) : P(0.0)};
    const auto f = pair_forces<R, P>(k, motion, P(b.damping_Ns_m + n), old, b.spring_step_s);
    f.memory.spring.store(b.spring_m + n);
    if constexpr (R == PairRolling::spring) f.memory.rolling.store(b.rolling_Nm + n);
    return f;
}

// The packs of a block are software-pipelined, so that the roots and the division of one are under way while the law of
// the one before and the sums of the one before that are done; in program order a pack would wait for each of them.
// Four stages for 4 lanes: the processors that have no more hold 250 instructions at a time, in which three stages
// leave their longest chain no time. With 8 lanes four stages were slower, in another order of them (README.md,
// "Cost").

/// Gives the first pair that is left.
template <PairRolling R, int W>
IFEDEM_INLINE std::uint32_t add_in_three_stages(const ContactConstants& k, const PairBatch& b) {
    std::uint32_t n = b.begin;
    if (n + 2 * W > b.end) return n;
    auto motion = pair_motion<R>(gather<W>(b, n));
    auto forces = compute<R, W>(k, b, n, root_of_chord<R>(motion));
    motion = pair_motion<R>(gather<W>(b, n + W));
    for (n += 2 * W; n + W <= b.end; n += W) {
        const auto next = pair_motion<R>(gather<W>(b, n));
        const auto ready = forces;
        forces = compute<R, W>(k, b, n - W, root_of_chord<R>(motion));
        scatter<R, W>(b, n - 2 * W, ready);
        motion = next;
    }
    scatter<R, W>(b, n - 2 * W, forces);
    scatter<R, W>(b, n - W, compute<R, W>(k, b, n - W, root_of_chord<R>(motion)));
    return n;
}

template <PairRolling R, int W>
IFEDEM_INLINE std::uint32_t add_in_four_stages(const ContactConstants& k, const PairBatch& b) {
    std::uint32_t n = b.begin;
    if (n + 3 * W > b.end) return n;
    auto forces = compute<R, W>(k, b, n, root_of_chord<R>(pair_motion<R>(gather<W>(b, n))));
    auto motion = root_of_chord<R>(pair_motion<R>(gather<W>(b, n + W)));
    auto distance = gather<W>(b, n + 2 * W);
    for (n += 3 * W; n + W <= b.end; n += W) {
        scatter<R, W>(b, n - 3 * W, forces);
        forces = compute<R, W>(k, b, n - 2 * W, motion);
        motion = root_of_chord<R>(pair_motion<R>(distance));
        distance = gather<W>(b, n);
    }
    scatter<R, W>(b, n - 3 * W, forces);
    scatter<R, W>(b, n - 2 * W, compute<R, W>(k, b, n - 2 * W, motion));
    scatter<R, W>(b, n - W, compute<R, W>(k, b, n - W, root_of_chord<R>(pair_motion<R>(distance))));
    return n;
}

/// Constants are copied so that no store can be thought to change them.
template <PairRolling R, int W>
IFEDEM_INLINE void add_pairs_as(const ContactConstants& constants, const PairBatch& batch) {
    const ContactConstants k = turn_chords(constants);
    const PairBatch b = batch;
    std::uint32_t n = b.begin;
    if constexpr (W == 4)
        n = add_in_four_stages<R, W>(k, b);
    else if constexpr (W > 1)
        n = add_in_three_stages<R, W>(k, b);
    for (; n < b.end; ++n) add_one_pair<R>(k, b, n);
}

/// W pairs at a time; with W = 1 one by one: the fallback, and what the others must equal.
template <int W>
IFEDEM_INLINE void add_pairs(const ContactConstants& k, const PairBatch& batch) {
    if (k.rolling_chords != 0.0 && batch.rolling_Nm == nullptr)
        add_pairs_as<PairRolling::chord, W>(k, batch);
    else if (batch.rolling_Nm == nullptr)
        add_pairs_as<PairRolling::none, W>(k, batch);
    else
        add_pairs_as<PairRolling::spring, W>(k, batch);
}

}  // namespace ifedem

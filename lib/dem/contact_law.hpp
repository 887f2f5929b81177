#pragma once
#include "core/force_inline.hpp"

namespace ifedem {

// The one contact law of the project (section 2.5), written once over a number type V: double for walls, wheel segments
// and tests, a SIMD pack for disc–disc pairs. Only + − × ÷ √ min max and selection, so every width gives the same bits.

IFEDEM_INLINE double min_of(double a, double b) { return a < b ? a : b; }
IFEDEM_INLINE double max_of(double a, double b) { return a > b ? a : b; }
IFEDEM_INLINE double root(double a) { return __builtin_sqrt(a); }
IFEDEM_INLINE double select_positive(double condition, double a) { return condition > 0 ? a : 0.0; }

/// Constants of a kind of contact (soil–soil, soil–wall, soil–wheel), the same for all its contacts.
struct ContactConstants {
    double normal_stiffness_N_m = 0;
    double tangential_stiffness_N_m = 0;
    double inverse_tangential_stiffness_m_N = 0;
    double friction = 0;
    double damping_ratio_of_ratios = 0;  ///< C_s / C_n = √(K_s / K_n) at one ζ for both directions
    double rolling_chords = 0;  ///< rolling moment / (chord × spring force): α for the full chord, α/2 for the half
    double rolling_cap = 0;     ///< of DemConstants::rolling_springs
    double smallest_normal_N = 0;  ///< 0: no attraction; −∞: the dashpot may pull until the overlap ends
};

template <class V>
struct ContactForces {
    V normal_N;             ///< > 0 pushes the bodies apart
    V tangential_N;         ///< opposes `sliding`
    V tangential_spring_m;  ///< Δu_s to be kept
    V rolling_limit_Nm;     ///< largest rolling moment, Eq 2.18; always against the disc's own ω
};

/// Eqs 2.17 and 2.18; out of contact (overlap ≤ 0, chord 0) everything, the spring included, is 0.
/// The spring is held within the Coulomb cap, so that a sliding contact releases its excess at once (the alternative,
/// an unbounded spring under a capped force, would keep pulling after the sliding has reversed).
template <class V>
IFEDEM_INLINE ContactForces<V> contact_forces(const ContactConstants& k, V overlap_m, V approach_m_s, V sliding_m_s,
                                              V normal_damping_Ns_m, V old_spring_m, V step_s, V chord_m) {
    const V elastic = k.normal_stiffness_N_m * overlap_m;
    const V pushing = max_of(elastic + normal_damping_Ns_m * approach_m_s, V(k.smallest_normal_N));
    const V normal = select_positive(overlap_m, pushing);
    const V cap = k.friction * max_of(normal, V(0.0));
    const V spring_cap = cap * k.inverse_tangential_stiffness_m_N;
    const V spring = max_of(-spring_cap, min_of(spring_cap, old_spring_m + sliding_m_s * step_s));
    const V trial =
        k.tangential_stiffness_N_m * spring + (k.damping_ratio_of_ratios * normal_damping_Ns_m) * sliding_m_s;
    const V tangential = max_of(-cap, min_of(cap, trial));
    return {normal, tangential, spring, (k.rolling_chords * chord_m) * elastic};
}

/// Chord of two circles whose centres stand at `distance`, times that distance, squared; ≤ 0 if they do not cross.
template <class V>
IFEDEM_INLINE V chord_product(V distance_m, V distance2_m2, V overlap_m, V radius_i_m, V radius_j_m) {
    const V difference = radius_i_m - radius_j_m;
    return (overlap_m * ((radius_i_m + radius_j_m) + distance_m)) * (distance2_m2 - difference * difference);
}

}  // namespace ifedem

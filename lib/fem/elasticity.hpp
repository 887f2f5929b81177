#pragma once
#include "fem/elements.hpp"

namespace ifedem {

/// The three different entries of D in σ = D ε (Eq 2.5) for an isotropic material; γ is the engineering shear strain.
struct Elasticity {
    double direct_Pa = 0;  ///< D11 = D22
    double cross_Pa = 0;   ///< D12
    double shear_Pa = 0;   ///< D33
};

[[nodiscard]] inline Elasticity find_elasticity(const Material& m, PlaneState plane) {
    const double shear = m.young_Pa / (2 * (1 + m.poisson));
    if (plane == PlaneState::stress) {
        const double direct = m.young_Pa / (1 - m.poisson * m.poisson);
        return {direct, m.poisson * direct, shear};
    }
    const double scale = m.young_Pa / ((1 + m.poisson) * (1 - 2 * m.poisson));
    return {(1 - m.poisson) * scale, m.poisson * scale, shear};
}

}  // namespace ifedem

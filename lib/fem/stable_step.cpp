#include <Eigen/Eigenvalues>
#include <limits>

#include "fem/elements.hpp"

namespace ifedem {
namespace {

/// 2/ω_max of one free element with a quarter of its mass at each node.
double find_element_step_s(const Element& e, double mass_kg) {
    const Eigen::Map<const Eigen::Matrix<double, 8, 8>> stiffness(e.stiffness_N_m.data());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 8, 8>> solver(stiffness, Eigen::EigenvaluesOnly);
    return 2 / std::sqrt(solver.eigenvalues()(7) / (0.25 * mass_kg));
}

template <class Wanted>
StableStep find_smallest(const ElementSet& set, Wanted wanted) {
    StableStep smallest{std::numeric_limits<double>::infinity(), 0};
    for (std::uint32_t k = 0; k < set.element.size(); ++k) {
        if (!wanted(k)) continue;
        const double step = find_element_step_s(set.element[k], set.element_mass_kg[k]);
        if (step < smallest.step_s) smallest = {step, k};
    }
    return smallest;
}

}  // namespace

StableStep stable_step(const ElementSet& set) {
    return find_smallest(set, [](std::uint32_t) { return true; });
}

StableStep stable_step(const ElementSet& set, const Mesh& mesh, Part part) {
    return find_smallest(set, [&](std::uint32_t k) { return mesh.part[k] == part; });
}

}  // namespace ifedem

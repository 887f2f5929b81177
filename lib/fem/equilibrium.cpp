#include "fem/equilibrium.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/corotation.hpp"

namespace ifedem {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// Internal force and load, without reactions.
std::vector<Vec2> find_residual(const ElementSet& set, const Supports& supports, const std::vector<Vec2>& position_m) {
    std::vector<Vec2> residual = supports.load_N;
    add_internal_force(set, position_m, residual);
    return residual;
}

std::array<double, 64> find_tangent(const Element& e, std::array<Vec2, 4> p) {
    const double step = 1e-6 * norm(p[2] - p[0]);
    std::array<double, 64> tangent{};
    for (std::size_t j = 0; j < 8; ++j) {
        double& coordinate = j % 2 == 0 ? p[j / 2].x : p[j / 2].y;
        const double kept = coordinate;
        coordinate = kept + step;
        const std::array<Vec2, 4> ahead = internal_force(e, p);
        coordinate = kept - step;
        const std::array<Vec2, 4> behind = internal_force(e, p);
        coordinate = kept;
        for (std::size_t a = 0; a < 4; ++a) {
            const Vec2 slope = (-0.5 / step) * (ahead[a] - behind[a]);
            tangent[16 * a + j] = slope.x;
            tangent[16 * a + 8 + j] = slope.y;
        }
    }
    return tangent;
}

/// Coordinates whose next move is known: held ones (0), and touching nodes (up or down to the plane).
struct Prescribed {
    std::vector<std::uint8_t> is;
    Vector move_m;
};

Prescribed prescribe(const Supports& supports, const RigidPlane& plane, const StaticState& state) {
    Prescribed p{supports.held, Vector::Zero(static_cast<Eigen::Index>(supports.held.size()))};
    for (std::size_t n = 0; n < state.touching.size(); ++n) {
        if (state.touching[n] == 0) continue;
        p.is[2 * n + 1] = 1;
        p.move_m[static_cast<Eigen::Index>(2 * n + 1)] = plane.height_m - state.position_m[n].y;
        if (plane.friction == PlaneFriction::stick) p.is[2 * n] = 1;
    }
    return p;
}

/// The tangent with prescribed rows and columns replaced by the identity and moved to the right-hand side.
Sparse assemble(const ElementSet& set, const StaticState& state, const Prescribed& prescribed, Vector& right) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(64 * set.element.size() + prescribed.is.size());
    for (const Element& e : set.element) {
        const std::array<double, 64> k = find_tangent(e, corners(e, state.position_m));
        for (std::size_t i = 0; i < 8; ++i) {
            const auto row = 2 * e.node[i / 2] + static_cast<std::uint32_t>(i % 2);
            if (prescribed.is[row] != 0) continue;
            for (std::size_t j = 0; j < 8; ++j) {
                const auto column = 2 * e.node[j / 2] + static_cast<std::uint32_t>(j % 2);
                const double value = 0.5 * (k[8 * i + j] + k[8 * j + i]);
                if (prescribed.is[column] != 0) {
                    right[row] -= value * prescribed.move_m[column];
                } else {
                    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
                }
            }
        }
    }
    for (std::size_t k = 0; k < prescribed.is.size(); ++k) {
        if (prescribed.is[k] == 0) continue;
        entries.emplace_back(static_cast<int>(k), static_cast<int>(k), 1.0);
        right[static_cast<Eigen::Index>(k)] = prescribed.move_m[static_cast<Eigen::Index>(k)];
    }
    const auto size = static_cast<Eigen::Index>(prescribed.is.size());
    Sparse matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Lets nodes join and leave the plane; true if any did.
bool update_touching(const Supports& supports, const RigidPlane& plane, const std::vector<Vec2>& residual,
                     StaticState& state) {
    bool changed = false;
    for (std::size_t n = 0; n < state.touching.size(); ++n) {
        if (supports.held[2 * n + 1] != 0) continue;
        const bool pulled = residual[n].y > 0;  // the plane's push would be −residual
        const bool touches = state.touching[n] != 0 ? !pulled : state.position_m[n].y < plane.height_m;
        changed = changed || touches != (state.touching[n] != 0);
        state.touching[n] = touches ? 1 : 0;
    }
    return changed;
}

/// Moves the nodes, by less than asked if an element would turn inside out. Returns the largest move asked for.
double move_nodes(const ElementSet& set, const Vector& move_m, StaticState& state) {
    const std::vector<Vec2> old = state.position_m;
    double share = 1;
    for (int attempt = 0; attempt < 12; ++attempt, share *= 0.5) {
        for (std::size_t n = 0; n < old.size(); ++n) {
            const auto k = static_cast<Eigen::Index>(2 * n);
            state.position_m[n] = old[n] + share * Vec2{move_m[k], move_m[k + 1]};
        }
        if (!find_inverted(set, state.position_m)) break;
    }
    return move_m.cwiseAbs().maxCoeff();
}

double extent_m(const std::vector<Vec2>& position_m) {
    double extent = 0;
    for (const Vec2 p : position_m) extent = std::max(extent, norm(p - position_m[0]));
    return extent;
}

}  // namespace

Convergence find_equilibrium(const ElementSet& set, const Supports& supports, const RigidPlane& plane,
                             StaticState& state) {
    constexpr int most_iterations = 50;
    constexpr double small_move = 1e-9;  // share of the extent; the next Newton move would be near its square
    const StaticState begin = state;
    state.touching.resize(state.position_m.size(), 0);
    const double enough_m = small_move * extent_m(state.position_m);
    double last_move_m = std::numeric_limits<double>::infinity();
    Eigen::SimplicialLDLT<Sparse> solver;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        const std::vector<Vec2> residual = find_residual(set, supports, state.position_m);
        const bool changed = update_touching(supports, plane, residual, state);
        if (!changed && last_move_m < enough_m) return Convergence::reached;
        const Prescribed prescribed = prescribe(supports, plane, state);
        Vector right(static_cast<Eigen::Index>(2 * residual.size()));
        for (std::size_t n = 0; n < residual.size(); ++n) {
            right[static_cast<Eigen::Index>(2 * n)] = residual[n].x;
            right[static_cast<Eigen::Index>(2 * n + 1)] = residual[n].y;
        }
        const Sparse tangent = assemble(set, state, prescribed, right);
        solver.compute(tangent);
        if (solver.info() != Eigen::Success) break;
        last_move_m = move_nodes(set, solver.solve(right), state);
        if (!std::isfinite(last_move_m)) break;
    }
    state = begin;
    return Convergence::failed;
}

Convergence find_equilibrium(const ElementSet& set, const Supports& supports, StaticState& state) {
    return find_equilibrium(set, supports, {-std::numeric_limits<double>::infinity(), PlaneFriction::none}, state);
}

double plane_load_N(const ElementSet& set, const Supports& supports, const StaticState& state) {
    const std::vector<Vec2> residual = find_residual(set, supports, state.position_m);
    double load = 0;
    for (std::size_t n = 0; n < state.touching.size(); ++n) {
        if (state.touching[n] != 0) load -= residual[n].y;
    }
    return load;
}

}  // namespace ifedem

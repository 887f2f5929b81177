#pragma once
#include "step/scene.hpp"

namespace ifedem {

/// Where the energy of the scene is now, J.
struct EnergyStore {
    double kinetic_discs_J = 0;
    double kinetic_wheel_J = 0;
    double kinetic_soil_J = 0;  ///< of the soil's elements
    double springs_J = 0;       ///< normal and tangential springs of all contacts
    double strain_J = 0;        ///< the elements of wheel and soil
    double height_discs_J = 0;  ///< gravity, against y = 0
    double height_soil_J = 0;   ///< the soil's elements
    double height_load_J = 0;   ///< W times the hub's height
    [[nodiscard]] double sum_J() const {
        return kinetic_discs_J + kinetic_wheel_J + kinetic_soil_J + springs_J + strain_J + height_discs_J +
               height_soil_J + height_load_J;
    }
};
[[nodiscard]] EnergyStore measure_energy(const Scene& scene, const State& state, const Workspace& work);

/// How fast energy entered and was lost in one step, W.
struct EnergyFlow {
    double torque_W = 0;           ///< T ω
    double drawbar_W = 0;          ///< P V, negative while the wheel pulls
    double lost_normal_W = 0;      ///< dashpots, and springs cut off where the contact ends before its overlap
    double lost_tangential_W = 0;  ///< sliding and tangential dashpots
    double lost_rolling_W = 0;
    double lost_wheel_W = 0;  ///< damping of the elements of wheel and soil
};

/// Makes one step and measures it. Every force is taken with the mean of the velocities before and after the step,
/// which is the path that the central difference gives it: the sum of work and losses then closes to the order of the
/// step's own energy error. (With the lagged velocities the losses in collisions come out too large by some dt/√(m/k).)
/// Symplectic integrator only; the state afterwards is that of step().
[[nodiscard]] EnergyFlow step_and_measure(const Scene& scene, State& state, Workspace& work);

/// flow × interval added to the ledger.
void add_to_ledger(EnergyLedger& ledger, const EnergyFlow& flow, double interval_s);

}  // namespace ifedem

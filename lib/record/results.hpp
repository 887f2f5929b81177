#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "fem/mesh.hpp"
#include "model/case.hpp"
#include "model/state.hpp"
#include "record/frame.hpp"

namespace ifedem {

/// One line of series.csv, in the order of its columns; signs as "Signs and units" in lib/README.md says.
struct SeriesRow {
    double time_s = 0;  ///< from the beginning of the stage
    Stage stage = Stage::consolidation;
    double wheel_x_m = 0;
    double sinkage_m = 0;
    double slip = 0;
    double effective_radius_m = 0;
    double vertical_force_N = 0;
    double gross_tractive_effort_N = 0;
    double drawbar_pull_N = 0;
    double net_traction_N = 0;
    double motion_resistance_N = 0;
    double torque_Nm = 0;
    // For checks: direct sums, what was commanded, and the energy account since the stage began.
    double fx_positive_N = 0, fx_negative_N = 0;                           ///< Eqs 2.13, 2.14 on the boundary nodes
    double hub_speed_m_s = 0, omega_rad_s = 0, commanded_omega_rad_s = 0;  ///< ω clockwise
    EnergyLedger ledger;
    double vertical_momentum_Ns = 0;  ///< of the wheel, now
    double stored_J = 0;              ///< kinetic, elastic and potential energy of the whole scene now
};

/// Calls f(column, value) for the numbers of a line, in order; `stage` follows the first.
template <class F>
void for_each_series_column(const SeriesRow& row, F&& f) {
    f("time_s", row.time_s);
    f("wheel_x_m", row.wheel_x_m);
    f("sinkage_m", row.sinkage_m);
    f("slip", row.slip);
    f("effective_radius_m", row.effective_radius_m);
    f("vertical_force_N", row.vertical_force_N);
    f("gross_tractive_effort_N", row.gross_tractive_effort_N);
    f("drawbar_pull_N", row.drawbar_pull_N);
    f("net_traction_N", row.net_traction_N);
    f("motion_resistance_N", row.motion_resistance_N);
    f("torque_Nm", row.torque_Nm);
    f("fx_positive_N", row.fx_positive_N);
    f("fx_negative_N", row.fx_negative_N);
    f("hub_speed_m_s", row.hub_speed_m_s);
    f("omega_rad_s", row.omega_rad_s);
    f("commanded_omega_rad_s", row.commanded_omega_rad_s);
    f("vertical_momentum_Ns", row.vertical_momentum_Ns);
    f("work_torque_J", row.ledger.work_torque_J);
    f("work_drawbar_J", row.ledger.work_drawbar_J);
    f("lost_normal_J", row.ledger.lost_normal_J);
    f("lost_tangential_J", row.ledger.lost_tangential_J);
    f("lost_rolling_J", row.ledger.lost_rolling_J);
    f("lost_wheel_J", row.ledger.lost_wheel_J);
    f("stored_J", row.stored_J);
}

/// The run directory: case.toml, results.h5, discs.xdmf, wheel.xdmf, series.csv. Everything written can be read at any
/// time; a killed run loses at most the line and the frame being written, and its files stay whole.
class Recorder {
public:
    /// Starts a directory (files of an earlier run in it are replaced; whoever calls asks before) or, given the
    /// progress of the checkpoint, goes on in it: lines and frames later than `resume_at` are dropped, so that a run
    /// that was interrupted ends with the files of one that was not. Throws Error(io).
    Recorder(std::string directory, const Case& c, const WheelMesh& mesh, std::optional<Progress> resume_at = {});
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Throws Error(io); what was written before stays.
    void add_series(const SeriesRow& row);
    void add_frame(const Frame& frame);
    /// Flushes everything to disk; called before each checkpoint, so that no checkpoint is ahead of the files. What
    /// belongs to the checkpoint's step is recorded before the checkpoint.
    void flush();
    /// Takes the spare room out of results.h5 and seals it at the end of a run; more can be added afterwards.
    void finish();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ifedem

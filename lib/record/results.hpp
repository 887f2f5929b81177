#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fem/mesh.hpp"
#include "model/case.hpp"
#include "model/state.hpp"

namespace ifedem {

/// One line of series.csv, in the contract's order and signs.
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
};

/// What a frame shows besides the state.
struct FrameFields {
    std::vector<float> disc_speed_m_s;     ///< list order, as State::discs
    std::vector<float> disc_pressure_Pa;   ///< mean contact stress of each disc (Eq 5.10), compression > 0
};

/// The run directory: case.toml, results.h5, discs.xdmf, wheel.xdmf, series.csv. Everything written can be read at any
/// time; a killed run loses at most the frame being written. A resumed run truncates what lies after its checkpoint.
class Recorder {
public:
    /// Opens a new directory (or an existing one to resume at `resume_total_steps` > 0). Throws Error(io).
    Recorder(std::string directory, const Case& c, const WheelMesh& mesh, std::uint64_t resume_total_steps);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void add_series(std::uint64_t total_steps, const SeriesRow& row);
    void add_frame(const State& state, double time_s, const FrameFields& fields);
    /// Flushes everything to disk; called before each checkpoint, so that files and checkpoint agree.
    void flush();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Writes text to a temporary file in the same directory, syncs and renames it. Throws Error(io).
void write_file_atomically(const std::string& path, const std::string& text);

}  // namespace ifedem

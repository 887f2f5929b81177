#pragma once
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "check/csv.hpp"
#include "core/bitmath.hpp"
#include "core/random.hpp"
#include "model/case.hpp"

namespace ifedem::test {

/// A run whose window means are known: each quantity is its mean plus a sine that whole lug-pair pitches average out.
struct SyntheticRun {
    std::string name;
    double gravity_m_s2 = 9.81;
    double load_N = 170;
    double slip_percent = 60;
    std::int64_t seed = 1;
    double lug_phase_deg = 0;
    double effort_N = 102;
    double net_traction_N = 43;
    double sinkage_m = -0.0575;
    double effective_radius_m = 0.143;
    double ripple = 0.3;  ///< amplitude of torque and net traction, as a share
    double distance_m = 0.8;
    double intermediate_young_Pa = 0.05e6;
};

inline Case synthetic_case(const SyntheticRun& r) {
    Case c;
    c.name = r.name;
    c.gravity_m_s2 = r.gravity_m_s2;
    c.wheel.load_N = r.load_N;
    c.wheel.lug_phase_deg = r.lug_phase_deg;
    c.wheel.intermediate.young_Pa = r.intermediate_young_Pa;
    c.travel.slip_percent = r.slip_percent;
    c.bed.seed = r.seed;
    return c;
}

inline std::string write_synthetic_run(const std::filesystem::path& parent, const SyntheticRun& r) {
    const auto directory = parent / r.name;
    std::filesystem::create_directories(directory);
    const Case c = synthetic_case(r);
    write_text((directory / "case.toml").string(), to_toml(c));
    const double pitch = 2 * pi * c.wheel.tread_radius_m / 12 * (1 - r.slip_percent / 100);
    std::string series =
        "time_s,stage,wheel_x_m,sinkage_m,slip,effective_radius_m,vertical_force_N,gross_tractive_effort_N,drawbar_"
        "pull_N,"
        "net_traction_N,motion_resistance_N,torque_Nm,fx_positive_N,fx_negative_N,commanded_omega_rad_s,hub_speed_m_s,"
        "vertical_momentum_Ns,work_torque_J,lost_normal_J,lost_tangential_J,stored_J\n";
    const std::string zeros = ",0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n";  // from vertical_force_N on
    series += "0,consolidation,0.3,0,0,0.15" + zeros + "1,sinkage,0.3,0,0,0.15" + zeros;
    const double omega = 0.1 / (c.wheel.tread_radius_m * (1 - r.slip_percent / 100));
    const auto steps = static_cast<int>(std::lround(r.distance_m / 2e-4));
    for (int k = 0; k <= steps; ++k) {
        const double x = 2e-4 * k;
        const double wave = 1 + r.ripple * std::sin(2 * pi * x / pitch);
        const double start = 1 - std::exp(-x / 0.03);  // gone before the window begins
        const double torque = r.effort_N * r.effective_radius_m * wave * start;
        const double pull = (x < 0.3 ? start : 1) * r.net_traction_N * wave;
        const double sinkage = r.sinkage_m * (x < 0.3 ? start : 1);
        const double effort = torque / r.effective_radius_m;
        series += fmt::format(
            "{:.4f},travel,{:.6f},{:.9g},{:.6g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},"
            "0.1,0,{:.9g},{:.9g},{:.9g},{:.9g}\n",
            x / 0.1, 0.3 + x, sinkage, r.slip_percent / 100, r.effective_radius_m, r.load_N, effort, -pull, pull,
            pull - effort, torque, 0.9 * effort, pull - 0.9 * effort, omega, 10 * x, 2 * x, 7 * x, 44 + 0.9 * x);
    }
    write_text((directory / "series.csv").string(), series);
    write_text(
        (directory / "run.csv").string(),
        fmt::format(
            "name,value,unit\nstate_hash,{:016x},\nsteps,200000,\nparticles,19468,\ncpu_s,812.4,s\nwall_s,406.2,s\n"
            "ns_per_particle_step,14.2,ns\nthreads,2,\ncompiler,clang 14.0.6,\nversion,0.1.0,\nresults_version,1,\n"
            "porosity,0.151,\nv_rms_m_s,0.0031,m/s\n",
            static_cast<std::uint64_t>(r.seed) * 0x9e3779b97f4a7c15ULL));
    return directory.string();
}

/// A fresh directory for one test, below the system's place for temporary files. The process number keeps two builds
/// that test at the same time apart.
inline std::filesystem::path fresh_directory(const std::string& name) {
    const auto path = std::filesystem::temp_directory_path() / fmt::format("ifedem-{}-{}", name, getpid());
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

}  // namespace ifedem::test

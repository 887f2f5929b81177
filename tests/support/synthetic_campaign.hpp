#pragma once
#include <functional>
#include <string>

#include "check/campaign.hpp"
#include "core/random.hpp"

namespace ifedem::test {

/// Changes what one run measured.
using Distortion = std::function<void(const Condition&, RunMetrics&)>;

/// A campaign of chapter 3 in memory, made so that every statement of the text about curves holds: both wheels, five
/// loads on Earth, Mars, eight slips, three realisations at 60 %. Single runs scatter by about a thousandth of the
/// load, and by 0.02 cm in sinkage.
inline RunMetrics follow_the_text(const Condition& c) {
    const bool is_soft = c.wheel == "B3";
    const double i = c.slip_percent;
    const double w = c.load_N;
    RunMetrics m{};
    m.gross_tractive_effort_N = is_soft ? w * (0.05 + 0.008 * i) : w * 0.0088 * i;
    m.motion_resistance_N = -w * (0.1 + 0.004 * i);
    // B6: lines through one point at 10 % but for 170 N, which lies lower; B3 above them.
    m.net_traction_N = w * 0.003 * (i - 10) + (is_soft ? 0.08 * w : 0) - (w > 150 ? 15 : 0);
    if (c.gravity == "mars") m.net_traction_N = w * 0.003 * (i - 10) + (is_soft && i < 30 ? 1.5 : 0);
    const double load_share = c.gravity == "mars" ? 1 : w / 170;
    m.sinkage_cm = -(0.5 + load_share) * (1 + 0.04 * i) * (is_soft ? 1 : 0.9);
    m.deflection_mm = is_soft ? 10 - 0.04 * i : 3 - 0.01 * i;
    m.effective_radius_m = 0.15 - 1e-3 * m.deflection_mm;
    return m;
}

inline Campaign synthetic_campaign(const Distortion& distort = [](const Condition&, RunMetrics&) {}) {
    Campaign campaign;
    Random random{3};
    const auto add_noise = [&](double& value, double width) { value += width * (2 * random.uniform() - 1); };
    const auto add = [&](const Condition& c) {
        MeasuredRun run;
        run.condition = c;
        run.metrics = follow_the_text(c);
        distort(c, run.metrics);
        for (double* force :
             {&run.metrics.gross_tractive_effort_N, &run.metrics.motion_resistance_N, &run.metrics.net_traction_N})
            add_noise(*force, 0.001 * c.load_N);
        add_noise(run.metrics.sinkage_cm, 0.02);
        add_noise(run.metrics.deflection_mm, 0.02);
        add_noise(run.metrics.effective_radius_m, 2e-5);
        campaign.runs.push_back(run);
    };
    for (const char* wheel : {"B3", "B6"})
        for (int slip = 0; slip <= 70; slip += 10)
            for (int r = 1; r <= (slip == 60 ? 3 : 1); ++r) {
                for (const double load : {50, 70, 100, 130, 170}) add({wheel, "earth", load, 1.0 * slip});
                add({wheel, "mars", 64.4, 1.0 * slip});
            }
    return campaign;
}

}  // namespace ifedem::test

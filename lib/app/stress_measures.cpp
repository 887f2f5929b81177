#include "app/stress_measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "check/csv.hpp"
#include "check/statistics.hpp"
#include "core/bitmath.hpp"

namespace ifedem {
namespace {

constexpr double degrees = 180 / pi;
constexpr double driven_from_percent = 7.5;  ///< "the range of slip is selected from 7.5 %" (section 4.3.3)
constexpr double high_from_percent = 22;     ///< "from the tire slip of 22 % or larger"

/// Least squares of value against slip (as a share) over groups from a slip on.
template <class F>
double gradient(const std::vector<SlipGroup>& groups, double from_percent, F&& value) {
    std::vector<double> x, y;
    for (const SlipGroup& g : groups)
        if (g.slip_percent >= from_percent - 1e-9) x.push_back(0.01 * g.slip_percent), y.push_back(value(g));
    if (x.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const double mx = mean(x), my = mean(y);
    double sxy = 0, sxx = 0;
    for (std::size_t k = 0; k < x.size(); ++k) sxy += (x[k] - mx) * (y[k] - my), sxx += (x[k] - mx) * (x[k] - mx);
    return sxy / sxx;
}

/// Collects the lines of measurements.csv.
class Measures {
public:
    explicit Measures(const std::vector<SlipGroup>& groups) : groups_(groups) {}

    /// Mean and scatter over realisations of one slip.
    template <class F>
    void add_runs(const SlipGroup& g, const std::string& name, const char* units, F&& value, std::string note = {}) {
        std::vector<double> values;
        for (const StressRun& r : g.run) values.push_back(value(r));
        if (!std::isfinite(mean(values))) return;
        list_.push_back({fmt::format("{}_s{:g}", name, g.slip_percent), mean(values), units, standard_deviation(values),
                         values.size(), std::move(note)});
    }

    /// A feature of the mean curve; its scatter is that of realisations, or, with fewer than three, the bootstrap's.
    template <class F>
    void add_feature(const SlipGroup& g, const std::string& name, const char* units, F&& value) {
        if (g.run.size() >= 3) return add_runs(g, name, units, [&](const StressRun& r) { return value(r.features); });
        std::vector<double> values;
        for (const CurveFeatures& f : g.replicate) values.push_back(value(f));
        add_bootstrap(fmt::format("{}_s{:g}", name, g.slip_percent), units, value(g.features), values, g.run.size());
    }

    /// Something made of the features of all slips together.
    template <class F>
    void add_over_slips(const std::string& name, const char* units, F&& statistic) {
        const double value = statistic([](const SlipGroup& g) { return g.features; });
        if (!std::isfinite(value)) return;
        std::vector<double> values;
        for (std::size_t k = 0; k < groups_.front().replicate.size(); ++k)
            values.push_back(statistic([k](const SlipGroup& g) { return g.replicate[k]; }));
        add_bootstrap(name, units, value, values, fewest_runs());
    }

    void add(Measurement m) {
        if (std::isfinite(m.value)) list_.push_back(std::move(m));
    }

    [[nodiscard]] std::vector<Measurement> list() && { return std::move(list_); }

private:
    /// 1.96 standard deviations of the replicates: they are near enough to normal, and the tails of 400 are not known
    /// well.
    void add_bootstrap(const std::string& name, const char* units, double value, const std::vector<double>& values,
                       std::size_t runs) {
        const double deviation = standard_deviation(values);
        list_.push_back(
            {name, value, units, deviation, runs,
             runs < 2 ? "bootstrap over travel blocks of one realisation a slip: what packings scatter is not in it"
                      : "bootstrap over travel blocks and realisations",
             1.96 * deviation});
    }

    [[nodiscard]] std::size_t fewest_runs() const {
        std::size_t fewest = groups_.front().run.size();
        for (const SlipGroup& g : groups_) fewest = std::min(fewest, g.run.size());
        return fewest;
    }

    const std::vector<SlipGroup>& groups_;
    std::vector<Measurement> list_;
};

void measure_slip(const SlipGroup& g, Measures& m) {
    m.add_feature(g, "entry_deg", "deg", [](const CurveFeatures& f) { return f.entry_rad[1] * degrees; });
    m.add_feature(g, "exit_deg", "deg", [](const CurveFeatures& f) { return f.exit_rad[1] * degrees; });
    m.add_feature(g, "contact_range_deg", "deg",
                  [](const CurveFeatures& f) { return (f.exit_rad[1] - f.entry_rad[1]) * degrees; });
    m.add_feature(g, "greatest_normal_kPa", "kPa", [](const CurveFeatures& f) { return 1e-3 * f.greatest_normal_Pa; });
    m.add_feature(g, "greatest_tangential_kPa", "kPa",
                  [](const CurveFeatures& f) { return 1e-3 * f.greatest_tangential_Pa; });
    m.add_feature(g, "greatest_normal_deg", "deg",
                  [](const CurveFeatures& f) { return f.greatest_normal_rad * degrees; });
    m.add_feature(g, "greatest_tangential_deg", "deg",
                  [](const CurveFeatures& f) { return f.greatest_tangential_rad * degrees; });
    // Shares of the greatest normal stress are pure numbers, as the ledger's rows on the sign and place of τ are.
    m.add_feature(g, "least_tangential_share", "-",
                  [](const CurveFeatures& f) { return f.least_tangential_Pa / f.greatest_normal_Pa; });
    m.add_runs(g, "gross_tractive_effort_N", "N", [](const StressRun& r) { return r.gross_tractive_effort_N; });
    m.add_runs(g, "net_traction_N", "N", [](const StressRun& r) { return r.net_traction_N; });
    m.add_runs(g, "motion_resistance_N", "N", [](const StressRun& r) { return r.motion_resistance_N; });
    m.add_runs(g, "integral_H_N", "N", [](const StressRun& r) { return r.integral_H_N; });
    m.add_runs(g, "integral_P_N", "N", [](const StressRun& r) { return r.integral_P_N; });
    m.add_runs(g, "integral_R_N", "N", [](const StressRun& r) { return r.integral_R_N; });
    m.add_runs(
        g, "load_N", "N", [](const StressRun& r) { return r.load_N; }, "radial, balanced Eq 4.3");
    m.add_runs(
        g, "load_printed_N", "N", [](const StressRun& r) { return r.load_printed_N; }, "radial, printed Eq 4.3");
    m.add_runs(
        g, "load_surface_N", "N", [](const StressRun& r) { return r.load_surface_N; },
        "surface normals on the nominal circle, balanced Eq 4.3");
    m.add_runs(
        g, "load_surface_printed_N", "N", [](const StressRun& r) { return r.load_surface_printed_N; },
        "surface normals on the nominal circle, printed Eq 4.3");
    m.add_runs(
        g, "surface_rougher", "-",
        [](const StressRun& r) { return r.surface.rough_behind_m / r.surface.rough_ahead_m; },
        "standard deviation of the surface's height behind the tyre over that ahead of it");
    m.add_runs(
        g, "highest_behind_mm", "mm", [](const StressRun& r) { return 1e3 * r.surface.highest_behind_m; },
        "over the mean height ahead");
    m.add_runs(
        g, "surface_higher", "-",
        [](const StressRun& r) { return r.surface.highest_behind_m / r.surface.highest_ahead_m; },
        "highest column of the surface behind the tyre over that ahead of it, both over the mean height ahead");
}

void measure_trends(const std::vector<SlipGroup>& groups, Measures& m) {
    m.add_over_slips("tangential_angle_gradient", "-", [&](auto&& features) {
        return gradient(groups, high_from_percent,
                        [&](const SlipGroup& g) { return features(g).greatest_tangential_rad; });
    });
    m.add_over_slips("peaks_apart_greatest_rad", "-", [&](auto&& features) {
        double greatest = std::numeric_limits<double>::quiet_NaN();
        for (const SlipGroup& g : groups) {
            if (g.slip_percent < high_from_percent) continue;
            const double apart = std::fabs(features(g).greatest_tangential_rad - features(g).greatest_normal_rad);
            if (!(apart <= greatest)) greatest = apart;
        }
        return greatest;
    });
    m.add_over_slips("relative_peak_gradient", "-", [&](auto&& features) {
        return gradient(groups, driven_from_percent, [&](const SlipGroup& g) { return features(g).relative_peak(); });
    });
    if (groups.size() >= 4)
        m.add_over_slips("exit_curvature", "-", [&](auto&& features) {
            std::vector<double> x, y;
            for (const SlipGroup& g : groups) x.push_back(g.slip_percent), y.push_back(features(g).exit_rad[1]);
            return test_curvature(x, y, std::vector<double>(x.size(), 1.0)).sagitta_share;
        });
}

/// Greatest |value| over all runs.
template <class F>
void add_greatest(const std::vector<SlipGroup>& groups, Measures& m, const char* name, F&& value, const char* note) {
    double greatest = 0;
    std::size_t n = 0;
    for (const SlipGroup& g : groups)
        for (const StressRun& r : g.run) greatest = std::max(greatest, std::fabs(value(r))), ++n;
    m.add({name, greatest, "-", 0, 1, fmt::format("{}; the greatest of {} runs", note, n)});
}

void measure_balances(const std::vector<SlipGroup>& groups, Measures& m) {
    add_greatest(
        groups, m, "identity_horizontal", [](const StressRun& r) { return r.horizontal; },
        "P_d by integral less the controller's with inertia, over W");
    add_greatest(
        groups, m, "identity_vertical", [](const StressRun& r) { return r.vertical; },
        "W by integral less the load with inertia, over W");
    add_greatest(
        groups, m, "identity_torque", [](const StressRun& r) { return r.torque; },
        "moment of the stresses at actual radii less T with inertia, over T");
    add_greatest(
        groups, m, "identity_H", [](const StressRun& r) { return r.difference_H; },
        "H − H_integral less br∫τ(r/r_e − sinθ), over W");
    add_greatest(
        groups, m, "identity_vectors", [](const StressRun& r) { return r.vectors; },
        "sums of vectors less their parts turned back, over W");
    add_greatest(
        groups, m, "identity_splines", [](const StressRun& r) { return r.splines; },
        "integrals of splines less sums of segments, over W");
    add_greatest(
        groups, m, "identity_quadrature", [](const StressRun& r) { return r.quadrature; },
        "GSL's bound of the error of an integral, over W");
    const auto apart = [](double a, double b, const StressRun& r) { return (a - b) / r.c.wheel.load_N; };
    add_greatest(
        groups, m, "difference_H",
        [&](const StressRun& r) { return apart(r.gross_tractive_effort_N, r.integral_H_N, r); },
        "H by controller less by integral, over W");
    add_greatest(
        groups, m, "difference_P", [&](const StressRun& r) { return apart(r.net_traction_N, r.integral_P_N, r); },
        "P_d by controller less by integral, over W");
    add_greatest(
        groups, m, "difference_R", [&](const StressRun& r) { return apart(r.motion_resistance_N, r.integral_R_N, r); },
        "R by controller less by integral, over W");
    add_greatest(
        groups, m, "difference_H_printed",
        [&](const StressRun& r) { return apart(r.gross_tractive_effort_N, r.printed_H_N, r); },
        "H by controller less by Eq 4.4 as printed, over W");
    add_greatest(
        groups, m, "difference_R_printed",
        [&](const StressRun& r) { return apart(r.motion_resistance_N, r.printed_R_N, r); },
        "R by controller less by Eq 4.5 as printed, over W");
}

/// Of the bed after consolidation, one a realisation.
void measure_bed(const std::vector<SlipGroup>& groups, Measures& m) {
    const SlipGroup* most = &groups.front();
    for (const SlipGroup& g : groups)
        if (g.run.size() > most->run.size()) most = &g;
    for (const char* part : {"", "_whole"}) {
        std::vector<double> porosity, density, ratio;
        for (const StressRun& r : most->run) {
            const std::string name = fmt::format("consolidation_porosity{}", part);
            const auto value = parse_number(find_value(r.values, name));
            if (!value) break;  // too small a bed
            porosity.push_back(*value);
            density.push_back((1 - *value) * r.c.soil.density_kg_m3);
            ratio.push_back(*value / (1 - *value));
        }
        if (porosity.size() < most->run.size()) continue;
        const auto add = [&](const char* name, const char* units, const std::vector<double>& v) {
            m.add({std::string(name) + part, mean(v), units, standard_deviation(v), v.size(),
                   *part == 0 ? "without 10 r_max at floor, walls and surface" : "the whole bed"});
        };
        add("bulk_density", "kg/m3", density), add("porosity", "-", porosity), add("void_ratio", "-", ratio);
    }
}

}  // namespace

std::vector<Measurement> measure_stress(const std::vector<SlipGroup>& groups) {
    Measures m(groups);
    for (const SlipGroup& g : groups) measure_slip(g, m);
    measure_trends(groups, m);
    measure_balances(groups, m);
    measure_bed(groups, m);
    const Case& c = groups.front().run.front().c;
    m.add({"segment_length_mm", 1e3 * c.wheel.tread_radius_m * pi / static_cast<double>(c.record.stress_segments), "mm",
           0, 1, "from the case"});
    return std::move(m).list();
}

}  // namespace ifedem

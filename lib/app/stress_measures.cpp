#include "app/stress_measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "check/csv.hpp"
#include "check/statistics.hpp"
#include "core/bitmath.hpp"
#include "core/error.hpp"
#include "record/frame_file.hpp"

namespace ifedem {
namespace {

constexpr double degrees = 180 / pi;
constexpr std::size_t replicates = 400;
constexpr double driven_from_percent = 7.5;  ///< "the range of slip is selected from 7.5 %" (section 4.3.3)
constexpr double high_from_percent = 22;     ///< "from the tire slip of 22 % or larger"

ContactArc arc_of(const Case& c) { return {c.wheel.width_m, c.wheel.tread_radius_m}; }

/// Heights of the highest disc tops over columns of two mean diameters.
struct Profile {
    std::vector<double> x_m, top_m;
};
Profile take_profile(const Frame& frame, double from_m, double to_m, double column_m) {
    Profile p;
    const auto columns = static_cast<std::size_t>(std::max(1.0, (to_m - from_m) / column_m));
    p.top_m.assign(columns, 0.0);
    for (std::size_t k = 0; k < columns; ++k) p.x_m.push_back(from_m + (static_cast<double>(k) + 0.5) * column_m);
    for (std::size_t n = 0; n < frame.disc_position_m.size(); ++n) {
        const double at = (frame.disc_position_m[n].x - from_m) / column_m;
        if (!(at >= 0 && at < static_cast<double>(columns))) continue;
        double& top = p.top_m[static_cast<std::size_t>(at)];
        top = std::max(top, frame.disc_position_m[n].y + static_cast<double>(frame.disc_radius_m[n]));
    }
    return p;
}

double roughness(const Profile& p) {
    if (p.x_m.size() < 3) return std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> weights(p.x_m.size(), 1.0);
    const PolynomialFit line = fit_polynomial(p.x_m, p.top_m, weights, 1);
    std::vector<double> rest;
    for (std::size_t k = 0; k < p.x_m.size(); ++k) rest.push_back(p.top_m[k] - line.at(p.x_m[k]));
    return standard_deviation(rest);
}

/// Sums over the segments of the lower half with their centres' angles.
struct SegmentTotals {
    double fx_N = 0, fy_N = 0;              ///< true vectors
    double turned_x_N = 0, turned_y_N = 0;  ///< from the radial parts
    double moment_Nm = 0, circumferential_sin_N = 0;
};
SegmentTotals add_segments(const std::vector<MeanSegment>& means) {
    SegmentTotals t;
    for (std::size_t k = 0; k + 1 < means.size(); ++k) {
        const SegmentSum& m = means[k].mean;
        const double c = std::cos(means[k].angle_rad), s = std::sin(means[k].angle_rad);
        t.fx_N += m.fx_N, t.fy_N += m.fy_N;
        t.turned_x_N += m.circumferential_N * s - m.radial_N * c;
        t.turned_y_N += m.radial_N * s + m.circumferential_N * c;
        t.moment_Nm += m.moment_Nm;
        t.circumferential_sin_N += m.circumferential_N * s;
    }
    return t;
}

void integrate_run(const std::vector<MeanSegment>& means, StressRun& r) {
    const ContactArc arc = arc_of(r.c);
    const StressCurve radial = make_stress_curve(means, arc, Decomposition::radial);
    const StressField field = make_field(radial);
    const StressField surface = make_field(make_stress_curve(means, arc, Decomposition::surface));
    const TractiveIntegrals written = integrate_stress(field, arc, Sharing::as_written);
    const TractiveIntegrals printed = integrate_stress(field, arc, Sharing::printed, VerticalForm::printed);
    r.features = find_features(radial, kernel_half_width_rad(r.c));
    r.integral_H_N = written.gross_tractive_effort_N.value;
    r.integral_P_N = written.net_traction_N.value;
    r.integral_R_N = written.motion_resistance_N.value;
    r.printed_H_N = printed.gross_tractive_effort_N.value;
    r.printed_R_N = printed.motion_resistance_N.value;
    r.load_N = written.load_N.value;
    r.load_printed_N = printed.load_N.value;
    r.load_surface_N = integrate_stress(surface, arc).load_N.value;
    r.load_surface_printed_N = integrate_stress(surface, arc, Sharing::printed, VerticalForm::printed).load_N.value;
    for (const Integral& i : {written.gross_tractive_effort_N, written.motion_resistance_N, written.net_traction_N,
                              written.load_N, printed.load_N})
        r.quadrature = std::max(r.quadrature, i.error / r.c.wheel.load_N);
}

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
        list_.push_back({fmt::format("{}_s{:g}", name, g.slip_percent), value(g.features), units,
                         standard_deviation(values), blocks(), bootstrap_note});
    }

    /// Something made of the features of all slips together.
    template <class F>
    void add_over_slips(const std::string& name, const char* units, F&& statistic) {
        const double value = statistic([](const SlipGroup& g) { return g.features; });
        if (!std::isfinite(value)) return;
        std::vector<double> values;
        for (std::size_t k = 0; k < replicates; ++k)
            values.push_back(statistic([k](const SlipGroup& g) { return g.replicate[k]; }));
        list_.push_back({name, value, units, standard_deviation(values), blocks(), bootstrap_note});
    }

    void add(StressMeasure m) {
        if (std::isfinite(m.value)) list_.push_back(std::move(m));
    }

    [[nodiscard]] std::vector<StressMeasure> list() && { return std::move(list_); }

private:
    static constexpr const char* bootstrap_note =
        "scatter: bootstrap over travel blocks and realisations; n: blocks of the slip with the fewest";

    [[nodiscard]] std::size_t blocks() const {
        std::size_t fewest = std::numeric_limits<std::size_t>::max();
        for (const SlipGroup& g : groups_) fewest = std::min(fewest, g.run.size() * g.run.front().stress.block.size());
        return fewest;
    }

    const std::vector<SlipGroup>& groups_;
    std::vector<StressMeasure> list_;
};

void measure_slip(const SlipGroup& g, Measures& m) {
    m.add_feature(g, "entry_deg", "deg", [](const CurveFeatures& f) { return f.entry_rad[1] * degrees; });
    m.add_feature(g, "exit_deg", "deg", [](const CurveFeatures& f) { return f.exit_rad[1] * degrees; });
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
}

void measure_trends(const std::vector<SlipGroup>& groups, Measures& m) {
    const auto slope = [&](double from, double CurveFeatures::*member, bool relative) {
        return [&groups, from, member, relative](auto&& features) {
            double sum = 0;
            std::size_t n = 0;
            for (const SlipGroup& g : groups)
                if (g.slip_percent >= from) sum += features(g).*member, ++n;
            return gradient(groups, from, [&](const SlipGroup& g) { return features(g).*member; }) /
                   (relative ? sum / static_cast<double>(n) : 1.0);
        };
    };
    m.add_over_slips("range_gradient", "-", [&](auto&& features) {
        return gradient(groups, driven_from_percent,
                        [&](const SlipGroup& g) { return features(g).exit_rad[1] - features(g).entry_rad[1]; });
    });
    m.add_over_slips("greatest_normal_gradient", "-",
                     slope(driven_from_percent, &CurveFeatures::greatest_normal_Pa, true));
    m.add_over_slips("greatest_tangential_gradient", "-",
                     slope(driven_from_percent, &CurveFeatures::greatest_tangential_Pa, true));
    m.add_over_slips("normal_angle_gradient", "-", slope(-100, &CurveFeatures::greatest_normal_rad, false));
    m.add_over_slips("tangential_angle_gradient", "-",
                     slope(high_from_percent, &CurveFeatures::greatest_tangential_rad, false));
    m.add_over_slips("peaks_apart_rad", "-", [&](auto&& features) {
        double sum = 0, n = 0;
        for (const SlipGroup& g : groups) {
            if (g.slip_percent < high_from_percent) continue;
            sum += features(g).greatest_tangential_rad - features(g).greatest_normal_rad;
            n += 1;
        }
        return sum / n;
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

/// Change of W by integral from the least to the greatest slip, by the line through all.
void measure_load(const std::vector<SlipGroup>& groups, Measures& m) {
    const auto fall = [&](const char* name, double StressRun::*member) {
        if (groups.size() < 2) return;
        const double slope = gradient(groups, -100, [&](const SlipGroup& g) { return mean_of(g, member); });
        m.add({name, 0.01 * slope * (groups.back().slip_percent - groups.front().slip_percent), "N", 0, 1,
               "line through all slips"});
    };
    fall("load_rise_N", &StressRun::load_N);
    fall("load_printed_rise_N", &StressRun::load_printed_N);
    fall("load_surface_rise_N", &StressRun::load_surface_N);
    fall("load_surface_printed_rise_N", &StressRun::load_surface_printed_N);
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
            const auto found =
                std::find_if(r.values.begin(), r.values.end(), [&](const RunValue& v) { return v.name == name; });
            const auto value = found == r.values.end() ? std::nullopt : parse_number(found->value);
            if (!value) return;
            porosity.push_back(*value);
            density.push_back((1 - *value) * r.c.soil.density_kg_m3);
            ratio.push_back(*value / (1 - *value));
        }
        const auto add = [&](const char* name, const char* units, const std::vector<double>& v) {
            m.add({std::string(name) + part, mean(v), units, standard_deviation(v), v.size(),
                   *part == 0 ? "without 10 r_max at floor, walls and surface" : "the whole bed"});
        };
        add("bulk_density", "kg/m3", density), add("porosity", "-", porosity), add("void_ratio", "-", ratio);
    }
}

}  // namespace

double kernel_half_width_rad(const Case& c) {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < c.soil.radii_m.size(); ++k)
        sum += 2 * c.soil.radii_m[k] * c.soil.radii_shares[k], count += c.soil.radii_shares[k];
    return sum / count / c.wheel.tread_radius_m;
}

SurfaceMeasure measure_surface(const std::string& run_directory) {
    const std::string path = run_directory + "/results.h5";
    const auto list = read_frame_list(path);
    if (list.empty()) return {};
    const Case c = parse_case(read_frame_header(path).case_text, path);
    const Frame last = read_frame(path, list.size() - 1);
    const double radius = c.wheel.tread_radius_m, hub = last.hub_position_m.x;
    const double column = 4 * *std::max_element(c.soil.radii_m.begin(), c.soil.radii_m.end());
    // Behind: from where the ramp of speed ended to a radius behind the hub, where contact has ended; ahead: from where
    // the heap ends to the same distance from the wall.
    const double ramp = 0.5 * c.travel.acceleration_time_s * travel_speed_m_s(c.travel);
    const Profile behind = take_profile(last, c.travel.start_x_m + ramp, hub - radius, column);
    const Profile ahead = take_profile(last, hub + radius, c.bed.length_m - column, column);
    SurfaceMeasure m;
    m.rough_behind_m = roughness(behind), m.rough_ahead_m = roughness(ahead);
    m.highest_behind_m = *std::max_element(behind.top_m.begin(), behind.top_m.end()) - mean(ahead.top_m);
    return m;
}

StressRun analyse_run(const std::string& name, const Case& c, StressState stress, const SurfaceMeasure& surface,
                      std::vector<RunValue> values) {
    StressRun r;
    r.name = name, r.c = c, r.surface = surface, r.values = std::move(values);
    const std::vector<MeanSegment> means = mean_segments(stress);
    if (means.empty()) fail_input(fmt::format("{}: the hub never was in the averaging window. Travel further.", name));
    const StressBlock b = sum_blocks(stress);
    const double time_s = b.steps * c.time_step_s, load = c.wheel.load_N;
    const double torque = b.torque_Nm / b.steps, radius = b.effective_radius_m / b.steps;
    r.gross_tractive_effort_N = torque / radius;
    r.net_traction_N = -b.drawbar_N / b.steps;
    r.motion_resistance_N = r.net_traction_N - r.gross_tractive_effort_N;
    integrate_run(means, r);
    const SegmentTotals t = add_segments(means);
    r.horizontal = (r.integral_P_N - r.net_traction_N - b.impulse_x_Ns / time_s) / load;
    r.vertical = (r.load_N - load - b.impulse_y_Ns / time_s) / load;
    r.torque = (t.moment_Nm - torque + b.spin_Nms / time_s) / torque;
    r.difference_H = (r.gross_tractive_effort_N - b.spin_Nms / time_s / radius - r.printed_H_N -
                      (t.moment_Nm / radius - t.circumferential_sin_N)) /
                     load;
    r.vectors = std::hypot(t.fx_N - t.turned_x_N, t.fy_N - t.turned_y_N) / load;
    r.splines = std::max({std::fabs(r.integral_P_N - t.turned_x_N), std::fabs(r.load_N - t.turned_y_N),
                          std::fabs(r.printed_H_N - t.circumferential_sin_N)}) /
                load;
    r.stress = std::move(stress);
    return r;
}

SlipGroup analyse_slip(double slip_percent, std::vector<StressRun> runs) {
    SlipGroup g;
    g.slip_percent = slip_percent;
    g.run = std::move(runs);
    const ContactArc arc = arc_of(g.run.front().c);
    const auto average = [&](Decomposition d) {
        StressCurve sum;
        for (const StressRun& r : g.run) {
            const StressCurve c = make_stress_curve(mean_segments(r.stress), arc, d);
            if (sum.angle_rad.empty())
                sum = {c.angle_rad, std::vector<double>(c.angle_rad.size()), std::vector<double>(c.angle_rad.size())};
            for (std::size_t k = 0; k < c.angle_rad.size(); ++k) {
                sum.normal_Pa[k] += c.normal_Pa[k] / static_cast<double>(g.run.size());
                sum.tangential_Pa[k] += c.tangential_Pa[k] / static_cast<double>(g.run.size());
            }
        }
        return sum;
    };
    g.radial = average(Decomposition::radial);
    g.surface = average(Decomposition::surface);
    const double half = kernel_half_width_rad(g.run.front().c);
    g.features = find_features(g.radial, half);
    std::vector<StressState> states;
    for (const StressRun& r : g.run) states.push_back(r.stress);
    Random random{4};
    g.replicate = bootstrap_features(states, arc, Decomposition::radial, half, replicates, random);
    return g;
}

double mean_of(const SlipGroup& group, double StressRun::*member) {
    std::vector<double> values;
    for (const StressRun& r : group.run) values.push_back(r.*member);
    return mean(values);
}

Interval interval_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
    };
    return {at(0.025), at(0.975)};
}

std::vector<StressMeasure> measure_stress(const std::vector<SlipGroup>& groups) {
    Measures m(groups);
    for (const SlipGroup& g : groups) measure_slip(g, m);
    measure_trends(groups, m);
    measure_balances(groups, m);
    measure_load(groups, m);
    measure_bed(groups, m);
    const Case& c = groups.front().run.front().c;
    m.add({"segment_length_mm", 1e3 * c.wheel.tread_radius_m * pi / static_cast<double>(c.record.stress_segments), "mm",
           0, 1, "from the case"});
    return std::move(m).list();
}

}  // namespace ifedem

#include "check/figure_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "check/csv.hpp"
#include "check/trend.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

constexpr std::size_t series_bins = 400;

std::string slip_line(const std::string& curve, const char* kind, double slip, double value, double uncertainty,
                      std::size_t n, const std::string& label) {
    return csv_line({curve, kind, format_number(slip), format_number(value), format_number(uncertainty),
                     n > 0 ? std::to_string(n) : "", label});
}

/// The text's own number where a claim compares it with this metric on one of the curves.
struct TextPoint {
    std::string curve;
    double slip = 0, value = 0, reading = 0;
    std::string printed;
};

/// Where a curve's name stands, beside its last point.
struct CurveLabel {
    std::string curve;
    double slip = 0, value = 0;
    std::string text;
};

ValuesBySlip collect_over(const Campaign& campaign, const Curve& curve, const MetricInfo& metric, SlipAxis axis) {
    auto values = collect(campaign, curve, metric);
    if (axis == SlipAxis::set) return values;
    const auto measured = collect(campaign, curve, *find_metric("measured_slip_percent"));
    ValuesBySlip moved;
    for (auto& [slip, group] : values) moved[mean(measured.at(slip))] = std::move(group);
    return moved;
}

std::string curve_lines(const Campaign& campaign, const Curve& curve, const MetricInfo& metric, SlipAxis axis) {
    const auto values = collect_over(campaign, curve, metric, axis);
    if (values.empty()) return {};
    const PooledScatter scatter = borrow_scatter(campaign, curve, metric).pooled;
    const std::string word = to_word(curve);
    std::string text;
    for (const auto& [slip, group] : values) {
        const Estimate e = estimate(group, 0, scatter);
        text += slip_line(word, "mean", slip, e.mean, std::isfinite(e.uncertainty) ? e.uncertainty : 0, e.n, "");
        if (group.size() > 1)
            for (const double v : group) text += slip_line(word, "run", slip, v, 0, 1, "");
    }
    const TrendPoints points = trend_points(values, scatter);
    const auto& slips = points.slip_percent;
    if (slips.size() < 4) return text;
    const auto fit = fit_polynomial(slips, points.mean, points.weight, 2);
    constexpr int steps = 40;
    for (int k = 0; k <= steps; ++k) {
        const double slip = slips.front() + (slips.back() - slips.front()) * k / steps;
        text += slip_line(word, "fit", slip, fit.at(slip), 0, 0, "");
    }
    return text;
}

/// What tells a curve from the others: its wheel, its planet with the load, or its load.
std::string label_text(const Curve& curve, const std::vector<CurveName>& curves) {
    bool same_wheel = true, same_planet = true;
    for (const auto& other : curves) {
        same_wheel = same_wheel && other.curve.wheel == curve.wheel;
        same_planet = same_planet && other.curve.gravity == curve.gravity;
    }
    if (!same_wheel) return curve.wheel;
    if (!same_planet || curves.size() == 1) return fmt::format("{}, {:g} N", capitalised(curve.gravity), curve.load_N);
    return fmt::format("{:g} N", curve.load_N);
}

/// Labels at the curves' ends, moved up where they would stand on each other.
std::string label_lines(const Campaign& campaign, const MetricInfo& metric, const std::vector<CurveName>& curves,
                        SlipAxis axis) {
    std::vector<CurveLabel> labels;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const auto& name : curves) {
        const auto values = collect_over(campaign, name.curve, metric, axis);
        if (values.empty()) continue;
        for (const auto& [slip, group] : values) {
            least = std::min(least, mean(group));
            most = std::max(most, mean(group));
        }
        labels.push_back({to_word(name.curve), values.rbegin()->first, mean(values.rbegin()->second),
                          label_text(name.curve, curves)});
    }
    std::stable_sort(labels.begin(), labels.end(),
                     [](const CurveLabel& a, const CurveLabel& b) { return a.value < b.value; });
    constexpr double line_height = 0.065;  // of the range that the points take
    std::string text;
    double lowest_free = -std::numeric_limits<double>::infinity();
    for (const auto& l : labels) {
        const double at = std::max(l.value, lowest_free);
        lowest_free = at + line_height * (most - least);
        text += slip_line(l.curve, "label", l.slip, at, 0, 0, l.text);
    }
    return text;
}

std::vector<TextPoint> text_points(const std::vector<Outcome>& outcomes, const std::string& metric,
                                   const std::vector<CurveName>& curves) {
    std::vector<TextPoint> points;
    for (const auto& o : outcomes) {
        const auto& s = o.claim.selection;
        if (o.claim.metric != metric || o.claim.comparison != Comparison::equal || !o.reference || s.sides.size() != 1)
            continue;
        for (const auto& name : curves)
            if (s.sides[0][0] == name.curve)
                points.push_back({to_word(name.curve), s.slip_from_percent, *o.reference,
                                  reading_uncertainty(o.reference_text, o.units, name.curve.gravity),
                                  o.reference_text});
    }
    return points;
}

/// A marker each; the label of the lowest of several stands below it and the others' above, so that they keep apart.
std::string text_lines(const std::vector<Outcome>& outcomes, const std::string& metric,
                       const std::vector<CurveName>& curves) {
    const auto points = text_points(outcomes, metric, curves);
    std::string text;
    for (const auto& p : points) {
        const bool is_lowest =
            points.size() > 1 &&
            std::all_of(points.begin(), points.end(), [&](const TextPoint& other) { return p.value <= other.value; });
        const std::string number = p.printed.starts_with('-') ? "−" + p.printed.substr(1) : p.printed;
        text += slip_line(p.curve, "text", p.slip, p.value, p.reading, 0, "");
        text += slip_line(p.curve, is_lowest ? "below" : "above", p.slip, p.value, 0, 0, "text: " + number);
    }
    return text;
}

struct Bin {
    double sum = 0, least = std::numeric_limits<double>::infinity(),
           greatest = -std::numeric_limits<double>::infinity();
    std::size_t n = 0;
    void add(double v) {
        sum += v;
        least = std::min(least, v);
        greatest = std::max(greatest, v);
        ++n;
    }
};

}  // namespace

CurveName parse_curve(const std::string& text) {
    auto words = split(text, ' ');
    CurveName name;
    name.curve.wheel = "B3";
    if (words.size() > 1 && !parse_number(words[1])) {
        name.curve.wheel = words[0];
        words.erase(words.begin());
    }
    const auto load = words.size() > 1 ? parse_number(words[1]) : std::nullopt;
    const auto slip = words.size() > 2 ? parse_number(words[2]) : std::optional<double>(0);
    if (!load || !slip)
        fail_input(fmt::format(
            "figures.csv: '{}' is not a curve. Write it as 'earth 170', 'B6 earth 170' or 'earth 170 60'?", text));
    name.curve.gravity = words[0];
    name.curve.load_N = *load;
    name.slip_percent = *slip;
    return name;
}

std::string to_word(const Curve& curve) { return fmt::format("{}-{}-{:g}", curve.wheel, curve.gravity, curve.load_N); }

std::optional<std::string> slip_data(const Campaign& campaign, const std::vector<Outcome>& outcomes,
                                     const std::string& metric, const std::vector<CurveName>& curves, SlipAxis axis) {
    const auto* info = find_metric(metric);
    if (!info) fail_input(fmt::format("figures.csv: the metric '{}' is not known. Use a column of runs.csv?", metric));
    std::string lines;
    for (const auto& name : curves) lines += curve_lines(campaign, name.curve, *info, axis);
    if (lines.empty()) return std::nullopt;
    lines += label_lines(campaign, *info, curves, axis);
    lines += text_lines(outcomes, metric, curves);
    return "curve,kind,slip_percent,value,uncertainty,n,label\n" + lines;
}

std::string series_data(const MeasuredRun& run) {
    const auto column = [&](const char* name) -> const std::vector<double>& { return run.run.travel.at(name); };
    const auto& x = column("wheel_x_m");
    const std::array<const std::vector<double>*, 3> quantities{&column("torque_Nm"), &column("net_traction_N"),
                                                               &column("sinkage_m")};
    const double length = std::max(1e-9, *std::max_element(x.begin(), x.end()) - x.front());
    std::array<std::vector<Bin>, 3> bins;
    for (auto& b : bins) b.resize(series_bins);
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double share = std::clamp((x[k] - x.front()) / length, 0.0, 1.0);
        const auto bin = std::min(series_bins - 1, static_cast<std::size_t>(share * static_cast<double>(series_bins)));
        for (std::size_t q = 0; q < bins.size(); ++q) bins[q][bin].add((*quantities[q])[k] * (q == 2 ? 100 : 1));
    }
    std::string text =
        "travel_cm,torque_Nm,torque_least_Nm,torque_greatest_Nm,net_traction_N,net_traction_least_N,net_traction_"
        "greatest_N,"
        "sinkage_cm,sinkage_least_cm,sinkage_greatest_cm\n";
    for (std::size_t k = 0; k < series_bins; ++k) {
        if (bins[0][k].n == 0) continue;
        std::vector<std::string> cells{format_number(100 * length * (static_cast<double>(k) + 0.5) / series_bins)};
        for (const auto& b : bins)
            for (const double v : {b[k].sum / static_cast<double>(b[k].n), b[k].least, b[k].greatest})
                cells.push_back(format_number(v));
        text += csv_line(cells);
    }
    return text;
}

std::optional<std::string> agreement_data(const std::vector<Outcome>& outcomes) {
    std::vector<const Outcome*> rows;
    for (const auto& o : outcomes)
        if (o.claim.comparison == Comparison::equal && o.error_over_tolerance) rows.push_back(&o);
    if (rows.empty()) return std::nullopt;
    std::string text = "row,label,error_over_tolerance,verdict\n";
    for (std::size_t k = 0; k < rows.size(); ++k)
        text += csv_line({std::to_string(k), fmt::format("{}  {}", rows[k]->ledger.quantity, rows[k]->claim.id),
                          format_number(std::clamp(*rows[k]->error_over_tolerance, -3.0, 3.0)),
                          std::string(to_text(rows[k]->verdict))});
    return text;
}

std::optional<std::string> stiffness_data(const Campaign& campaign) {
    if (campaign.stiffness_points.empty()) return std::nullopt;
    std::string text = "wheel,phase_deg,deflection_mm,load_N\n";
    for (const auto& p : campaign.stiffness_points)
        text += csv_line(
            {p.wheel, format_number(p.phase_deg), format_number(1e3 * p.deflection_m), format_number(p.load_N)});
    return text;
}

const MeasuredRun* find_run(const Campaign& campaign, const CurveName& name) {
    for (const auto& run : campaign.runs)
        if (is_on(name.curve, run.condition) && std::abs(run.condition.slip_percent - name.slip_percent) < 1e-9 &&
            std::isfinite(run.metrics.torque_Nm))
            return &run;
    return nullptr;
}

}  // namespace ifedem

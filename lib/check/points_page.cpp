#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "check/check.hpp"
#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/gnuplot.hpp"
#include "check/points.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

/// The picture: its area of axes in pixels, as speed.gp sets it (960 × 560), and what it spans.
constexpr Box axes{77, 62, 936, 538};
struct Span {
    double low = 1, high = 10;
    [[nodiscard]] double share_of(double value) const { return std::log(value / low) / std::log(high / low); }
    [[nodiscard]] double at(double share) const { return low * std::pow(high / low, share); }
};
struct Frame {
    Span x, y;
    [[nodiscard]] double x_px(double cost) const { return axes.left + (axes.right - axes.left) * x.share_of(cost); }
    [[nodiscard]] double y_px(double error) const { return axes.bottom + (axes.top - axes.bottom) * y.share_of(error); }
    [[nodiscard]] double cost_at(double px) const { return x.at((px - axes.left) / (axes.right - axes.left)); }
    [[nodiscard]] double error_at(double px) const { return y.at((px - axes.bottom) / (axes.top - axes.bottom)); }
};

struct Mark {
    const Point* point = nullptr;
    double error = 0;  ///< where it is drawn: no lower than the picture's edge
    const char* kind = "";
};

const Quantity& find_quantity(const std::string& name) {
    return *std::ranges::find(point_quantities(), name, &Quantity::name);
}
std::string symbol_of(const std::string& quantity) { return std::string(find_quantity(quantity).symbol); }
std::string unit_of(const std::string& quantity) { return std::string(find_quantity(quantity).unit); }

bool is_hidden(const Chart& chart, const Point& point) {
    const double floor = chart.floor(point.n);
    return std::isfinite(floor) && chart.error_of(point) <= floor;
}

std::string name_of(const Chart& chart) {
    std::string name =
        fmt::format("{}-{}-{}-{:g}N-s{:g}-{}", chart.quantity.substr(0, chart.quantity.find_last_of('_')),
                    chart.condition.wheel, chart.condition.gravity.substr(0, 5), chart.condition.load_N,
                    chart.condition.slip_percent, chart.against == Against::finest ? "fine" : "text");
    std::ranges::replace(name, '_', '-');
    return name;
}

Frame frame_of(const Chart& chart) {
    Span x{1e300, 0}, y{1e300, 0};
    const double floor = chart.floor(chart.n), least = std::isfinite(floor) ? floor / 30 : 0;
    const auto widen = [&](double error) {
        if (!std::isfinite(error)) return;
        y.low = std::min(y.low, std::max(error, least));
        y.high = std::max(y.high, error);
    };
    for (const Point& p : chart.points) {
        x.low = std::min(x.low, p.relative_cost);
        x.high = std::max(x.high, p.relative_cost);
        widen(chart.error_of(p));
    }
    widen(floor);
    if (!(y.high > 0)) y = {1e-3, 1};
    if (!(y.low > 1e-6 * y.high)) y.low = 1e-6 * y.high;
    return {{x.low / 1.3, x.high * 1.6}, {y.low / 1.6, y.high * 3}};
}

/// Finished points that have an error, then a strip of stopped ones along the upper edge.
std::vector<Mark> list_marks(const Chart& chart, const Frame& frame) {
    std::vector<Mark> marks;
    for (const Point& p : chart.points) {
        const double error = chart.error_of(p);
        if (!p.stopped.empty())
            marks.push_back({&p, frame.y.at(0.97), "stopped"});
        else if (std::isfinite(error))
            marks.push_back({&p, std::max(error, frame.y.at(0.01)), is_hidden(chart, p) ? "hidden" : "seen"});
    }
    std::ranges::stable_sort(marks, {}, [](const Mark& m) { return m.point->relative_cost; });
    return marks;
}

std::string marks_csv(const Chart& chart, const Frame& frame) {
    const auto marks = list_marks(chart, frame);
    std::vector<Label> labels;
    constexpr double letter_px = 6.6, line_px = 12;
    for (const Mark& m : marks)
        labels.push_back({frame.x_px(m.point->relative_cost), frame.y_px(m.error),
                          letter_px * static_cast<double>(m.point->variant.size()) + 2, line_px});
    const auto boxes = place_labels(labels, axes);
    std::string text = "variant,cost,error,low,high,kind,label_x,label_y,line_x,line_y\n";
    for (std::size_t k = 0; k < marks.size(); ++k) {
        const Mark& m = marks[k];
        const Box& box = boxes[k];
        const double u = chart.against == Against::finest ? m.point->error_fine_U : unknown;
        const bool has_bar = std::isfinite(u) && m.point->stopped.empty();
        const double line_x = std::clamp(labels[k].x, box.left, box.right);
        const double line_y = std::clamp(labels[k].y, box.bottom, box.top);
        text += csv_line({m.point->variant, format_number(m.point->relative_cost), format_number(m.error),
                          has_bar ? format_number(std::max(m.error - u, frame.y.low)) : "NaN",
                          has_bar ? format_number(std::min(m.error + u, frame.y.at(0.94))) : "NaN", m.kind,
                          format_number(frame.cost_at(box.left)),
                          format_number(frame.error_at(0.5 * (box.bottom + box.top))),
                          format_number(frame.cost_at(line_x)), format_number(frame.error_at(line_y))});
    }
    return text;
}

/// Which kinds of marks there are, for the script.
std::string list_kinds(const Chart& chart, const Frame& frame) {
    std::string kinds;
    for (const Mark& m : list_marks(chart, frame)) {
        kinds += fmt::format("{} ", m.kind);
        if (chart.against == Against::finest && std::isfinite(m.point->error_fine_U)) kinds += "bar ";
    }
    return kinds;
}

/// The front as a staircase: an error holds until a dearer point has a smaller one.
std::string front_csv(const Chart& chart, const Frame& frame) {
    std::string text = "cost,error\n";
    double before = frame.y.at(0.93);
    for (const std::size_t k : chart.front) {
        const Point& p = chart.points[k];
        const double floor = chart.floor(p.n);
        const double error = std::max({chart.error_of(p), std::isfinite(floor) ? floor : 0.0, frame.y.low});
        text += fmt::format("{:.6g},{:.6g}\n{:.6g},{:.6g}\n", p.relative_cost, before, p.relative_cost, error);
        before = error;
    }
    text += fmt::format("{:.6g},{:.6g}\n", frame.x.high, before);
    return text;
}

Figure draw_chart(const Chart& chart, const PointsRequest& request, const std::string& root) {
    const std::string name = name_of(chart), base = "figures/" + name;
    const Frame frame = frame_of(chart);
    write_text(fmt::format("{}/{}.csv", request.out_dir, base), marks_csv(chart, frame));
    write_text(fmt::format("{}/{}-front.csv", request.out_dir, base), front_csv(chart, frame));
    const std::string symbol = symbol_of(chart.quantity), unit = unit_of(chart.quantity);
    const bool fine = chart.against == Against::finest;
    const auto text = [](double value) { return fmt::format("{:.6g}", value); };
    run_gnuplot(std::filesystem::path(request.references_path).parent_path().string() + "/speed.gp",
                {{"style", root + "/reports/style.gp"},
                 {"data", fmt::format("{}/{}.csv", request.out_dir, base)},
                 {"front", fmt::format("{}/{}-front.csv", request.out_dir, base)},
                 {"ylabel", fmt::format("|error of {}| [{}]", symbol, unit)},
                 {"xlow", text(frame.x.low)},
                 {"xhigh", text(frame.x.high)},
                 {"ylow", text(frame.y.low)},
                 {"yhigh", text(frame.y.high)},
                 {"floor_y", std::isfinite(chart.floor(chart.n)) ? text(chart.floor(chart.n)) : ""},
                 {"kinds", list_kinds(chart, frame)}},
                fmt::format("{}/{}.svg", request.out_dir, base));
    const std::string against =
        fine ? fmt::format("against {} ({} {:.4g} {})", request.finest, symbol, chart.reference, unit)
             : fmt::format("against the text ({} {:.4g} {})", symbol, chart.reference, unit);
    return {name,
            fmt::format("{}, {}: {}", symbol, to_text(chart.condition), against),
            fine ? "Bars: the paired difference’s own 95 % interval. Band: differences that scatter hides."
                 : "Band: differences that scatter and the reading of the text’s graph hide.",
            base + ".svg",
            base + ".csv",
            "full"};
}

std::string with_width(double value, double half_width) {
    if (!std::isfinite(value)) return "–";
    const int decimals = value < 10 ? 2 : 1;
    if (!std::isfinite(half_width)) return fmt::format("{:.{}f}", value, decimals);
    return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, half_width, decimals);
}

std::string condition_text(const Point& p) {
    return fmt::format("{} {}, {:g} N, {:g} %", p.condition.wheel, capitalised(p.condition.gravity), p.condition.load_N,
                       p.condition.slip_percent);
}

/// Each step along the fronts against the finest: what the next second buys.
Table front_table(const std::vector<Chart>& charts) {
    Table t;
    t.caption = "What each second buys: the fronts against the finest, cheapest first";
    t.style = "wide";
    t.data_file = "front.csv";
    t.header = {"Condition",     "Quantity", "Variant",       "CPU s a run",
                "Relative cost", "|error|",  "Scatter hides", "Reads"};
    for (const Chart& chart : charts) {
        if (chart.against != Against::finest) continue;
        for (const std::size_t k : chart.front) {
            const Point& p = chart.points[k];
            t.rows.push_back({{condition_text(p), "id"},
                              {fmt::format("{} [{}]", symbol_of(p.quantity), unit_of(p.quantity)), "symbol"},
                              {p.variant, "id"},
                              {fmt::format("{:.3g}", p.work.cpu_s()), "num"},
                              {fmt::format("{:.3g}", p.relative_cost), "num"},
                              {with_width(p.error_fine, p.error_fine_U), "num"},
                              {with_width(chart.floor(p.n), unknown), "num"},
                              {is_hidden(chart, p) ? "more cost buys nothing that these realisations show" : "", ""}});
        }
    }
    return t;
}

/// The same for programs.
std::string fronts_csv(const std::vector<Chart>& charts) {
    std::string text =
        "chapter,wheel,gravity,load_N,slip_percent,quantity,units,variant,changes,n,cpu_s,relative_cost,error_fine,"
        "error_fine_U,scatter_hides,reads\n";
    for (const Chart& chart : charts) {
        if (chart.against != Against::finest) continue;
        for (const std::size_t k : chart.front) {
            const Point& p = chart.points[k];
            text +=
                csv_line({std::to_string(p.chapter), p.condition.wheel, p.condition.gravity,
                          format_number(p.condition.load_N), format_number(p.condition.slip_percent), p.quantity,
                          unit_of(p.quantity), p.variant, p.changes, std::to_string(p.n), format_number(p.work.cpu_s()),
                          format_number(p.relative_cost), format_number(p.error_fine), format_number(p.error_fine_U),
                          format_number(chart.floor(p.n)), is_hidden(chart, p) ? "hidden" : "seen"});
        }
    }
    return text;
}

Table points_table(const std::vector<Point>& points) {
    Table t;
    t.caption = "All points";
    t.style = "wide";
    t.data_file = "points.csv";
    t.header = {"Condition", "Quantity", "Variant",         "Change",        "n",      "Relative cost",
                "Value",     "Scatter",  "Error to finest", "Error to text", "Stopped"};
    for (const Point& p : points) {
        const auto number = [](double v) { return Cell{std::isfinite(v) ? fmt::format("{:.3g}", v) : "–", "num"}; };
        t.rows.push_back({{condition_text(p), "id"},
                          {fmt::format("{} [{}]", symbol_of(p.quantity), unit_of(p.quantity)), "symbol"},
                          {p.variant, "id"},
                          {p.changes, ""},
                          {std::to_string(p.n), "num"},
                          number(p.relative_cost),
                          number(p.value),
                          number(p.scatter),
                          {with_width(p.error_fine, p.error_fine_U), "num"},
                          number(p.error_text),
                          {p.stopped, ""}});
    }
    return t;
}

/// Is the finest converged? Its difference to the variant next to it in cost, quantity by quantity.
std::vector<std::string> convergence_lines(const std::vector<Chart>& charts, const std::string& finest) {
    std::vector<std::string> lines;
    for (const Chart& chart : charts) {
        if (chart.against != Against::finest) continue;
        const Point* nearest = nullptr;
        for (const Point& p : chart.points)
            if (p.changes.starts_with("time_step_s") && p.changes.find(',') == std::string::npos &&
                std::isfinite(p.error_fine) && (nearest == nullptr || p.relative_cost > nearest->relative_cost))
                nearest = &p;
        if (nearest == nullptr) continue;
        lines.push_back(
            fmt::format("{} at {:g} %: {} differs from {} by {} {}; scatter hides up to {} {}: {}.",
                        symbol_of(chart.quantity), chart.condition.slip_percent, nearest->variant, finest,
                        with_width(nearest->error_fine, nearest->error_fine_U), unit_of(chart.quantity),
                        with_width(chart.floor(nearest->n), unknown), unit_of(chart.quantity),
                        is_hidden(chart, *nearest) ? "no difference is seen" : "not converged by this measure"));
    }
    return lines;
}

BulletList guide(const PointsRequest& request, const PointSet& set) {
    BulletList list;
    list.items = {
        "A point is one variant: one change from the whole scene, its error up, its cost to the right, both "
        "logarithmic. "
        "Lower left is better.",
        fmt::format("Cost: discs × steps of all three stages × the median ns a disc-step of the variant’s own runs, "
                    "which take turns on the machine realisation by realisation. Consolidation and sinkage are counted "
                    "in full for every run, although runs share them."),
        fmt::format("Relative to the text’s scene: its discs and its time step over the time that {} simulates, at "
                    "that variant’s ns. "
                    "Where {} has other discs or another step this is extrapolated: steps × discs × ns.",
                    request.finest, request.finest),
        fmt::format("Error against {}: the mean difference over realisations of the same packing seed and lug phase, "
                    "without its sign. {} itself has none and is not drawn there.",
                    request.finest, request.finest),
        "The grey band is where scatter rules: a mean difference inside it cannot be told from none with as many "
        "realisations as the finest has (Student’s t on the scatter that all variants share). Hollow points lie in it; "
        "those of fewer realisations (n in the table) have a band √n wider of their own. They are not better the lower "
        "they lie.",
        "The line is the Pareto front: no point is both cheaper and less wrong. It counts what lies in the band as the "
        "band’s edge, so it ends at the cheapest point inside. To the right of that end a second buys nothing but "
        "certainty: more realisations, not a finer model.",
        "Crosses on the upper edge: runs that a health check stopped, at the cost they would have had (the whole "
        "scene’s ns). "
        "The "
        "table gives the check’s words.",
        "window…cm: the whole scene’s own runs averaged elsewhere; the cost is that of a travel to the window’s end.",
    };
    for (const ModelWithoutRuns& model : request.models)
        list.items.push_back(fmt::format("{}: {}.", model.variant, model.changes));
    for (const auto& [slip, work] : set.fidelity)
        list.items.push_back(fmt::format("Cost 1 at {:g} % slip: {:.3g} disc-steps × {:.3g} ns = {:.3g} CPU s a run.",
                                         slip, work.disc_steps, work.ns_per_disc_step, work.cpu_s()));
    return list;
}

Document compose(const PointsRequest& request, const PointSet& set, FigureGroup figures) {
    const auto stopped = std::ranges::count_if(set.points, [](const Point& p) { return !p.stopped.empty(); });
    Document d;
    d.title = request.title.empty() ? "Speed against accuracy" : request.title;
    d.subtitle = "What a run costs and how wrong it is, variant by variant, with ifedem.";
    d.first_line = fmt::format("{} points, {} of them stopped by a health check.", set.points.size(), stopped);
    d.sections.push_back({"reading", "How to read it", {guide(request, set)}});
    d.sections.push_back({"buys", "What each second buys", {front_table(set.charts)}});
    d.sections.push_back({"converged",
                          fmt::format("Is {} converged?", request.finest),
                          {BulletList{convergence_lines(set.charts, request.finest)}}});
    d.sections.push_back({"figures", "Figures", {std::move(figures)}});
    d.sections.push_back({"points", "Points", {points_table(set.points)}});
    if (!request.command.empty())
        d.sections.push_back({"how", "How this was made", {BulletList{{fmt::format("Command: {}", request.command)}}}});
    return d;
}

}  // namespace

void write_points(const PointsRequest& request) {
    const std::string root = find_root(request.references_path);
    const PointSet set = measure_points(request, read_ledger(root));
    write_text(request.out_dir + "/points.csv", points_to_csv(set.points));
    write_text(request.out_dir + "/front.csv", fronts_csv(set.charts));
    FigureGroup figures;
    for (const Chart& chart : set.charts) figures.figures.push_back(draw_chart(chart, request, root));
    const Document document = compose(request, set, std::move(figures));
    write_text(request.out_dir + "/report.md", to_markdown(document));
    write_html(document, request.out_dir, root + "/reports/templates");
}

}  // namespace ifedem

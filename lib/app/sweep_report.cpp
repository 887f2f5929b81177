#include "app/sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "app/picture.hpp"
#include "app/share.hpp"
#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/gnuplot.hpp"
#include "core/error.hpp"
#include "record/files.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

/// A curve of the report.
struct Curve {
    std::string_view metric;
    const char* title;
    const char* label;  ///< of the axis
    const char* caption;
};
constexpr Curve curves[] = {
    {"net_traction_N", "Net traction", "net traction P_d [N]", "What the wheel can pull, window mean."},
    {"gross_tractive_effort_N", "Gross tractive effort", "gross tractive effort H [N]", "⟨T⟩/⟨r_e⟩."},
    {"sinkage_cm", "Sinkage", "sinkage z [cm]", "Negative downwards, from the hub’s height at the first touch."},
    {"torque_Nm", "Torque", "torque T [N m]", "Clockwise, at the rim."},
};

/// P_d V / (T ω): work out over work in; of a towed wheel, which takes none in, there is none.
double tractive_efficiency(const SweepPoint& point) {
    const RunMetrics& m = point.metrics;
    if (!(m.gross_tractive_effort_N > 0)) return std::numeric_limits<double>::quiet_NaN();
    return m.net_traction_N * (1 - m.measured_slip_percent / 100) / m.gross_tractive_effort_N;
}

/// Over the window, in whole lug pitches.
void measure_point(SweepPoint& point, const std::string& directory) {
    point.metrics = unknown_metrics();
    if (point.status != 0) {
        point.note = point.status == static_cast<int>(ExitCode::health) ? "stopped by a health check"
                                                                        : fmt::format("exit {}", point.status);
        return;
    }
    try {
        const Run run = read_run(directory + "/" + point.name);
        point.metrics = measure(run, sweep_window(point.c));
    } catch (const Error& error) {
        point.note = error.what();
    }
}

std::string make_table(const std::vector<SweepPoint>& points) {
    std::string text = "load_N,slip_percent,run";
    for (const MetricInfo& info : metric_table()) text += fmt::format(",{}", info.name);
    text += ",tractive_efficiency,note\n";
    for (const SweepPoint& point : points) {
        text += fmt::format("{},{},{}", point.load_N, point.slip_percent, csv_cell(point.name));
        for (const MetricInfo& info : metric_table()) text += "," + format_number(point.metrics.*info.member);
        text += "," + format_number(tractive_efficiency(point)) + "," + csv_cell(point.note) + "\n";
    }
    return text;
}

std::string list_loads(const std::vector<SweepPoint>& points) {
    std::string loads;
    for (const SweepPoint& point : points) {
        const std::string load = fmt::format("{}", point.load_N);
        if ((" " + loads + " ").find(" " + load + " ") == std::string::npos) loads += (loads.empty() ? "" : " ") + load;
    }
    return loads;
}

FigureGroup draw_curves(const std::string& directory, const std::vector<SweepPoint>& points) {
    FigureGroup group;
    for (const Curve& curve : curves) {
        const MetricInfo& info = *find_metric(curve.metric);
        const std::string name(curve.metric), base = "figures/" + name;
        std::string data = fmt::format("load_N,slip_percent,{}\n", name);
        bool any = false;
        for (const SweepPoint& point : points) {
            const double value = point.metrics.*info.member;
            any = any || std::isfinite(value);
            data += fmt::format("{},{},{}\n", point.load_N, point.slip_percent,
                                std::isfinite(value) ? format_number(value) : "NaN");
        }
        write_text(directory + "/" + base + ".csv", data);
        if (!any) continue;  // gnuplot has nothing to scale its axes by
        const std::string share = share_directory();
        run_gnuplot(share + "/sweep.gp",
                    {{"style", share + "/style.gp"},
                     {"data", directory + "/" + base + ".csv"},
                     {"ylabel", curve.label},
                     {"loads", list_loads(points)}},
                    directory + "/" + base + ".svg");
        group.figures.push_back({name, curve.title, curve.caption, base + ".svg", base + ".csv", ""});
    }
    return group;
}

/// Since its run was last gone on with.
bool is_drawn(const std::string& run, const char* picture) {
    const std::string path = run + "/" + picture;
    return fs::exists(path) && fs::last_write_time(path) >= fs::last_write_time(run + "/results.h5");
}

FigureGroup draw_runs(const std::string& directory, std::vector<SweepPoint>& points) {
    FigureGroup group;
    for (SweepPoint& point : points) {
        const std::string run = directory + "/" + point.name;
        if (!fs::exists(run + "/results.h5")) continue;
        try {
            if (!is_drawn(run, "contact_sheet.png")) draw_contact_sheet(run, run, DiscColour::speed);
            if (!is_drawn(run, "travel.gif")) draw_animation(run, run, DiscColour::speed);
        } catch (const Error& error) {
            point.note += (point.note.empty() ? "" : "; ") + std::string(error.what());
            continue;
        }
        group.figures.push_back({point.name, fmt::format("{} N, slip {} %", point.load_N, point.slip_percent),
                                 "Moments of the travel, evenly spaced; colour: speed of the soil.",
                                 point.name + "/contact_sheet.png", point.name + "/travel.gif", "full"});
    }
    return group;
}

Table list_runs(const std::vector<SweepPoint>& points) {
    Table table;
    table.style = "wide";
    table.header = {"load [N]", "slip [%]", "P_d [N]", "H [N]", "z [cm]", "T [N m]", "efficiency", "note"};
    table.data_file = "sweep.csv";
    for (const SweepPoint& point : points) {
        const RunMetrics& m = point.metrics;
        const auto number = [](double value, int digits) {
            return Cell{std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "–", "num"};
        };
        table.rows.push_back({{fmt::format("{}", point.load_N), "num"},
                              {fmt::format("{}", point.slip_percent), "num"},
                              number(m.net_traction_N, 1),
                              number(m.gross_tractive_effort_N, 1),
                              number(m.sinkage_cm, 2),
                              number(m.torque_Nm, 2),
                              number(tractive_efficiency(point), 2),
                              {point.note, ""}});
    }
    return table;
}

Document compose(const std::string& directory, std::vector<SweepPoint>& points, const std::string& command) {
    const auto complete =
        static_cast<std::size_t>(std::ranges::count_if(points, [](const SweepPoint& p) { return p.status == 0; }));
    Document d;
    d.title = points.front().c.name;
    d.subtitle = fmt::format("{} runs with ifedem: every load with every slip.", points.size());
    d.first_line = fmt::format("{} of {} runs complete.", complete, points.size());
    FigureGroup lines = draw_curves(directory, points), runs = draw_runs(directory, points);
    d.sections.push_back({"curves", "Curves", {lines}});
    d.sections.push_back({"runs", "Runs", {list_runs(points), runs}});
    d.sections.push_back(
        {"how",
         "How this was made",
         {BulletList{
             {fmt::format("Command: {}", command),
              fmt::format("Numbers are means over the last half of the travel ({:g} m of {:g} m), cut to whole "
                          "pitches of lug pairs.",
                          0.5 * points.front().c.travel.distance_m, points.front().c.travel.distance_m),
              "One realisation each: another bed.seed gives other numbers; their scatter is the uncertainty.",
              "Each run’s directory holds its case with every key, series.csv, results.h5 and ParaView files."}}}});
    std::erase_if(d.sections, [](const Section& s) { return s.blocks.empty(); });
    return d;
}

}  // namespace

Window sweep_window(const Case& c) { return {0.5 * c.travel.distance_m, c.travel.distance_m}; }

void write_sweep_report(const std::string& directory, std::vector<SweepPoint>& points, const std::string& command) {
    for (SweepPoint& point : points) measure_point(point, directory);
    write_file_atomically(directory + "/sweep.csv", make_table(points));  // whether or not pictures can be drawn
    const Document document = compose(directory, points, command);
    write_html(document, directory, share_directory() + "/templates");
}

}  // namespace ifedem

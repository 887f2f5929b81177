#include "check/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "check/csv.hpp"
#include "check/effects.hpp"
#include "check/figure_data.hpp"
#include "check/gnuplot.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

/// One line of figures.csv.
struct FigureRow {
    std::string name, script, data, metric, series, title, ylabel, caption, style;
};

std::vector<FigureRow> read_rows(const std::string& path) {
    const CsvTable t = read_csv(path);
    std::vector<FigureRow> rows;
    for (const auto& row : t.rows) {
        const auto cell = [&](const char* name) { return row.cells[t.require(name)]; };
        rows.push_back({cell("name"), cell("script"), cell("data"), cell("metric"), cell("series"), cell("title"),
                        cell("ylabel"), cell("caption"), cell("style")});
    }
    return rows;
}

/// The chapter's own figures, then those of its folders that have some; their scripts stand beside them.
std::vector<FigureRow> read_all_rows(const std::string& chapter) {
    std::vector<FigureRow> rows = read_rows(chapter + "/figures.csv");
    std::vector<std::string> folders;
    for (const auto& entry : fs::directory_iterator(chapter))
        if (fs::exists(entry.path() / "figures.csv")) folders.push_back(entry.path().filename().string());
    std::sort(folders.begin(), folders.end());
    for (const auto& folder : folders) {
        for (FigureRow row : read_rows(fmt::format("{}/{}/figures.csv", chapter, folder))) {
            if (row.data != "snapshot") row.script = folder + "/" + row.script;
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

using Variables = std::vector<std::pair<std::string, std::string>>;

Figure start_figure(const FigureRow& row, const std::string& image_ending) {
    Figure f;
    f.name = row.name;
    f.title = row.title;
    f.caption = row.caption;
    f.style = row.style;
    f.image = fmt::format("figures/{}.{}", row.name, image_ending);
    f.data = fmt::format("figures/{}.csv", row.name);
    return f;
}

/// "fit", "run" and so on: the curves that have such lines, so that a script loops over what is
/// there.
void name_curves(const std::string& data, const std::vector<CurveName>& curves, Variables& variables) {
    for (const char* kind : {"fit", "run", "mean", "text", "above", "below", "label"}) {
        std::string names;
        for (const auto& name : curves)
            if (data.find(fmt::format("\n{},{},", to_word(name.curve), kind)) != std::string::npos)
                names += to_word(name.curve) + " ";
        variables.emplace_back(kind, names);
    }
}

std::string verdicts_present(const std::vector<Outcome>& outcomes) {
    std::string names;
    for (int k = 0; k < verdict_count; ++k) {
        const auto verdict = static_cast<Verdict>(k);
        const bool occurs = std::any_of(outcomes.begin(), outcomes.end(), [&](const Outcome& o) {
            return o.verdict == verdict && o.claim.comparison == Comparison::equal && o.error_over_tolerance;
        });
        if (occurs) names += std::string(to_text(verdict)) + " ";
    }
    return names;
}

/// The file that a directory of the report holds, "" if none does.
std::string find_file(const FigureRow& row, const Campaign& campaign) {
    for (const auto& name : campaign.directories) {
        const fs::path directory = fs::path(name).lexically_normal();
        const fs::path last = directory.has_filename() ? directory.filename() : directory.parent_path().filename();
        if (!row.metric.empty() && last != row.metric) continue;
        if (fs::exists(directory / row.series)) return (directory / row.series).string();
    }
    return {};
}

std::optional<std::string> line_data(const FigureRow& row, const Campaign& campaign,
                                     const std::vector<Outcome>& outcomes, Variables& variables) {
    if (row.data == "slip" || row.data == "measured-slip") {
        std::vector<CurveName> curves;
        for (const auto& part : split(row.series, '|')) curves.push_back(parse_curve(part));
        const auto axis = row.data == "slip" ? SlipAxis::set : SlipAxis::measured;
        auto data = slip_data(campaign, outcomes, row.metric, curves, axis);
        if (data) name_curves(*data, curves, variables);
        return data;
    }
    if (row.data == "effects") {
        const CurveName name = parse_curve(row.series);
        return effects_data(campaign.effects, name.curve.gravity, name.slip_percent);
    }
    if (row.data == "stiffness") return stiffness_data(campaign);
    if (row.data == "agreement") {
        variables.emplace_back("verdicts", verdicts_present(outcomes));
        return agreement_data(outcomes);
    }
    if (row.data == "file") {
        const std::string path = find_file(row, campaign);
        return path.empty() ? std::nullopt : std::optional(read_text(path));
    }
    if (row.data != "series")
        fail_input(fmt::format(
            "figures.csv: data '{}' of {} is not known. Use slip, measured-slip, series, snapshot, stiffness, effects, "
            "file or agreement?",
            row.data, row.name));
    const auto* run = find_run(campaign, parse_curve(row.series));
    if (!run) return std::nullopt;
    const auto& m = run->metrics;
    variables.insert(variables.end(), {{"run", run->run.name},
                                       {"window_from", format_number(100 * m.window.from_m)},
                                       {"window_to", format_number(100 * m.window.to_m)},
                                       {"torque", format_number(m.torque_Nm)},
                                       {"pull", format_number(m.net_traction_N)},
                                       {"sinkage", format_number(m.sinkage_cm)}});
    return series_data(*run);
}

/// Any realisation will do for a picture; the first one that drew one is shown. Its data are the run's own results.
std::optional<Figure> copy_snapshot(const FigureRow& row, const ReportPaths& paths, const Campaign& campaign) {
    const auto* first = find_run(campaign, parse_curve(row.series));
    if (!first) return std::nullopt;
    for (const auto& run : campaign.runs) {
        const fs::path picture = fs::path(run.run.directory) / row.script;
        if (run.condition != first->condition || !fs::exists(picture)) continue;
        Figure figure = start_figure(row, "png");
        figure.data.clear();
        figure.caption += fmt::format(" Run {}.", run.run.name);
        fs::copy_file(picture, paths.out + "/" + figure.image, fs::copy_options::overwrite_existing);
        return figure;
    }
    return std::nullopt;
}

std::optional<Figure> copy_picture(const FigureRow& row, const ReportPaths& paths, const Campaign& campaign) {
    const std::string path = find_file(row, campaign);
    if (path.empty()) return std::nullopt;
    Figure figure = start_figure(row, path.substr(path.size() - 3));
    figure.data.clear();
    fs::copy_file(path, paths.out + "/" + figure.image, fs::copy_options::overwrite_existing);
    return figure;
}

std::optional<Figure> draw_lines(const FigureRow& row, const ReportPaths& paths, const Campaign& campaign,
                                 const std::vector<Outcome>& outcomes) {
    // Thousands of circles would be megabytes of lines.
    Figure figure = start_figure(row, row.style.ends_with("discs") ? "png" : "svg");
    const std::string data_path = paths.out + "/" + figure.data;
    Variables variables{{"style", paths.style}, {"data", data_path}, {"ylabel", row.ylabel}};
    const auto data = line_data(row, campaign, outcomes, variables);
    if (!data) return std::nullopt;
    write_text(data_path, *data);
    run_gnuplot(paths.chapter + "/" + row.script, variables, paths.out + "/" + figure.image);
    return figure;
}

}  // namespace

std::vector<Figure> draw_figures(const ReportPaths& paths, const Campaign& campaign,
                                 const std::vector<Outcome>& outcomes) {
    std::vector<Figure> figures;
    fs::create_directories(fs::path(paths.out) / "figures");
    for (const auto& row : read_all_rows(paths.chapter)) {
        const bool is_picture = row.data == "file" && (row.series.ends_with(".png") || row.series.ends_with(".gif"));
        const auto figure = row.data == "snapshot" ? copy_snapshot(row, paths, campaign)
                            : is_picture           ? copy_picture(row, paths, campaign)
                                                   : draw_lines(row, paths, campaign, outcomes);
        if (figure) figures.push_back(*figure);
    }
    return figures;
}

}  // namespace ifedem

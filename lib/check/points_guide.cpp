#include "check/points_guide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "check/csv.hpp"
#include "check/document.hpp"
#include "check/points.hpp"
#include "check/run.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

namespace fs = std::filesystem;

std::string cell(const CsvTable& table, const CsvRow& row, const char* column) {
    return row.cells[table.require(column)];
}

/// Do two lines speak of the same quantity under the same condition?
bool is_same_chart(const CsvTable& a, const CsvRow& x, const CsvTable& b, const CsvRow& y) {
    return std::ranges::all_of(std::array{"chapter", "wheel", "gravity", "load_N", "slip_percent", "quantity"},
                               [&](const char* column) { return cell(a, x, column) == cell(b, y, column); });
}

std::string shorter(const std::string& number) {
    const auto value = parse_number(number);
    return value ? fmt::format("{:.3g}", *value) : "–";
}

/// How many times cheaper than another cost.
std::string times(double cost, const std::string& other) {
    const auto value = parse_number(other);
    return value ? fmt::format("{:.3g}", *value / cost) : "–";
}

std::string condition_of_row(const CsvTable& t, const CsvRow& row) {
    return fmt::format("Chapter {}: {} {}, {} N, {} %", cell(t, row, "chapter"), cell(t, row, "wheel"),
                       capitalised(cell(t, row, "gravity")), cell(t, row, "load_N"), cell(t, row, "slip_percent"));
}

std::string symbol_of_row(const CsvTable& t, const CsvRow& row) {
    const auto quantity = std::ranges::find(point_quantities(), cell(t, row, "quantity"), &Quantity::name);
    if (quantity == point_quantities().end())
        fail_input(fmt::format("{}:{}: {} is no quantity of a point. Make it anew?", t.path, row.line,
                               cell(t, row, "quantity")));
    return fmt::format("{} [{}]", quantity->symbol, quantity->unit);
}

/// The end of each front: past it a second buys nothing that the realisations show.
void add_ends(const std::string& directory, const std::string& link, const std::string& plain, Table& t) {
    const CsvTable front = read_csv(directory + "/front.csv"), points = read_csv(directory + "/points.csv");
    for (std::size_t k = 0; k < front.rows.size(); ++k) {
        const CsvRow& row = front.rows[k];
        if (k + 1 < front.rows.size() && is_same_chart(front, row, front, front.rows[k + 1])) continue;
        const auto start = std::ranges::find_if(
            front.rows, [&](const CsvRow& other) { return is_same_chart(front, row, front, other); });
        const auto standard = std::ranges::find_if(points.rows, [&](const CsvRow& other) {
            return is_same_chart(front, row, points, other) && cell(points, other, "variant") == plain;
        });
        const double cost = parse_number(cell(front, row, "relative_cost")).value_or(unknown);
        t.rows.push_back(
            {{condition_of_row(front, row), "id", link},
             {symbol_of_row(front, row), "symbol"},
             {fmt::format("{} ({} s)", cell(front, *start, "variant"), shorter(cell(front, *start, "cpu_s"))), "id"},
             {shorter(cell(front, *start, "error_fine")), "num"},
             {fmt::format("{} ({} s)", cell(front, row, "variant"), shorter(cell(front, row, "cpu_s"))), "id"},
             {shorter(cell(front, row, "error_fine")), "num"},
             {shorter(cell(front, row, "scatter_hides")), "num"},
             {standard == points.rows.end() ? "–" : times(cost, cell(points, *standard, "relative_cost")), "num"},
             {times(cost, "1"), "num"},
             {cell(front, row, "reads") == "hidden" ? "" : "above scatter", ""}});
    }
}

Section how_to_read() {
    return {"reading",
            "How to read the charts",
            {BulletList{{
                "Each chapter has a page of its own with a figure a quantity and condition: cost to the right, error "
                "up, both logarithmic; a point is one change from the chapter’s whole scene. Lower left is better.",
                "Follow the line, the Pareto front, from the left: each corner is the next variant that a longer run "
                "buys, and how much smaller the error becomes by it.",
                "Where the line enters the grey band it ends. There scatter rules: packings and lug phases move the "
                "quantity more than the model does. Whoever needs less error than that needs more realisations: four "
                "times as many halve the band.",
                "A cheap point inside the band is not proved right. It is not told from the finest with these "
                "realisations, and for this quantity alone: take what holds for all quantities that matter.",
                "Errors against the finest say what the model’s resolution does. Errors against the text say how far "
                "model and text are apart; where these do not fall with cost, resolution is not the cause.",
                "A cross on the upper edge is a run that a health check stopped: beyond a limit of the step.",
            }}}};
}

Document compose(const GuideRequest& request) {
    Document d;
    d.title = "Speed against accuracy: what each second buys";
    d.subtitle = "One page over the charts of all chapters, with ifedem.";
    Table ends;
    ends.caption =
        "The two ends of each front: the cheapest variant of all, and the cheapest that cannot be told from the "
        "finest. "
        "Times are CPU s a run, all stages counted";
    ends.style = "wide";
    ends.data_file = "points.csv";
    ends.header = {"Condition",        "Quantity",  "Cheapest",      "Its error",
                   "End of the front", "Its error", "Scatter hides", "Whole scene’s cost over this",
                   "Text’s over this", "Reads"};
    std::size_t points = 0;
    for (const std::string& directory : request.point_dirs) {
        const std::string link = fs::relative(directory, request.out_dir).generic_string() + "/index.html";
        add_ends(directory, link, request.plain, ends);
        points += read_csv(directory + "/points.csv").rows.size();
    }
    d.first_line = fmt::format("{} points of {} chapters.", points, request.point_dirs.size());
    d.sections.push_back(how_to_read());
    d.sections.push_back({"buys", "What each second buys", {std::move(ends)}});
    if (!request.command.empty())
        d.sections.push_back({"how", "How this was made", {BulletList{{fmt::format("Command: {}", request.command)}}}});
    return d;
}

std::string join_points(const std::vector<std::string>& directories) {
    std::string text;
    for (const std::string& directory : directories) {
        const std::string part = read_text(directory + "/points.csv");
        text += text.empty() ? part : part.substr(part.find('\n') + 1);
    }
    return text;
}

}  // namespace

void write_points_guide(const GuideRequest& request) {
    const Document document = compose(request);
    write_text(request.out_dir + "/points.csv", join_points(request.point_dirs));
    write_text(request.out_dir + "/report.md", to_markdown(document));
    write_html(document, request.out_dir, request.templates);
}

}  // namespace ifedem

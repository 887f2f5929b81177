#include "check/snapshot.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

double number(const CsvTable& table, const CsvRow& row, std::size_t column) {
    const auto value = parse_number(row.cells[column]);
    if (!value)
        fail_input(
            fmt::format("{}:{}: '{}' is not a number. Run the case again.", table.path, row.line, row.cells[column]));
    return *value;
}

}  // namespace

void write_snapshot(const std::string& run_directory, const Snapshot& snapshot) {
    // Micrometres are enough for a picture, and keep the file small.
    std::string discs = "x_m,y_m,radius_m,speed_m_s\n";
    for (const auto& d : snapshot.discs)
        discs += fmt::format("{:.6f},{:.6f},{:.6f},{:.3g}\n", d.centre_m.x, d.centre_m.y, d.radius_m, d.speed_m_s);
    std::string wheel = "element,x_m,y_m\n";
    for (std::size_t e = 0; e < snapshot.elements.size(); ++e) {
        if (e > 0) wheel += '\n';  // an empty line ends a polygon for gnuplot
        for (const auto& corner : snapshot.elements[e])
            wheel += fmt::format("{},{:.6f},{:.6f}\n", e, corner.x, corner.y);
    }
    write_text(run_directory + "/snapshot_discs.csv", discs);
    write_text(run_directory + "/snapshot_wheel.csv", wheel);
}

std::optional<Snapshot> read_snapshot(const std::string& run_directory) {
    const std::string discs_path = run_directory + "/snapshot_discs.csv";
    const std::string wheel_path = run_directory + "/snapshot_wheel.csv";
    if (!std::filesystem::exists(discs_path) || !std::filesystem::exists(wheel_path)) return std::nullopt;
    Snapshot snapshot;
    const CsvTable discs = read_csv(discs_path);
    for (const auto& row : discs.rows)
        snapshot.discs.push_back(
            {{number(discs, row, 0), number(discs, row, 1)}, number(discs, row, 2), number(discs, row, 3)});
    const CsvTable wheel = read_csv(wheel_path);
    std::string element;
    for (const auto& row : wheel.rows) {
        if (snapshot.elements.empty() || row.cells[0] != element) snapshot.elements.emplace_back();
        element = row.cells[0];
        snapshot.elements.back().push_back({number(wheel, row, 1), number(wheel, row, 2)});
    }
    return snapshot;
}

}  // namespace ifedem

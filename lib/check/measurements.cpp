#include "check/measurements.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

/// Nine digits of the value: what an identity is off by lies far behind its sixth.
std::string value_text(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string(); }

}  // namespace

std::string measurements_csv(std::span<const Measurement> measurements) {
    std::string text = csv_line({"name", "value", "units", "scatter", "n", "note", "uncertainty"});
    for (const Measurement& m : measurements)
        text += csv_line({m.name, value_text(m.value), m.units, format_number(m.scatter), std::to_string(m.n), m.note,
                          m.uncertainty ? format_number(*m.uncertainty) : ""});
    return text;
}

std::vector<Measurement> read_measurements(const std::string& path) {
    const CsvTable table = read_csv(path);
    const auto uncertainty = table.find("uncertainty");
    std::vector<Measurement> measurements;
    for (const auto& row : table.rows) {
        const std::size_t n = count_of(table, row, "n");
        if (n < 1)
            fail_input(fmt::format("{}:{}: n is below 1. Write the number of realisations?", table.path, row.line));
        measurements.push_back(
            {row.cells[table.require("name")], number_of(table, row, "value"), row.cells[table.require("units")],
             row.cells[table.require("scatter")].empty() ? 0 : number_of(table, row, "scatter"), n,
             row.cells[table.require("note")], uncertainty ? parse_number(row.cells[*uncertainty]) : std::nullopt});
    }
    return measurements;
}

}  // namespace ifedem

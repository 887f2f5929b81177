#include "check/ledger.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {

std::optional<double> LedgerRow::number() const { return parse_number(value); }

bool LedgerRow::needs_verdict() const {
    return kind == "result" || kind == "ratio" || kind == "experiment" || kind == "qualitative";
}

namespace {

void add_rows(const std::string& path, Ledger& ledger) {
    const CsvTable table = read_csv(path);
    const auto column = [&](const char* name) { return table.require(name); };
    const auto id = column("id"), quantity = column("quantity"), symbol = column("symbol"), value = column("value"),
               units = column("units"), condition = column("condition"), source = column("source"),
               kind = column("kind");
    for (const auto& row : table.rows) {
        LedgerRow entry{row.cells[id],
                        static_cast<int>(count_of(table, row, "chapter")),
                        row.cells[quantity],
                        row.cells[symbol],
                        row.cells[value],
                        row.cells[units],
                        row.cells[condition],
                        row.cells[source],
                        count_of(table, row, "line"),
                        row.cells[kind]};
        if (!ledger.emplace(row.cells[id], std::move(entry)).second)
            fail_input(
                fmt::format("{}:{}: the id {} stands twice. Give each row its own?", path, row.line, row.cells[id]));
    }
}

}  // namespace

Ledger read_ledger(const std::string& root) {
    const auto folder = std::filesystem::path(root) / "reference_data";
    Ledger ledger;
    add_rows((folder / "dissertation.csv").string(), ledger);
    if (std::filesystem::exists(folder / "external.csv")) add_rows((folder / "external.csv").string(), ledger);
    return ledger;
}

std::string source_text(const LedgerRow& row) {
    return row.line == 0 ? row.source : fmt::format("{}, line {}", row.source, row.line);
}

double reading_uncertainty(const std::string& printed, const std::string& units, const std::string& gravity) {
    if (units == "N" && gravity == "earth") return 1.0;
    if (units == "N" && gravity == "mars") return 0.5;
    if (units == "cm") return 0.125;
    const auto point = printed.find('.');
    const auto digits = point == std::string::npos ? 0 : printed.size() - point - 1;
    return 0.5 * std::pow(10.0, -static_cast<double>(digits));
}

}  // namespace ifedem

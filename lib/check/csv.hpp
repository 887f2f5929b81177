#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ifedem {

struct CsvRow {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<std::string> cells;
};

/// A comma-separated table with one header line; cells may stand in double quotes (RFC 4180).
struct CsvTable {
    std::string path;
    std::vector<std::string> header;
    std::vector<CsvRow> rows;

    /// Column number, or nothing.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
    /// Throws Error(bad_input) naming the file if the column is missing.
    [[nodiscard]] std::size_t require(std::string_view column) const;
};

/// Throws Error(bad_input), "file:line: what is wrong. What to do?", for ragged rows or an open quote.
[[nodiscard]] CsvTable parse_csv(const std::string& text, const std::string& path);

/// Throws Error(io) if the file cannot be read.
[[nodiscard]] CsvTable read_csv(const std::string& path);

/// The whole file. Throws Error(io).
[[nodiscard]] std::string read_text(const std::string& path);

/// Creates the directories above; the file appears whole or not at all. Throws Error(io).
void write_text(const std::string& path, const std::string& text);

/// A cell as it stands in a file: in quotes only if it has to be.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// One line with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

/// The whole text as a number, whatever the locale; nothing if it is not one.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// A row's number in a column; infinite where the cell is empty or no number: what is not known, such as the half-width
/// of a single run. Throws Error(bad_input) if the column is missing.
[[nodiscard]] double number_or_infinity(const CsvTable& table, const CsvRow& row, std::string_view column);

/// A row's number in a column. Throws Error(bad_input) if it is none or the column is missing.
[[nodiscard]] double number_of(const CsvTable& table, const CsvRow& row, std::string_view column);

/// A row's count in a column, 0 where the cell is empty. Throws Error(bad_input) if it is no whole number.
[[nodiscard]] std::size_t count_of(const CsvTable& table, const CsvRow& row, std::string_view column);

/// Six significant digits; an empty cell for what is not finite.
[[nodiscard]] std::string format_number(double value);

[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

}  // namespace ifedem

#include "check/csv.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/error.hpp"

namespace ifedem {
namespace {

/// Reads one record from `at` on, over line ends inside quotes; counts the lines it passes.
std::vector<std::string> take_record(const std::string& text, std::size_t& at, std::size_t& line,
                                     const std::string& path) {
    std::vector<std::string> cells(1);
    const std::size_t first = line;
    bool quoted = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '\n') ++line;
        if (quoted) {
            if (c != '"') {
                cells.back() += c;
            } else if (at + 1 < text.size() && text[at + 1] == '"') {
                cells.back() += text[++at];
            } else {
                quoted = false;
            }
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            cells.emplace_back();
        } else if (c == '\n') {
            ++at;
            break;
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    if (quoted) fail_input(fmt::format("{}:{}: a quote is opened and never closed. Close it?", path, first));
    return cells;
}

}  // namespace

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
    for (std::size_t k = 0; k < header.size(); ++k)
        if (header[k] == column) return k;
    return std::nullopt;
}

std::size_t CsvTable::require(std::string_view column) const {
    const auto k = find(column);
    if (!k) fail_input(fmt::format("{}:1: the column '{}' is missing. Add it to the header?", path, column));
    return *k;
}

CsvTable parse_csv(const std::string& text, const std::string& path) {
    CsvTable table;
    table.path = path;
    std::size_t at = 0;
    std::size_t line = 1;
    while (at < text.size()) {
        const std::size_t first = line;
        auto cells = take_record(text, at, line, path);
        if (cells.size() == 1 && cells[0].empty()) continue;
        if (table.header.empty()) {
            table.header = std::move(cells);
            continue;
        }
        if (cells.size() != table.header.size())
            fail_input(fmt::format("{}:{}: {} cells where the header has {}. Add or quote the missing ones?", path,
                                   first, cells.size(), table.header.size()));
        table.rows.push_back({first, std::move(cells)});
    }
    if (table.header.empty()) fail_input(fmt::format("{}:1: the file is empty. Give it a header line?", path));
    return table;
}

CsvTable read_csv(const std::string& path) { return parse_csv(read_text(path), path); }

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf()))
        fail_io(fmt::format("Cannot read {} (missing, empty or not permitted). Check the path?", path));
    return std::move(text).str();
}

void write_text(const std::string& path, const std::string& text) {
    const std::filesystem::path target(path);
    std::error_code ignored;
    if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path(), ignored);
    const std::string temporary = path + ".tmp";  // a reader never sees half a table
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    std::error_code fault;
    if (file) std::filesystem::rename(temporary, target, fault);
    if (!file || fault)
        fail_io(fmt::format("Cannot write {} (no such directory, no space or not permitted). Check the path?", path));
}

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        if (k > 0) line += ',';
        line += csv_cell(cells[k]);
    }
    return line + '\n';
}

std::optional<double> parse_number(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

double number_or_infinity(const CsvTable& table, const CsvRow& row, std::string_view column) {
    return parse_number(row.cells[table.require(column)]).value_or(std::numeric_limits<double>::infinity());
}

double number_of(const CsvTable& table, const CsvRow& row, std::string_view column) {
    const auto value = parse_number(row.cells[table.require(column)]);
    if (!value)
        fail_input(
            fmt::format("{}:{}: {} is not a number. Write one, or make the file anew?", table.path, row.line, column));
    return *value;
}

std::size_t count_of(const CsvTable& table, const CsvRow& row, std::string_view column) {
    const std::string& cell = row.cells[table.require(column)];
    if (cell.empty()) return 0;
    constexpr double most = 1e9;  // far from where a cast to std::size_t would not be defined
    const auto value = parse_number(cell);
    if (!value || !(*value >= 0 && *value <= most) || *value != std::floor(*value))
        fail_input(
            fmt::format("{}:{}: {} = {} is no count. Write a whole number?", table.path, row.line, column, cell));
    return static_cast<std::size_t>(*value);
}

std::string format_number(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string(); }

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

}  // namespace ifedem

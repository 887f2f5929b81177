#include "check/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "check/csv.hpp"
#include "core/error.hpp"

namespace ifedem {
namespace {

bool is_near(double a, double b) { return std::abs(a - b) <= 5e-3 * std::abs(b); }

std::string wheel_name(const WheelCase& wheel) {
    if (wheel.shape == WheelShape::plate) return "plate";
    if (wheel.body == WheelBody::rigid) return "rigid";
    if (wheel.lug_pairs == 0) return "tyre";
    if (is_near(wheel.intermediate.young_Pa, 0.05e6)) return "B3";
    if (is_near(wheel.intermediate.young_Pa, 0.3e6)) return "B6";
    return "other";
}

std::string gravity_name(double gravity_m_s2) {
    if (is_near(gravity_m_s2, 9.81)) return "earth";
    if (is_near(gravity_m_s2, 3.71)) return "mars";
    return fmt::format("{:g} m/s²", gravity_m_s2);
}

Series read_travel(const std::string& path) {
    const CsvTable table = read_csv(path);
    const std::size_t stage = table.require("stage");
    Series series;
    for (std::size_t k = 0; k < table.header.size(); ++k) {
        if (k == stage) continue;
        std::vector<double> column;
        for (const auto& row : table.rows) {
            if (row.cells[stage] != "travel") continue;
            const auto value = parse_number(row.cells[k]);
            if (!value)
                fail_input(fmt::format("{}:{}: '{}' in column {} is not a number. Run the case again with --force?",
                                       path, row.line, row.cells[k], table.header[k]));
            column.push_back(*value);
        }
        series.emplace(table.header[k], std::move(column));
    }
    return series;
}

}  // namespace

std::string find_value(const std::vector<RunValue>& values, const std::string& name) {
    const auto found = std::ranges::find(values, name, &RunValue::name);
    return found == values.end() ? std::string() : found->value;
}

std::string Run::text(const std::string& value_name) const { return find_value(values, value_name); }

double Run::number(const std::string& value_name) const {
    const auto value = parse_number(text(value_name));
    if (!value)
        fail_input(fmt::format("{}/run.csv: there is no number {} in it. Run the case anew?", directory, value_name));
    return *value;
}

bool is_same_realisation(const Case& a, const Case& b) {
    return a.gravity_m_s2 == b.gravity_m_s2 && a.wheel.load_N == b.wheel.load_N &&
           a.travel.slip_percent == b.travel.slip_percent && a.bed.seed == b.bed.seed &&
           a.wheel.lug_phase_deg == b.wheel.lug_phase_deg;
}

Condition condition_of(const Case& c) {
    return {wheel_name(c.wheel), gravity_name(c.gravity_m_s2), c.wheel.load_N, c.travel.slip_percent};
}

std::string capitalised(std::string word) {
    if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    return word;
}

std::string to_text(const Condition& condition) {
    return fmt::format("{}, {}, {:g} N, slip {:g} %", condition.wheel, capitalised(condition.gravity), condition.load_N,
                       condition.slip_percent);
}

std::string to_csv(const std::vector<RunValue>& values) {
    std::string text = csv_line({"name", "value", "unit"});
    for (const RunValue& v : values) text += csv_line({v.name, v.value, v.unit});
    return text;
}

std::vector<RunValue> read_values(const std::string& path) {
    const CsvTable table = read_csv(path);
    const std::size_t name = table.require("name");
    const std::size_t value = table.require("value");
    const std::size_t unit = table.require("unit");
    std::vector<RunValue> values;
    for (const auto& row : table.rows) values.push_back({row.cells[name], row.cells[value], row.cells[unit]});
    return values;
}

Run read_run(const std::string& directory) {
    const std::filesystem::path path = std::filesystem::path(directory).lexically_normal();
    Run run;
    run.directory = directory;
    run.name = (path.has_filename() ? path : path.parent_path()).filename().string();
    run.c = read_case((path / "case.toml").string());
    run.travel = read_travel((path / "series.csv").string());
    run.values = read_values((path / "run.csv").string());
    return run;
}

}  // namespace ifedem

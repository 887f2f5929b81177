#include "check/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "check/csv.hpp"
#include "check/statistics.hpp"

namespace ifedem {

TargetMatch match_target(const std::vector<double>& values, double target) {
    const PairedDifference d = paired_difference(std::vector<double>(values.size(), target), values);
    TargetMatch m{d.mean, d.half_width, TargetVerdict::cannot_tell};
    if (m.off > m.uncertainty) m.verdict = TargetVerdict::too_high;
    if (m.off < -m.uncertainty) m.verdict = TargetVerdict::too_low;
    if (std::fabs(m.off) <= m.uncertainty && m.uncertainty <= 0.1 * std::fabs(target))
        m.verdict = TargetVerdict::within;
    return m;
}

std::string number_within(double value, double scatter) {
    if (!std::isfinite(value)) return "–";
    if (!(scatter > 0)) return fmt::format("{:.3g}", value);
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(scatter))));
    return fmt::format("{:.{}f}", value, std::min(decimals, 5));
}

std::string signed_within(double value, double scatter) {
    return (value > 0 ? "+" : value < 0 ? "−" : "") + number_within(std::fabs(value), scatter);
}

std::vector<std::string> list_knobs(const std::string& knob_table, const std::string& path,
                                    const std::string& quantity) {
    const CsvTable table = parse_csv(knob_table, path);
    const std::size_t name = table.require("name"), key = table.require("key"), change = table.require("change"),
                      difference = table.require("difference"), half_width = table.require("half_width");
    std::vector<std::pair<double, std::string>> lines;
    for (const CsvRow& row : table.rows) {
        const auto d = parse_number(row.cells[difference]), u = parse_number(row.cells[half_width]);
        if (row.cells[name] != quantity || !d || !u || std::fabs(*d) <= *u) continue;
        const std::string leaf = row.cells[key].substr(row.cells[key].rfind('.') + 1);
        lines.emplace_back(-std::fabs(*d), fmt::format("{} {}: {} ± {}", leaf, row.cells[change], signed_within(*d, *u),
                                                       number_within(*u, *u)));
    }
    std::ranges::stable_sort(lines, {}, &std::pair<double, std::string>::first);
    std::vector<std::string> texts;
    for (const auto& [size, text] : lines) texts.push_back(text);
    return texts;
}

}  // namespace ifedem

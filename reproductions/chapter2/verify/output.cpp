#include "output.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check/csv.hpp"
#include "check/statistics.hpp"

namespace ifedem::chapter2 {

Output::Output(std::string directory) : directory_(std::move(directory)) {}

void Output::add(const std::string& name, double value, const std::string& units, const std::string& note) {
    measured_.push_back({name, value, units, 0, 1, note});
    fmt::print("{:<44} {:>14.8g} {}\n", name, value, units);
}

void Output::add(const std::string& name, std::span<const double> values, const std::string& units,
                 const std::string& note) {
    const double middle = mean(values), scatter = standard_deviation(values);
    measured_.push_back({name, middle, units, scatter, values.size(), note});
    fmt::print("{:<44} {:>14.8g} {} (s {:.3g}, n {})\n", name, middle, units, scatter, values.size());
}

void Output::add_difference(const std::string& name, std::span<const double> values, const std::string& units,
                            const std::string& note) {
    const std::vector<double> zero(values.size(), 0.0);
    const PairedDifference d = paired_difference(zero, values);
    const double scatter = standard_deviation(values);
    measured_.push_back({name, d.mean, units, scatter, d.n, note, d.half_width});
    fmt::print("{:<44} {:>14.8g} {} (± {:.3g}, s {:.3g}, n {})\n", name, d.mean, units, d.half_width, scatter, d.n);
}

void Output::write_table(const std::string& file, const std::string& header,
                         const std::vector<std::vector<std::string>>& rows) const {
    std::string text = header + "\n";
    for (const auto& row : rows) text += csv_line(row);
    write_text(directory_ + "/" + file, text);
}

void Output::finish() const { write_text(directory_ + "/measurements.csv", measurements_csv(measured_)); }

std::string number(double value) { return format_number(value); }

double observed_order(double coarse, double middle, double fine) {
    return std::log2(std::fabs((coarse - middle) / (middle - fine)));
}

}  // namespace ifedem::chapter2

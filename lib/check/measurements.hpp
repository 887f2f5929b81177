#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ifedem {

/// One line of a measurements.csv: a quantity that a test or a tool measured, its standard deviation over n
/// realisations, and a word on how. A tool that knows its U better than scatter and n tell gives it.
struct Measurement {
    std::string name;
    double value = 0;
    std::string units;
    double scatter = 0;
    std::size_t n = 1;
    std::string note;
    std::optional<double> uncertainty{};  ///< 95 % half-width
};

/// name,value,units,scatter,n,note,uncertainty.
[[nodiscard]] std::string measurements_csv(std::span<const Measurement> measurements);

/// Throws Error(bad_input) with file and line for what is no measurement.
[[nodiscard]] std::vector<Measurement> read_measurements(const std::string& path);

}  // namespace ifedem

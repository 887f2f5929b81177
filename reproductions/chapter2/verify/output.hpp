#pragma once
#include <span>
#include <string>
#include <vector>

#include "check/measurements.hpp"

namespace ifedem::chapter2 {

enum class Effort { quick, full };  ///< quick: fewer realisations and levels, for continuous integration

/// What a topic leaves in its directory: tables for figures, and measurements.csv for claims
/// (name,value,units,scatter,n,note,uncertainty).
class Output {
public:
    explicit Output(std::string directory);

    /// A quantity that has no scatter.
    void add(const std::string& name, double value, const std::string& units, const std::string& note = "");
    /// A mean over realisations.
    void add(const std::string& name, std::span<const double> values, const std::string& units,
             const std::string& note = "");
    /// Differences between two variants, realisation by realisation: their uncertainty is the 95 % half-width of the
    /// mean, since no further realisation is compared with it.
    void add_difference(const std::string& name, std::span<const double> values, const std::string& units,
                        const std::string& note = "");
    /// Writes a table now. Every row has as many cells as the header.
    void write_table(const std::string& file, const std::string& header,
                     const std::vector<std::vector<std::string>>& rows) const;
    /// Writes measurements.csv; the last thing that a topic does, so that a broken one leaves none.
    void finish() const;

    [[nodiscard]] const std::string& directory() const { return directory_; }

private:
    std::string directory_;
    std::vector<Measurement> measured_;
};

/// Six significant digits.
[[nodiscard]] std::string number(double value);

/// Observed order from errors at steps that halve twice: log2 of the ratio of the differences.
[[nodiscard]] double observed_order(double coarse, double middle, double fine);

}  // namespace ifedem::chapter2

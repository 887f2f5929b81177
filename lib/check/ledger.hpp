#pragma once
#include <map>
#include <optional>
#include <string>

namespace ifedem {

/// A statement of the dissertation, as reference_data/dissertation.csv holds it.
struct LedgerRow {
    std::string id;
    int chapter = 0;
    std::string quantity;
    std::string symbol;
    std::string value;  ///< as printed; a number for most results and ratios
    std::string units;
    std::string condition;
    std::string source;
    std::size_t line = 0;  ///< of the text
    std::string kind;      ///< input, result, ratio, experiment, qualitative, derived, note

    [[nodiscard]] std::optional<double> number() const;
    /// Results, ratios, experiments and qualitative statements get a verdict.
    [[nodiscard]] bool needs_verdict() const;
};

using Ledger = std::map<std::string, LedgerRow>;  ///< by id

[[nodiscard]] Ledger read_ledger(const std::string& path);

/// How exactly the text's own number can be known: 1 N on Earth, 0.5 N on Mars and 0.125 cm for readings off a graph,
/// else half a unit of the last printed digit.
[[nodiscard]] double reading_uncertainty(const std::string& printed, const std::string& units,
                                         const std::string& gravity);

}  // namespace ifedem

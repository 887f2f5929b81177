#pragma once
#include <map>
#include <optional>
#include <string>

namespace ifedem {

/// A statement of the dissertation (reference_data/dissertation.csv, ids D…) or a value from elsewhere that checks the
/// program itself (reference_data/external.csv, ids X…).
struct LedgerRow {
    std::string id;
    int chapter = 0;
    std::string quantity;
    std::string symbol;
    std::string value;  ///< as printed; a number for most results and ratios
    std::string units;
    std::string condition;
    std::string source;
    std::size_t line = 0;  ///< of the text; 0 for other sources
    std::string kind;      ///< input, result, ratio, experiment, qualitative, derived, note; exact, published

    [[nodiscard]] std::optional<double> number() const;
    /// Results, ratios, experiments and qualitative statements get a verdict.
    [[nodiscard]] bool needs_verdict() const;
};

using Ledger = std::map<std::string, LedgerRow>;  ///< by id

/// Both files of a project's root; external.csv may be missing. Throws Error(bad_input) for a faulty row or an id that
/// stands twice.
[[nodiscard]] Ledger read_ledger(const std::string& root);

/// "Fig 3-17a / 3.4, line 686", or the source alone where no line is known.
[[nodiscard]] std::string source_text(const LedgerRow& row);

/// How exactly the text's own number can be known: 1 N on Earth, 0.5 N on Mars and 0.125 cm for readings off a graph,
/// else half a unit of the last printed digit.
[[nodiscard]] double reading_uncertainty(const std::string& printed, const std::string& units,
                                         const std::string& gravity);

}  // namespace ifedem

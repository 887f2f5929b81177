#pragma once
#include <map>
#include <string>
#include <vector>

#include "model/case.hpp"

namespace ifedem {

/// The travel stage of series.csv, a column a name; the column `stage` is left out.
using Series = std::map<std::string, std::vector<double>>;

/// One line of run.csv.
struct RunValue {
    std::string name;
    std::string value;
    std::string unit;
};

/// By its name; "" if it is not there.
[[nodiscard]] std::string find_value(const std::vector<RunValue>& values, const std::string& name);

/// A run directory as `ifedem run` leaves it.
struct Run {
    std::string directory;
    std::string name;  ///< last part of the directory
    Case c;
    Series travel;
    std::vector<RunValue> values;

    /// A value of run.csv as text, "" if it is not there.
    [[nodiscard]] std::string text(const std::string& value_name) const;
    /// The same as a number. Throws Error(bad_input) if it is none.
    [[nodiscard]] double number(const std::string& value_name) const;
};

/// What a run stands for in a claim.
struct Condition {
    std::string
        wheel;  ///< B3 or B6 (by the Young's modulus of WI, Table 3-2), tyre (no lugs), plate, rigid, or "other"
    std::string gravity;  ///< earth, mars, or the number in m/s²
    double load_N = 0;
    double slip_percent = 0;
    auto operator<=>(const Condition&) const = default;
};

[[nodiscard]] Condition condition_of(const Case& c);

/// The same condition, packing and lug phase: what two runs of different variants must have to be compared as a pair.
[[nodiscard]] bool is_same_realisation(const Case& a, const Case& b);

/// "B3, Earth, 170 N, slip 60 %".
[[nodiscard]] std::string to_text(const Condition& condition);

/// "Earth" for "earth".
[[nodiscard]] std::string capitalised(std::string word);

/// "name,value,unit" and a line each, quoted where it has to be: run.csv, and the stage.csv of a finished stage.
[[nodiscard]] std::string to_csv(const std::vector<RunValue>& values);

/// The same read back. Throws Error(io) for a missing file, Error(bad_input) for a faulty one.
[[nodiscard]] std::vector<RunValue> read_values(const std::string& path);

/// Reads case.toml, series.csv and run.csv. Throws Error(io) for a missing file, Error(bad_input) for a faulty one.
[[nodiscard]] Run read_run(const std::string& directory);

}  // namespace ifedem

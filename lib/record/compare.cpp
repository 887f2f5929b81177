#include "record/compare.hpp"

#include <fmt/format.h>

#include <cstring>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

#include "record/state_fields.hpp"

namespace ifedem {
namespace {

/// A member of the state as rows of equal size.
struct Rows {
    std::string_view name;
    std::string_view fields;  ///< of a row: names by comma, or empty
    std::span<const std::byte> bytes;
    std::size_t row_size = 0;
    bool floating = false;  ///< rows of doubles
};

template <class T>
constexpr std::string_view names_of() {
    if constexpr (std::is_same_v<T, BoundaryContact>)
        return "disc and surface,tangential_m";
    else
        return fields_of<T>;
}

template <class T>
Rows rows_of(const char* name, const T* data, std::size_t count) {
    return {name, names_of<T>(), std::as_bytes(std::span(data, count)), sizeof(T),
            std::is_same_v<T, double> || std::is_class_v<T>};
}
template <class T>
Rows rows_of(const char* name, const T& value) {
    return rows_of(name, &value, 1);
}
template <class T>
Rows rows_of(const char* name, const std::vector<T>& values) {
    return rows_of(name, values.data(), values.size());
}

std::vector<Rows> all_rows(const State& state) {
    std::vector<Rows> rows;
    const auto add = [&](const char* name, const auto& member) { rows.push_back(rows_of(name, member)); };
    for_each_member(state, add);
    for_each_soil_member(state, add);
    for_each_stress_member(state, add);
    for_each_mass_member(state, add);
    return rows;
}

std::string component_name(const Rows& rows, std::size_t at) {
    std::istringstream names{std::string(rows.fields)};
    std::string name;
    for (std::size_t n = 0; n <= at / sizeof(double) && std::getline(names, name, ',');) ++n;
    return name.empty() ? "" : "." + name;
}

std::string value_text(const Rows& rows, std::size_t at) {
    std::uint64_t word = 0;
    std::memcpy(&word, rows.bytes.data() + at, std::min(sizeof word, rows.row_size));
    double number = 0;
    std::memcpy(&number, &word, sizeof number);
    return rows.floating ? fmt::format("{:.17g} ({:#018x})", number, word) : fmt::format("{}", word);
}

std::string describe(const State& state, const Rows& a, const Rows& b, std::size_t at) {
    const std::size_t row = at / a.row_size, word = std::min(sizeof(double), a.row_size);
    const std::size_t start = at / word * word;
    std::string where = fmt::format("{}[{}]{}", a.name, row, component_name(a, start % a.row_size));
    if (a.name.starts_with("discs/") && row < state.discs.id.size())
        where += fmt::format(" (disc {})", state.discs.id[row]);
    return fmt::format("{}: {} against {}", where, value_text(a, start), value_text(b, start));
}

}  // namespace

std::optional<std::string> find_difference(const State& a, const State& b) {
    const std::vector<Rows> rows_a = all_rows(a), rows_b = all_rows(b);
    for (std::size_t n = 0; n < rows_a.size(); ++n) {
        const Rows &x = rows_a[n], &y = rows_b[n];
        if (x.bytes.size() != y.bytes.size())
            return fmt::format("{}: {} rows against {}", x.name, x.bytes.size() / x.row_size,
                               y.bytes.size() / y.row_size);
        const auto at = std::mismatch(x.bytes.begin(), x.bytes.end(), y.bytes.begin()).first - x.bytes.begin();
        if (static_cast<std::size_t>(at) != x.bytes.size()) return describe(a, x, y, static_cast<std::size_t>(at));
    }
    return std::nullopt;
}

}  // namespace ifedem

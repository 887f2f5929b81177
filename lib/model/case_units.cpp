#include "model/case_units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "model/case_keys.hpp"

namespace ifedem {
namespace {

struct UnitEnding {
    std::string_view other, own;
    int power;
};
/// Powers of ten only, so that no digit changes. Longer endings first: "_N_mm" is not "_mm".
constexpr UnitEnding endings[] = {
    {"_g_cm3", "_kg_m3", 3}, {"_N_mm", "_N_m", 3}, {"_kN_m", "_N_m", 3}, {"_mm_s", "_m_s", -3}, {"_cm_s", "_m_s", -2},
    {"_kPa", "_Pa", 3},      {"_MPa", "_Pa", 6},   {"_GPa", "_Pa", 9},   {"_kN", "_N", 3},      {"_mm", "_m", -3},
    {"_cm", "_m", -2},       {"_ms", "_s", -3},    {"_us", "_s", -6},
};

}  // namespace

std::optional<UnitVariant> find_unit_variant(std::string_view name) {
    for (const UnitEnding& ending : endings) {
        if (!name.ends_with(ending.other)) continue;
        std::string key = std::string(name.substr(0, name.size() - ending.other.size())) + std::string(ending.own);
        if (find_key(key) != nullptr) return UnitVariant{std::move(key), ending.power};
    }
    return std::nullopt;
}

double shift_point(double value, int power) {
    if (!std::isfinite(value) || value == 0) return value;
    const std::string digits = fmt::format("{}", value);  // the shortest that reads back
    const std::size_t e = digits.find('e');
    int exponent = power;
    if (e != std::string::npos) exponent += std::stoi(digits.substr(e + 1));
    const std::string shifted = fmt::format("{}e{}", digits.substr(0, e), exponent);
    double result = value;
    std::from_chars(shifted.data(), shifted.data() + shifted.size(), result);
    return result;  // out of range keeps the value, and the key's own range refuses that
}

}  // namespace ifedem

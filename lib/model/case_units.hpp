#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace ifedem {

// Internal to lib/model: units of the trade at the border.

/// A key's name in another unit than its own.
struct UnitVariant {
    std::string key;  ///< "wheel.lug_height_m" for "wheel.lug_height_mm"
    int power = 0;    ///< a value in the other unit is 10^power of the key's
};

/// Nothing if the name ends in no such unit or there is no key with the same name in SI.
[[nodiscard]] std::optional<UnitVariant> find_unit_variant(std::string_view name);

/// value · 10^power as if its decimal digits had been written with another point: 19.8 and −3 give the bits of 0.0198.
[[nodiscard]] double shift_point(double value, int power);

}  // namespace ifedem

#pragma once

namespace ifedem {

/// Cosine and sine of one angle.
struct CosSin {
    double cos = 1.0;
    double sin = 0.0;
};

/// cos and sin with the same bits on every processor, from + - * / only (glibc's differ between processors: it
/// picks FMA variants at run time). |angle| ≤ 1e6 rad; error ≤ 2 ulp.
[[nodiscard]] CosSin cos_sin(double angle_rad) noexcept;

/// Angle of (x, y) in (-π, π] with the same bits on every processor; 0 for (0, 0). Error ≤ 4 ulp.
[[nodiscard]] double atan2_fixed(double y, double x) noexcept;

inline constexpr double pi = 3.14159265358979323846;

}  // namespace ifedem

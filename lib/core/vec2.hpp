#pragma once
#include <cmath>

namespace ifedem {

/// A point, velocity or force in the plane. Eigen's Vector2d would do; a plain aggregate keeps the state
/// trivially copyable and the order of every operation in sight.
struct Vec2 {
    double x = 0.0;
    double y = 0.0;
};
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2& operator+=(Vec2& a, Vec2 b) { return a = a + b; }
constexpr Vec2& operator-=(Vec2& a, Vec2 b) { return a = a - b; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z-component of a × b.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// ω × r for a rotation about +z.
constexpr Vec2 cross(double omega, Vec2 r) { return {-omega * r.y, omega * r.x}; }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }

}  // namespace ifedem

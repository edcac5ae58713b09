#pragma once

namespace vortree {

/// A vector of the plane.
struct Vec2 {
  double x = 0, y = 0;
  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  Vec2& operator+=(Vec2 a) { return *this = *this + a; }
  friend double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
};

}  // namespace vortree

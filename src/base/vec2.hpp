#pragma once

#include <cmath>

namespace vortree {

/// A vector of the plane.
struct Vec2 {
  double x = 0, y = 0;
  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  Vec2& operator+=(Vec2 a) { return *this = *this + a; }
  friend double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
  /// Of length 1 along a, whose length lies within 1e-300 .. 1e300.
  friend Vec2 unit(Vec2 a) { return (1 / std::hypot(a.x, a.y)) * a; }
  /// By a quarter, anticlockwise.
  friend Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
  bool operator==(const Vec2&) const = default;
};

/// A turn about the origin by an angle, anticlockwise; one of 0 changes no bit.
class Turn {
 public:
  Turn() = default;
  explicit Turn(double angle) : c_(std::cos(angle)), s_(std::sin(angle)) {}

  Vec2 operator()(Vec2 a) const { return {c_ * a.x - s_ * a.y, s_ * a.x + c_ * a.y}; }

 private:
  double c_ = 1, s_ = 0;
};

}  // namespace vortree

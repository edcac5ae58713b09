#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "body/shape.hpp"

namespace vortree::vortex {

/// Of a place whose wall point is not known, or where there is no wall.
inline constexpr body::WallPoint no_wall_point{0, INFINITY, {}, 0};

/// The wall point nearest to a place, or none where that is certainly farther than `reach`.
inline body::WallPoint wall_point_within(Vec2 at, double reach, const body::Shape* wall) {
  return !wall || wall->beyond(at, reach) ? no_wall_point : wall->nearest(at);
}

/// The wall points nearest to a cloud's places, as far as they have been found: to find one costs
/// more than all that a blob asks of it, and a step asks a dozen times.
///
/// They hold while places stay where they are; of other places, and of those that come after the
/// last, nothing is known.
class WallPoints {
 public:
  /// Nothing of so many.
  explicit WallPoints(std::size_t count = 0) : found_(count, no_wall_point) {}

  void keep(std::size_t i, const body::WallPoint& nearest) { found_[i] = nearest; }

  /// That of place i, which is `at`: what is known, or else found now. Infinitely far where there
  /// is no wall, or where it is certainly farther than `reach`.
  body::WallPoint nearest(std::size_t i, Vec2 at, double reach, const body::Shape* wall) const {
    const body::WallPoint w = known(i);
    return w.distance < INFINITY ? w : wall_point_within(at, reach, wall);
  }

  /// That of place i, or one infinitely far.
  body::WallPoint known(std::size_t i) const {
    return i < found_.size() ? found_[i] : no_wall_point;
  }

 private:
  std::vector<body::WallPoint> found_;
};

/// The wall point of a place `to` on the same normal as `from`, whose wall point is known.
inline body::WallPoint along_normal(body::WallPoint nearest, Vec2 from, Vec2 to) {
  nearest.distance += dot(to - from, nearest.normal);
  return nearest;
}

}  // namespace vortree::vortex

#pragma once

#include <cmath>
#include <numbers>

#include "flow/paths/velocity_anywhere.hpp"

namespace vortree::test {

/// A square [0, 1] x [0, 1] or another, so finely.
inline flow::PictureGrid square(int points, double side = 1, Vec2 first = {}) {
  return {first, side / (points - 1), points, points};
}

/// Pictures of a velocity u(place, t) from t = 0 on.
inline flow::VelocityPictures pictures_of(const flow::PictureGrid& grid, double interval, int count,
                                          auto velocity) {
  flow::VelocityPictures all;
  for (int k = 0; k < count; ++k) {
    all.push_back({k * interval, {}});
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        all.back().velocity.push_back(velocity(grid.point(row, column), all.back().time));
  }
  return all;
}

/// By how much errors fall where the step is halved, as a power of two.
inline double halved(double coarse, double fine) {
  return std::log2(coarse / fine);
}

inline double length(Vec2 a) {
  return std::hypot(a.x, a.y);
}

}  // namespace vortree::test

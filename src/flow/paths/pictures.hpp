#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace vortree::flow {

/// The points that pictures have values at: `columns` along x and `rows` along y from `first` on,
/// `spacing` apart both ways [L].
struct PictureGrid {
  Vec2 first{};
  double spacing = 0;
  int columns = 0, rows = 0;

  std::size_t points() const { return static_cast<std::size_t>(columns) * rows; }
  Vec2 point(int row, int column) const {
    return {first.x + column * spacing, first.y + row * spacing};
  }
};

/// Velocity at the points of a grid, row by row [L/T], at a time.
struct VelocityPicture {
  double time = 0;
  std::vector<Vec2> velocity{};
};
using VelocityPictures = std::vector<VelocityPicture>;

/// As many are needed for a cubic in time.
inline constexpr std::size_t least_pictures = 4;

/// The velocity between pictures: at each point the cubic in time through the four pictures around
/// t, two on either side; near the first and the last picture through the first and the last four.
///
/// pictures  four or more on one grid, by ascending time, from t or earlier to t or later
/// error     O(D^4), D the time between two pictures; none at the time of a picture
/// cost      8 multiplications a point
/// throws    std::invalid_argument if there are fewer, if they differ in size, or if t is outside
[[nodiscard]] VelocityPicture between(std::span<const VelocityPicture> pictures, double t);

/// What the cubic in time misses, relative to the velocity, root mean squares over all points; the
/// worst place among the pictures. Each picture but the two at either end is told by its four
/// neighbors, and its error scaled to that half-way between two pictures, where their full number
/// serves: to 0.14 of it if pictures are evenly spaced.
///
/// returns  nothing of fewer than five pictures, or of fluid at rest
[[nodiscard]] std::optional<double> lost_between(std::span<const VelocityPicture> pictures);

}  // namespace vortree::flow

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace vortree::vortex {

/// Points binned by square cells, row by row, for searches within a distance.
///
/// side  of a cell [m]; wider where the cloud is so thin that there would be more than about
///       sixteen cells a point. A search costs least where it is a half or a third of the distance
/// cost  O(n) time and memory
class Bins {
 public:
  Bins(std::span<const double> x, std::span<const double> y, double side);

  /// Point numbers, cell by cell.
  std::span<const std::uint32_t> order() const { return order_; }

  /// Calls use(first, last) with runs of positions in order() that hold all points of a rectangle,
  /// and some more: the cells it meets, a run a row.
  template <class Use>
  void runs_in(Vec2 low, Vec2 high, Use use) const {
    const std::int64_t left = column(low.x), right = column(high.x), top = row(high.y);
    for (std::int64_t r = row(low.y); r <= top; ++r)
      use(start_[r * nx_ + left], start_[r * nx_ + right + 1]);
  }

  /// The same for all points within a distance of a place.
  template <class Use>
  void runs_near(Vec2 at, double distance, Use use) const {
    runs_in(at - Vec2{distance, distance}, at + Vec2{distance, distance}, use);
  }

 private:
  std::int64_t column(double x) const {
    return static_cast<std::int64_t>(std::min(std::max(0.0, (x - x0_) / side_), nx_ - 0.5));
  }
  std::int64_t row(double y) const {
    return static_cast<std::int64_t>(std::min(std::max(0.0, (y - y0_) / side_), ny_ - 0.5));
  }
  std::int64_t cell(double x, double y) const { return row(y) * nx_ + column(x); }

  double side_, x0_ = 0, y0_ = 0;
  std::int64_t nx_ = 1, ny_ = 1;
  std::vector<std::uint32_t> start_, order_;
};

}  // namespace vortree::vortex

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "vortex/vec2.hpp"

namespace vortree::vortex {

/// Points binned by square cells, row by row, for searches within a distance.
///
/// side  of a cell [m]; wider where the cloud is so thin that there would be more than about
///       sixteen cells a point. A search costs least where it is a half or a third of the distance
/// cost  O(n) time and memory
class Bins {
 public:
  /// left_out  a flag for each point that is not to be binned; empty: all are
  Bins(std::span<const double> x, std::span<const double> y, double side,
       std::span<const char> left_out = {});

  /// Point numbers, cell by cell.
  std::span<const std::uint32_t> order() const { return order_; }

  /// Calls use(first, last) with runs of positions in order() that hold all points within a
  /// distance of a place, and some more: the cells around it, a run a row.
  template <class Use>
  void runs_near(Vec2 at, double distance, Use use) const {
    const std::int64_t left = column(at.x - distance), right = column(at.x + distance);
    const std::int64_t top = row(at.y + distance);
    for (std::int64_t r = row(at.y - distance); r <= top; ++r)
      use(start_[r * nx_ + left], start_[r * nx_ + right + 1]);
  }

 private:
  std::int64_t column(double x) const {
    return static_cast<std::int64_t>(std::clamp((x - x0_) / side_, 0.0, nx_ - 0.5));
  }
  std::int64_t row(double y) const {
    return static_cast<std::int64_t>(std::clamp((y - y0_) / side_, 0.0, ny_ - 0.5));
  }
  std::int64_t cell(double x, double y) const { return row(y) * nx_ + column(x); }

  double side_, x0_ = 0, y0_ = 0;
  std::int64_t nx_ = 1, ny_ = 1;
  std::vector<std::uint32_t> start_, order_;
};

}  // namespace vortree::vortex

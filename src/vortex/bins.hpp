#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "vortex/vec2.hpp"

namespace vortree::vortex {

/// Points binned by square cells, row by row, for searches within a fixed distance.
///
/// distance  of a search [m]; cells are half as wide (wider where the cloud is so thin that there would
///           be more than about sixteen cells a point)
/// cost      O(n) time and memory
class Bins {
 public:
  Bins(std::span<const double> x, std::span<const double> y, double distance);

  /// Point numbers, cell by cell.
  std::span<const std::uint32_t> order() const { return order_; }

  /// Calls use(first, last) with runs of positions in order() that hold all points within the search
  /// distance of a place, and some more: the 5 x 5 cells around it, a run a row.
  template <class Use>
  void runs_near(Vec2 at, Use use) const {
    const std::int64_t ix = column(at.x), iy = row(at.y);
    const std::int64_t left = std::max<std::int64_t>(ix - 2, 0), right = std::min(ix + 2, nx_ - 1);
    const std::int64_t top = std::min(iy + 2, ny_ - 1);
    for (std::int64_t r = std::max<std::int64_t>(iy - 2, 0); r <= top; ++r)
      use(start_[r * nx_ + left], start_[r * nx_ + right + 1]);
  }

 private:
  std::int64_t column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>((x - x0_) / side_), 0, nx_ - 1);
  }
  std::int64_t row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>((y - y0_) / side_), 0, ny_ - 1);
  }
  std::int64_t cell(double x, double y) const { return row(y) * nx_ + column(x); }

  double side_, x0_ = 0, y0_ = 0;
  std::int64_t nx_ = 1, ny_ = 1;
  std::vector<std::uint32_t> start_, order_;
};

}  // namespace vortree::vortex

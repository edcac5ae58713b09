#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "fmm/sources.hpp"

namespace vortree::fmm {

/// What one pass over some values tells: memory is what it costs.
///
/// low, high         the least and the greatest number; of no values these
/// least_magnitude   of what is neither zero nor NaN
/// all_numbers       none is NaN
struct Bounds {
  double low = INFINITY, high = -INFINITY, least_magnitude = INFINITY;
  bool all_numbers = true;

  [[nodiscard]] bool within(double least, double most) const {
    return all_numbers && low >= least && high <= most;
  }
  [[nodiscard]] double largest_magnitude() const { return std::max({0.0, -low, high}); }
  [[nodiscard]] double half_width() const { return low <= high ? high / 2 - low / 2 : 0.0; }
};

/// cost    O(n), threads share it
/// twin    tests/fmm/geometry/bounds.cpp
[[nodiscard]] Bounds bounds_of(std::span<const double> values);

struct SourceBounds {
  Bounds x, y, gamma, sigma;
  static SourceBounds of(const Sources& sources);
};

}  // namespace vortree::fmm

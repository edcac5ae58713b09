#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "fmm/geometry/bounds.hpp"
#include "tree/base/simd.hpp"

/// Bounds of many values, a register full at a time; the plain twin is plain_bounds.
namespace vortree::fmm::kernel {

[[nodiscard]] inline Bounds united(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high),
          std::min(a.least_magnitude, b.least_magnitude), a.all_numbers && b.all_numbers};
}

[[nodiscard]] inline Bounds plain_bounds(std::span<const double> values) {
  Bounds all;
  for (const double value : values) {
    const double magnitude = std::abs(value);
    if (std::isnan(value)) {
      all.all_numbers = false;
      continue;
    }
    all = united(all, {value, value, magnitude > 0.0 ? magnitude : INFINITY, true});
  }
  return all;
}

/// A NaN is neither smaller nor larger, and so leaves what it is compared with.
[[nodiscard]] inline Bounds bounds(std::span<const double> values) {
  constexpr double infinity = INFINITY;
  const std::size_t whole = values.size() / lane_count * lane_count;
  Lanes low = fill(infinity), high = fill(-infinity), least = low;
  Bits strange{};
  for (std::size_t i = 0; i < whole; i += lane_count) {
    const Lanes value = load(&values[i]), size = magnitude(value);
    low = smaller(value, low);
    high = larger(value, high);
    least = smaller(size > 0.0 ? size : fill(infinity), least);
    strange |= value != value;
  }
  Bounds all = plain_bounds(values.subspan(whole));
  for (int i = 0; i < lane_count; ++i) {
    all = united(all, {low[i], high[i], least[i], strange[i] == 0});
  }
  return all;
}

}  // namespace vortree::fmm::kernel

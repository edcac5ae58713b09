#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "tree/order/points.hpp"

/// The extent of many numbers; the plain twin in tests/tree/order/points.cpp is
/// std::minmax_element.
namespace vortree::tree::kernel {

/// A whole number that orders doubles as < does, -0 before +0 and NaNs beyond the infinities.
[[nodiscard]] constexpr std::int64_t ordinal(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits ^ (bits >> 63 & std::numeric_limits<std::int64_t>::max());
}

/// The double of an ordinal.
[[nodiscard]] constexpr double from_ordinal(std::int64_t number) {
  return std::bit_cast<double>(number ^ (number >> 63 & std::numeric_limits<std::int64_t>::max()));
}

/// Least and greatest of at least one value. A NaN among them becomes one of the two, by its sign.
/// Unlike minima of doubles, minima of whole numbers may be taken in any order: many at a time.
[[nodiscard]] inline Extent extent(std::span<const double> values) {
  std::int64_t low = ordinal(values[0]), high = low;
  for (const double value : values) {
    const std::int64_t number = ordinal(value);
    low = std::min(low, number);
    high = std::max(high, number);
  }
  return {from_ordinal(low), from_ordinal(high)};
}

/// Of all numbers that any of the extents is of.
[[nodiscard]] inline Extent united(std::span<const Extent> extents) {
  std::int64_t low = ordinal(extents[0].low), high = ordinal(extents[0].high);
  for (const Extent& extent : extents) {
    low = std::min(low, ordinal(extent.low));
    high = std::max(high, ordinal(extent.high));
  }
  return {from_ordinal(low), from_ordinal(high)};
}

}  // namespace vortree::tree::kernel

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace vortree::fmm {

struct ClosePair {
  std::size_t first, second;
  double distance;
};

/// Two points nearer than a limit, but not in one place.
///
/// least_magnitude   of a coordinate that is not zero
/// cost              none, mostly: doubles near 1 are 2^-53 apart, so that points must be sorted
///                   only where a coordinate is smaller than 2^54 limits
[[nodiscard]] std::optional<ClosePair> find_close_pair(std::span<const double> x,
                                                       std::span<const double> y,
                                                       double least_magnitude, double limit);

}  // namespace vortree::fmm

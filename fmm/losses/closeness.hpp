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
/// cost   a pass over the coordinates: doubles near 1 are 2^-53 apart, so that only where one is
///        smaller than 2^54 limits must points be sorted
[[nodiscard]] std::optional<ClosePair> find_close_pair(std::span<const double> x,
                                                       std::span<const double> y, double limit);

}  // namespace vortree::fmm

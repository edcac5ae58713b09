#pragma once

#include <cmath>
#include <cstdint>

namespace vortree::vortex {

/// Circulation in whole numbers of a unit: sums of such have no order, so that any number of
/// threads, and any order of the blobs, give the same bits.
///
/// The unit is a power of two so small that all circulation of both signs is 2^58 to 2^59 of them,
/// and no sum of shares more than 2^63.
struct CirculationUnits {
  int exponent = 0;

  /// all  circulation of both signs [m^2/s]
  explicit CirculationUnits(double all) {
    if (all > 0) exponent = std::ilogb(all) - 58;
  }
  std::int64_t of(double gamma) const { return std::llrint(std::ldexp(gamma, -exponent)); }
  double circulation(std::int64_t units) const {
    return std::ldexp(static_cast<double>(units), exponent);
  }
};

}  // namespace vortree::vortex

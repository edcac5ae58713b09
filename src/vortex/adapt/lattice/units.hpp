#pragma once

#include <array>
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

/// The shares of one blob, together what it has itself; the one in the middle has what is left.
template <std::size_t N>
std::array<std::int64_t, N> parted(std::int64_t units, const std::array<double, N>& share) {
  std::array<std::int64_t, N> parts;
  std::int64_t left = units;
  for (std::size_t k = 0; k < N; ++k) {
    parts[k] = std::llrint(static_cast<double>(units) * share[k]);
    if (k != N / 2) left -= parts[k];
  }
  parts[N / 2] = left;
  return parts;
}

}  // namespace vortree::vortex

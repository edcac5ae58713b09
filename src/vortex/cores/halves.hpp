#pragma once

#include <cstdint>
#include <vector>

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// From the centre of a strained core to that of a half: d d^T = |D| I + D, along its major axis.
Vec2 to_half(const Deviator& deviator);

/// How strained blobs act in free space: as two round halves of half the circulation each, at
/// X + d and X - d,
///
///   d d^T = |D| I + D,   |d|^2 = 2 |D|,   sigma_h^2 = sigma^2 - 2 |D|,
///
/// which together have the blob's circulation, impulse and all second moments. A blob whose |d|^2
/// is less than `round` of sigma^2 stays one part, round, with the sigma that it has.
///
/// error  of the fourth moment along the axis, of a Gaussian's 3 V^2: 2 |d|^4 too small
/// parts  round blobs, one or two of each
/// first  of each blob's parts, and the end
struct Halves {
  static constexpr double round = 2e-3;
  /// Of sigma^2, what a half has at least.
  static constexpr double thinnest = 1e-3;

  Blobs parts;
  std::vector<std::uint32_t> first;

  explicit Halves(const Blobs& blobs);
  bool halved(std::size_t i) const { return first[i + 1] - first[i] == 2; }
};

}  // namespace vortree::vortex

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/order/points.hpp"

namespace vortree::sph {

/// Particles of a periodic square with a corner at the origin, and behind them the images of those
/// that are near a side: all that a particle of the square can have for a neighbor.
///
/// x, y, reach   of particles, then of images
/// of            whose each is
/// was           its number when images were last made, -1: it was not there
struct PeriodicImages {
  std::vector<double> x, y, reach;
  std::vector<std::int32_t> of, was;

  /// was_   of the particles, as above
  /// side   of the square; 0: no images
  void renew(tree::Points points, std::span<const double> reach_,
             std::span<const std::int32_t> was_, double side);

  [[nodiscard]] tree::Points points() const { return {x, y}; }

 private:
  static constexpr std::size_t copies = 9;
  std::vector<std::int32_t> number_, before_;  // of each copy of each particle; -1: none
};

}  // namespace vortree::sph

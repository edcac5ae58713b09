#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tree/order/points.hpp"

namespace vortree::tree {

/// A plane in which everything comes again after a length L_x along x and L_y along y [m]; a length
/// of 0 is that of a direction along which nothing does.
///
/// How far two points are apart is told by their nearest images,
///
///   dx = min(|x_j - x_i|, L_x - |x_j - x_i|),   0 <= x_i, x_j < L_x   (dy likewise),
///
/// so that each pair counts once, however far a reach goes. Of the difference, rounded once, the
/// minimum is exact: it is L_x - d only where L_x/2 < d < L_x. Nothing is rounded that the rule of
/// pairs (pair_rule.hpp) does not round in the plane.
struct PeriodicBox {
  double x = 0, y = 0;
  [[nodiscard]] bool periodic() const { return x != 0 || y != 0; }
};

/// The length after which things come again; for a length of 0 they never do.
[[nodiscard]] inline double period_of(double length) {
  return length == 0 ? std::numeric_limits<double>::infinity() : length;
}

/// |d| of the nearest image.
[[nodiscard]] inline double nearest_image(double d, double period) {
  return std::min(std::abs(d), period - std::abs(d));
}

/// The image in [0, length) of a coordinate anywhere; itself, if length is 0. Rounded once.
[[nodiscard]] inline double image_in_box(double x, double length) {
  if (length == 0) return x;
  const double rest = std::fmod(x, length), image = rest < 0 ? rest + length : rest;
  return image < length ? image : 0;
}

/// throws  std::invalid_argument if a length is negative or not finite, or naming the first
///         coordinate that is not in [0, length), in a direction that is periodic
void check_inside(const PeriodicBox& box, Points points);

}  // namespace vortree::tree

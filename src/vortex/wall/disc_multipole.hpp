#pragma once

#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "tree/order/points.hpp"
#include "vortex/blobs/velocities.hpp"

namespace vortree::vortex {

/// About the mean of some places, as wide as the farthest of them.
struct Disc {
  explicit Disc(tree::Points places);

  /// Whether a point is far enough away, r >= 1.14 R from the centre.
  bool serves(Vec2 at) const {
    const Vec2 d = at - centre;
    return dot(d, d) >= 1.14 * 1.14 * radius * radius;
  }

  Vec2 centre;
  double radius = 0;
};

/// Bare vortices seen from outside the disc of radius R that holds them: one multipole about its
/// centre c,
///
///   u - i v = 1/(2 pi i) sum_k C_k/(z - c)^(k+1),   C_k = sum_j gamma_j (z_j - c)^k,  k < P.
///
/// P is chosen for every few points by their distance r from c; 200 terms serve from 1.14 R on.
/// error   1e-10 sum |gamma_j|/(2 pi r)
/// cost    200 operations a vortex, then P a point: 17 at r = 4 R
class DiscMultipole {
 public:
  /// at  all within the disc
  DiscMultipole(const Disc& disc, tree::Points at, std::span<const double> gamma);

  /// Adds the velocity at those targets that are named, all of them served by the disc.
  void add_velocity(tree::Points targets, std::span<const std::uint32_t> named,
                    Velocities& u) const;

 private:
  Disc disc_;
  std::vector<double> coefficients_;  // real parts, imaginary parts
};

}  // namespace vortree::vortex

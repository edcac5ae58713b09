#pragma once

#include <span>
#include <vector>

#include "tree/points.hpp"
#include "vortex/vec2.hpp"
#include "vortex/velocity.hpp"

namespace vortree::vortex {

/// Bare vortices seen from outside the disc of radius R that holds them: one multipole about its
/// centre c,
///
///   u - i v = 1/(2 pi i) sum_k C_k/(z - c)^(k+1),   C_k = sum_j gamma_j (z_j - c)^k,  k < P.
///
/// P is chosen for every few points by their distance r from c, at most 200, so that points must
/// not be nearer than r = 1.14 R.
/// error   1e-10 sum |gamma_j|/(2 pi r)
/// cost    200 operations a vortex, then P a point: 17 at r = 4 R
class DiscMultipole {
 public:
  DiscMultipole(tree::Points at, std::span<const double> gamma);

  bool serves(Vec2 at) const {
    const Vec2 d = at - centre_;
    return dot(d, d) >= nearest2_;
  }

  /// Adds the velocity at those targets that are named, all of them served.
  void add_velocity(tree::Points targets, std::span<const std::uint32_t> named,
                    Velocities& u) const;

 private:
  Vec2 centre_;
  double radius_ = 0, nearest2_ = 0;
  std::vector<double> coefficients_;  // real parts, imaginary parts
};

}  // namespace vortree::vortex

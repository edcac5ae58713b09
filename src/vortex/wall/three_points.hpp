#pragma once

#include <cmath>

#include "body/shape.hpp"
#include "vortex/blobs/covariance.hpp"

namespace vortree::vortex {

/// A core as the wall sees it: three bare points in a row, at its mean z0 and at z0 +- arm, with
/// shares 1 - outer, outer/2, outer/2 of its circulation.
///
/// The slip along a wall is a harmonic function of a vortex's place. Of a core it takes, beyond the
/// mean, the traceless second moment alone, <(z - z0)^2> = 2 (D_xx + i D_xy): the points have the
/// same, outer arm^2. A round core has none, and is seen as a point; a folded one has v_t - v_n =
/// m^2 - y^2 (folded_core.hpp), m^2 on the wall. Bare points at the means alone make the slip of a
/// circle too large by the share (m^2 - y^2)/R^2.
///
///   mode k of the slip of a core on a flat wall   erfc(k s/2)
///   of these points, outer = 1/2                  exp(-k m) (1 + cos(sqrt(2) k m))/2
///
/// With half of the circulation in the middle the mean slips along panels of 0.4 to 2.4 cores err
/// by 0.6 to 3 % rms of the exact ones, of cores on the wall and less than one from it; those of a
/// point by 3 to 32 %, of two points, outer = 1, by 1 to 13 %. No point comes nearer to the wall
/// than m/5: to begin with the outer ones take more of the circulation, on shorter arms; where all
/// of it is not enough, the second moment is cut.
///
/// arm     arm squared as a complex number, (arm_x + i arm_y)^2
/// error   of mode n on a circle O((n s/R)^3) (tests/vortex/wall/three_points.cpp)
struct ThreePoints {
  double outer = 0;
  struct {
    double re = 0, im = 0;
  } arm_squared{};

  /// True of what is seen as one point.
  bool none() const { return outer == 0; }
  /// Its length [m].
  double arm() const { return std::sqrt(std::hypot(arm_squared.re, arm_squared.im)); }

  /// deviator  of the core
  /// near      what is nearest of the wall to the core's mean, in the fluid
  ThreePoints(const Deviator& deviator, const body::WallPoint& near);
};

}  // namespace vortree::vortex

#pragma once

#include <span>
#include <vector>

#include "vortex/wall/wall.hpp"

namespace vortree::vortex {

/// A body that turns about its centre, for each unit of its rate: as a patch of vorticity 2 within
/// its outline.
///
///   w(x) = -(1/pi) oint ln|x - y| t ds         velocity of the patch (contour dynamics)
///
/// slip         tangential velocity of the patch along each panel beyond e x x, that of its wall,
///              averaged over it; a circle about its centre leaves none
/// sheet        on the outline, which moves the fluid outside as the patch does,
///              gamma_i/2 + sum_j b_j K(x_i, x_j) gamma_j = w_i t_i
/// circulation  of the patch, 2 A [m^2]
/// moment       int 2 x dA over the body [m^3], about the origin
/// of_centroid  A times the arm from the centre to the centroid [m^3]
/// error        falls faster than any power of b on a smooth outline: the logarithm is integrated
///              by the weights of Kress, exact on trigonometric polynomials
/// cost         O(panels^3), once
/// source       Zabusky, Hughes & Roberts, J. Comput. Phys. 30 (1979); Kress, Linear Integral
///              Equations (1989), sect. 12.3
struct Turning {
  std::vector<double> slip, sheet;
  double circulation = 0;
  Vec2 moment, of_centroid;

  /// Of the body alone, about the origin.
  explicit Turning(const Wall& wall);

  /// Of body k of several, whose panels are those of the one alone, turned by an angle: beyond its
  /// own panels its slip is what its sheet moves there.
  Turning among(const Wall& all, std::size_t k, double angle) const;
};

/// What a body's motion has gained in a step of dt: velocity of its centre, and rate; the rate in
/// the middle of it.
struct Gain {
  Vec2 velocity;
  double faster, rate, dt;
};

/// Mean acceleration of a body's wall along each panel, dt times: (dV + faster e x x - rate^2 dt x)
/// t, x from the centre [m/s]; 0 of other bodies.
std::vector<double> gained_along_wall(const Wall& wall, const Ring& ring, const Gain& gain);

}  // namespace vortree::vortex

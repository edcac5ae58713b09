#pragma once

#include <span>
#include <vector>

#include "vortex/wall/wall.hpp"

namespace vortree::vortex {

/// A body that turns about the origin of its frame, for each unit of its rate, in axes that turn
/// with it: as a patch of vorticity 2 within its outline.
///
///   w(x) = -(1/pi) oint ln|x - y| t ds         velocity of the patch (contour dynamics)
///
/// slip         tangential velocity of the patch along each panel beyond e x x, that of the wall,
///              averaged over it; a circle about the origin leaves none
/// sheet        on the outline, which moves the fluid outside as the patch does,
///              gamma_i/2 + b sum_j K(x_i, x_j) gamma_j = w_i t_i
/// circulation  of the patch, 2 A [m^2]
/// moment       int 2 x dA over the body [m^3]
/// error        falls faster than any power of b on a smooth outline: the logarithm is integrated
///              by the weights of Kress, exact on trigonometric polynomials
/// cost         O(panels^3), once
/// source       Zabusky, Hughes & Roberts, J. Comput. Phys. 30 (1979); Kress, Linear Integral
///              Equations (1989), sect. 12.3
struct Turning {
  std::vector<double> slip, sheet;
  double circulation = 0;
  Vec2 moment;

  explicit Turning(const Wall& wall);
};

/// Mean acceleration of the wall beyond that of the origin, along each panel, over a step in which
/// the rate has changed by `faster`: (faster/dt e x x - rate^2 x) t, so many times dt [m/s].
std::vector<double> gained_along_wall(const Wall& wall, double faster, double rate, double dt);

}  // namespace vortree::vortex

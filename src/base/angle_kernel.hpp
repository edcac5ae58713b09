#pragma once

#include <numbers>

#include "tree/base/simd.hpp"

namespace vortree {

/// The angle of the vectors (x, y) to the x axis, anticlockwise, in -pi .. pi.
///
/// With b >= a the sizes of x and y, a/b is turned back by 0, pi/8 or pi/4, whichever leaves less
/// than pi/16, and
///
///   atan t = t - t^3/3 + t^5/5 - ...,   t^2 < 0.0396: eleven terms
///
/// error  4e-16; 0 for (0, 0)
/// twin   std::atan2
inline Lanes angle_of(Lanes y, Lanes x) {
  constexpr double low = 0.19891236737965800691, high = 0.66817863791929891999;  // pi/16, 3 pi/16
  constexpr double turn = std::numbers::sqrt2 - 1;                               // tan pi/8
  const Lanes wide = magnitude(x), tall = magnitude(y);
  const Lanes a = smaller(wide, tall), b = larger(larger(wide, tall), fill(1e-300));
  const Lanes c = a < low * b ? Lanes{} : (a < high * b ? fill(turn) : fill(1.0));
  const Lanes back = a < low * b
                         ? Lanes{}
                         : (a < high * b ? fill(std::numbers::pi / 8) : fill(std::numbers::pi / 4));
  const Lanes t = (a - c * b) / (b + c * a), t2 = t * t;
  Lanes series = fill(1.0 / 21);
  for (int k = 19; k >= 3; k -= 2) series = 1.0 / k - series * t2;
  Lanes angle = back + (t - t * (t2 * series));
  angle = tall > wide ? std::numbers::pi / 2 - angle : angle;
  angle = x < 0.0 ? std::numbers::pi - angle : angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace vortree

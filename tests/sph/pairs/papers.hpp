#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/pairs/kernels.hpp"

namespace vortree::test {

/// The kernels in the plane as their papers print them, and their slopes piece by piece: for twins.
///
///   W(r, H) = norm / H^2 w(r / H),   H the radius of the support
///
/// source  Dehnen & Aly 2012, table 1: Wendland's and the splines; Gingold & Monaghan 1977;
///         Johnson, Stryk & Beissel 1996; Lucy 1977
struct Printed {
  double norm, w, slope;

  double value(double reach) const { return norm / (reach * reach) * w; }
  double derivative(double reach) const { return norm / (reach * reach * reach) * slope; }
};

inline double positive_power(double base, int n) {
  return base > 0 ? std::pow(base, n) : 0;
}

inline Printed printed(sph::Kernel kernel, double r, double reach) {
  using std::numbers::pi, std::exp;
  const double s = r / reach, t = 1 - s;
  const auto power = positive_power;
  if (t <= 0) return {1, 0, 0};
  switch (kernel) {
    case sph::Kernel::wendland_c2:
      return {7 / pi, power(t, 4) * (1 + 4 * s), -20 * s * power(t, 3)};
    case sph::Kernel::wendland_c4:
      return {9 / pi, power(t, 6) * (1 + 6 * s + 35 * s * s / 3),
              power(t, 6) * (6 + 70 * s / 3) - 6 * power(t, 5) * (1 + 6 * s + 35 * s * s / 3)};
    case sph::Kernel::wendland_c6:
      return {78 / (7 * pi), power(t, 8) * (1 + 8 * s + 25 * s * s + 32 * s * s * s),
              power(t, 8) * (8 + 50 * s + 96 * s * s) -
                  8 * power(t, 7) * (1 + 8 * s + 25 * s * s + 32 * s * s * s)};
    case sph::Kernel::cubic_spline:
      return {80 / (7 * pi), power(t, 3) - 4 * power(0.5 - s, 3),
              -3 * power(t, 2) + 12 * power(0.5 - s, 2)};
    case sph::Kernel::quintic_spline:
      return {15309 / (478 * pi),  // 3^7 7
              power(t, 5) - 6 * power(2.0 / 3 - s, 5) + 15 * power(1.0 / 3 - s, 5),
              -5 * power(t, 4) + 30 * power(2.0 / 3 - s, 4) - 75 * power(1.0 / 3 - s, 4)};
    case sph::Kernel::gaussian:
      return {9 / (pi * (1 - exp(-9))), exp(-9 * s * s), -18 * s * exp(-9 * s * s)};
    case sph::Kernel::quadratic:
      return {8 / pi, 0.75 * s * s - 1.5 * s + 0.75, 1.5 * s - 1.5};
    default:
      return {5 / pi, (1 + 3 * s) * power(t, 3), -12 * s * power(t, 2)};
  }
}

}  // namespace vortree::test

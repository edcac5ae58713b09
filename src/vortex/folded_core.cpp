#include "vortex/folded_core.hpp"

#include <algorithm>

namespace vortree::vortex::folded {

Core place(double m, double s, double kappa) {
  if (!applies(m, s)) return {m, s};
  m = std::max(m, thinnest * s * inverse_sqrt_pi);
  const double bend = folded::bend(s, kappa);
  const double on_wall = s * (inverse_sqrt_pi - bend);  // mean distance of a centre on the wall
  if (m <= on_wall) {
    // m = s'/sqrt(pi) - kappa s'^2/8, the smaller root; past the sharpest edge m = s'/(2 sqrt(pi)).
    const double a = inverse_sqrt_pi;
    return {0, std::min(s, 2 * m / (a + std::sqrt(std::max(a * a - kappa * m / 2, 0.0))))};
  }
  // Near the wall m - on_wall = (y^2/s + 2 bend y)/sqrt(pi): a start from which Newton does not
  // overshoot.
  double y = s * (std::sqrt(bend * bend + (m - on_wall) / (s * inverse_sqrt_pi)) - bend);
  for (int k = 0; k < 12; ++k) {
    const double q = y / s;
    const double slope = std::erf(q) + 2 * inverse_sqrt_pi * bend * std::exp(-q * q);
    const double next = std::max(y - (mean_distance(y, s, kappa) - m) / slope, 0.0);
    const bool settled = std::abs(next - y) <= 1e-15 * s;
    y = next;
    if (settled) break;
  }
  return {y, s};
}

}  // namespace vortree::vortex::folded

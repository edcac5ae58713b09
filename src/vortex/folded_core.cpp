#include "vortex/folded_core.hpp"

#include <algorithm>

namespace vortree::vortex::folded {

Core place(double m, double s, double kappa) {
  if (!applies(m, s)) return {m, s};
  m = std::max(m, thinnest * s * inverse_sqrt_pi);
  const double bend = kappa * s * s / 8;
  if (m <= s * inverse_sqrt_pi - bend) {
    double squeezed = m / inverse_sqrt_pi;  // m = s/sqrt(pi) - kappa s^2/8 at y = 0
    for (int k = 0; k < 4; ++k) squeezed = (m + kappa * squeezed * squeezed / 8) / inverse_sqrt_pi;
    return {0, squeezed};
  }
  double y = std::max(m - 0.5 * s * inverse_sqrt_pi, 0.2 * s);
  for (int k = 0; k < 12; ++k) {
    const double q = y / s;
    const double slope = std::erf(q) + 2 * inverse_sqrt_pi * bend / s * std::exp(-q * q);
    const double next = std::max(y - (mean_distance(y, s, kappa) - m) / slope, 1e-9 * s);
    const bool settled = std::abs(next - y) < 1e-15 * s;
    y = next;
    if (settled) break;
  }
  return {y, s};
}

}  // namespace vortree::vortex::folded

#include "exact/vortex_pairs.hpp"

#include <cmath>
#include <numbers>

namespace vortree::exact {

double VortexPair::core_at(double t) const {
  return std::sqrt(core * core + 4 * nu * t);
}

double VortexPair::speed(double t) const {
  const double a = core_at(t);
  return -gamma / (2 * std::numbers::pi * distance) *
         std::expm1(-distance * distance / (2 * a * a));
}

double VortexPair::travelled(double t) const {
  // Simpson's rule: the speed hardly changes.
  constexpr int pieces = 64;
  double sum = speed(0) + speed(t);
  for (int i = 1; i < 2 * pieces; ++i) sum += (i % 2 ? 4 : 2) * speed(t * i / (2 * pieces));
  return sum * t / (6 * pieces);
}

}  // namespace vortree::exact

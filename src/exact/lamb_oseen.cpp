#include "exact/lamb_oseen.hpp"

#include <cmath>
#include <numbers>

namespace vortree::exact {

double LambOseen::core_at(double t) const {
  return std::sqrt(core * core + 4 * nu * t);
}

double LambOseen::vorticity(double r, double t) const {
  const double s = core_at(t);
  return gamma / (std::numbers::pi * s * s) * std::exp(-r * r / (s * s));
}

double LambOseen::swirl(double r, double t) const {
  if (r == 0) return 0;
  const double s = core_at(t);
  return -gamma / (2 * std::numbers::pi * r) * std::expm1(-r * r / (s * s));
}

}  // namespace vortree::exact

#include "sph/boundary/smooth_pressure.hpp"

namespace vortree::sph {

Vec2 SmoothPressure::operator()(Vec2 pressure, Vec2 by_vorticity, double dt, double memory) {
  const double share = dt < memory ? dt / memory : 1;
  mean += share * (pressure - by_vorticity - mean);
  mean_of_means += share * (mean - mean_of_means);
  return by_vorticity + 2 * mean - mean_of_means;
}

}  // namespace vortree::sph

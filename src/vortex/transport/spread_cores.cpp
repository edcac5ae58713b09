#include "vortex/transport/spread_cores.hpp"

#include <cmath>

#include "vortex/cores/folded_centroid.hpp"
#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {
namespace {

/// How much of its tilt a core keeps that is centred at a distance y from a wall.
double tilt_kept(double y, double s2, double kappa, double nu, double dt) {
  const double s = std::sqrt(s2), at_wall = 2 * folded::inverse_sqrt_pi / s * std::exp(-y * y / s2);
  const folded::MeanAndVariance folded = folded::moments(y, s, kappa);
  return std::exp(-nu * dt * at_wall * folded.mean / folded.across);
}

}  // namespace

void spread_cores(Blobs& blobs, double nu, double dt, const body::Shape* wall) {
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    Core core = blobs.core(i);
    const double half_way = core.square + 2 * nu * dt;
    core.square += 4 * nu * dt;
    if (core.deviator != Deviator{} && wall &&
        !wall->beyond(blobs.centre(i), folded::support * blobs.sigma[i])) {
      const body::WallPoint w = wall->nearest(blobs.centre(i));
      Covariance v = core.covariance(w.normal);
      const double across = half_way + 2 * core.deviator.across(w.normal);
      const double y = height(w, v);
      if (folded::applies(y, std::sqrt(across))) v.nt *= tilt_kept(y, across, w.curvature, nu, dt);
      core = core_of(v, w.normal);
    }
    blobs.put(i, blobs.centre(i), blobs.gamma[i], core);
  }
}

}  // namespace vortree::vortex

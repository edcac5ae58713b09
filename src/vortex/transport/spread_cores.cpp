#include "vortex/transport/spread_cores.hpp"

#include <cmath>

#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {
namespace {

/// How much of its tilt a core on the wall keeps.
double tilt_kept(const body::WallPoint& w, double s2, double nu, double dt) {
  const double s = std::sqrt(s2), m = folded::mean_distance(w.distance, s, w.curvature);
  const double v_n = folded::variance_across(w.distance, s, m);
  const double at_wall = 2 * folded::inverse_sqrt_pi / s * std::exp(-w.distance * w.distance / s2);
  return std::exp(-nu * dt * at_wall * m / v_n);
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
      if (const double across = half_way + 2 * core.deviator.across(w.normal);
          folded::applies(w.distance, std::sqrt(across)))
        v.nt *= tilt_kept(w, across, nu, dt);
      core = core_of(v, w.normal);
    }
    blobs.put(i, blobs.centre(i), blobs.gamma[i], core);
  }
}

}  // namespace vortree::vortex

#include "vortex/transport/spread_cores.hpp"

#include <cmath>

#include "vortex/cores/folded_centroid.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {
namespace {

/// How much of its tilt a core keeps that is centred at a distance y from a wall.
double tilt_kept(double y, double s2, double kappa, double nu, double dt) {
  const double s = std::sqrt(s2), at_wall = 2 * folded::inverse_sqrt_pi / s * std::exp(-y * y / s2);
  const folded::MeanAndVariance folded = folded::moments(y, s, kappa);
  return std::exp(-nu * dt * at_wall * folded.mean / folded.across);
}

/// A core that has spread beside a wall.
Core spread(Core core, const body::WallPoint& nearest, double nu, double dt) {
  const Deviator deviator = core.deviator;
  const double across = core.square + 2 * nu * dt + 2 * deviator.across(nearest.normal);
  core.square += 4 * nu * dt;
  Covariance v = core.covariance(nearest.normal);
  const double y = height(nearest, v);
  if (folded::applies(y, std::sqrt(across)))
    v.nt *= tilt_kept(y, across, nearest.curvature, nu, dt);
  return core_of(v, nearest.normal);
}

}  // namespace

WallPoints spread_cores(Blobs& blobs, double nu, double dt, const body::Shape* wall,
                        const WallPoints& found) {
  WallPoints nearest(wall ? blobs.size() : 0);
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Core core = blobs.core(i);
    Core wider{core.square + 4 * nu * dt, core.deviator};
    if (const auto w = found.nearest(i, blobs.centre(i), reach_of(wider), wall);
        w.distance < INFINITY) {
      nearest.keep(i, w);
      if (core.deviator != Deviator{}) wider = spread(core, w, nu, dt);
    }
    blobs.put(i, blobs.centre(i), blobs.gamma[i], wider);
  }
  return nearest;
}

}  // namespace vortree::vortex

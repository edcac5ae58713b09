#include "vortex/adapt/adaptation.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/adapt/tuning.hpp"
#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {

AtWall beside(const body::WallPoint& nearest, const Core& core) {
  const double y = nearest.distance, s = std::sqrt(2 * core.covariance(nearest.normal).nn);
  const double out = folded::mean_distance(y, s, nearest.curvature) - y;
  return {out * nearest.normal, nearest.normal, false};
}

AdaptedBlobs unpack(const Blobs& blobs, const body::Shape* wall) {
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  AdaptedBlobs adapted;
  adapted.all.resize(n);
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Core core = blobs.core(i);
    adapted.all[i] = {blobs.x[i], blobs.y[i], blobs.gamma[i], core.square, core.deviator, no_wall,
                      1,          1};
    if (!wall || wall->distance(blobs.centre(i)) >= folded::support * widest(core)) continue;
    adapted.all[i].at_wall = static_cast<std::uint32_t>(adapted.at_wall.size());
    adapted.at_wall.push_back(beside(wall->nearest(blobs.centre(i)), core));
  }
  return adapted;
}

namespace {

/// The blob with the mean and the mean square of its distance from the wall.
Placed pack(const AdaptedBlob& p, Vec2 offset, const body::Shape& wall) {
  const body::WallPoint w = wall.nearest(p.centre());
  Covariance v = p.core().covariance(w.normal);
  const Vec2 centroid = p.centre() + offset;
  const double m = wall.distance(centroid);
  v.nn = std::max(v.nn + w.distance * w.distance - m * m, 0.01 * p.square);
  return unfold({centroid, core_of(v, w.normal)}, &wall);
}

}  // namespace

Blobs pack(const AdaptedBlobs& adapted, const body::Shape* wall) {
  const std::ptrdiff_t n = std::ssize(adapted.all);
  Blobs blobs;
  blobs.resize(n);
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const AdaptedBlob& p = adapted.all[i];
    Placed blob{p.centre(), p.core()};
    if (p.at_wall != no_wall && adapted.at_wall[p.at_wall].moved)
      blob = pack(p, adapted.at_wall[p.at_wall].offset, *wall);
    blobs.put(i, blob.centre, p.gamma, blob.core);
  }
  return blobs;
}

}  // namespace vortree::vortex

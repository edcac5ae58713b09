#include "vortex/adapt/adaptation.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/adapt/tuning.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {

AtWall beside(const body::WallPoint& nearest, const Core& core) {
  const Covariance v = core.covariance(nearest.normal);
  const double y = height(nearest, v);
  const folded::MeanAndVariance acts = folded::moments(y, std::sqrt(2 * v.nn), nearest.curvature);
  const double bent = folded::followed(v.tt, nearest.curvature) * v.nn / 2;
  return {(acts.mean - y) * nearest.normal, nearest.normal, acts.mean + bent, acts.across, false};
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

/// The blob with this folded centroid and this variance across the wall.
Placed pack(const AdaptedBlob& p, const AtWall& at_wall, const body::Shape& wall) {
  Covariance v = p.core().covariance(at_wall.normal);
  v.nn = std::max(at_wall.across, 0.01 * p.square);
  return unfold({p.centre() + at_wall.offset, core_of(upright(v), at_wall.normal)}, &wall);
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
      blob = pack(p, adapted.at_wall[p.at_wall], *wall);
    blobs.put(i, blob.centre, p.gamma, blob.core);
  }
  return blobs;
}

}  // namespace vortree::vortex

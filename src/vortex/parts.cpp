#include "vortex/parts.hpp"

#include <cmath>

#include "vortex/folded_core.hpp"

namespace vortree::vortex {

AtWall beside(const WallPoint& nearest, double sigma) {
  const double y = nearest.distance;
  const double out = folded::mean_distance(y, sigma, nearest.curvature) - y;
  return {out * nearest.normal, nearest.normal, false};
}

Parts loosened(const Blobs& blobs, const Shape* wall) {
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
  Parts parts;
  parts.all.resize(n);
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double s = blobs.sigma[i];
    parts.all[i] = {blobs.x[i], blobs.y[i], blobs.gamma[i], s * s, no_wall, 1};
    if (!wall || wall->distance(blobs.centre(i)) >= knows_wall * s) continue;
    parts.all[i].at_wall = static_cast<std::uint32_t>(parts.at_wall.size());
    parts.at_wall.push_back(beside(wall->nearest(blobs.centre(i)), s));
  }
  return parts;
}

Blobs settled(const Parts& parts, const Shape* wall) {
  const std::ptrdiff_t n = std::ssize(parts.all);
  Blobs blobs;
  blobs.resize(n);
#pragma omp parallel for schedule(dynamic, 512)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Part& p = parts.all[i];
    Placed blob{p.centre(), std::sqrt(p.square)};
    if (p.at_wall != no_wall && parts.at_wall[p.at_wall].moved)
      blob = place(p.centre() + parts.at_wall[p.at_wall].offset, blob.sigma, wall);
    blobs.put(i, blob.centre, p.gamma, blob.sigma);
  }
  return blobs;
}

}  // namespace vortree::vortex

#include "vortex/acting.hpp"

#include <cmath>

#include "vortex/folded_core.hpp"

namespace vortree::vortex {
namespace {

struct ActingCore {
  Vec2 at;
  double sigma;
};

ActingCore acting_core(Vec2 centre, double sigma, const Shape& wall) {
  if (wall.beyond(centre, folded::reach * sigma)) return {centre, sigma};
  const WallPoint w = wall.nearest(centre);
  if (!folded::applies(w.distance, sigma)) return {centre, sigma};
  const double m = folded::mean_distance(w.distance, sigma, w.curvature);
  const double across = folded::variance_across(w.distance, sigma, m);
  return {centre + (m - w.distance) * w.normal, std::sqrt((sigma * sigma + 2 * across) / 2)};
}

}  // namespace

Acting acting(const Blobs& blobs, const Shape* wall) {
  Acting result{blobs.x, blobs.y, blobs.sigma};
  if (!wall) return result;
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const ActingCore core = acting_core(blobs.centre(i), blobs.sigma[i], *wall);
    result.x[i] = core.at.x;
    result.y[i] = core.at.y;
    result.sigma[i] = core.sigma;
  }
  return result;
}

Vec2 acting_position(Vec2 centre, double sigma, const Shape* wall) {
  return wall ? acting_core(centre, sigma, *wall).at : centre;
}

Placed place(Vec2 mean, double sigma, const Shape* wall) {
  if (!wall || wall->beyond(mean, folded::reach * sigma)) return {mean, sigma};
  const WallPoint w = wall->nearest(mean);
  if (!folded::applies(w.distance, sigma)) return {mean, sigma};
  const folded::Core core = folded::place(w.distance, sigma, w.curvature);
  return {mean + (core.y - w.distance) * w.normal, core.s};
}

}  // namespace vortree::vortex

#include "vortex/cores/folded_centroid.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {

double height(const body::WallPoint& nearest, const Covariance& core) {
  return nearest.distance + folded::sag(core.nn, core.tt, nearest.curvature);
}

namespace {

/// What is nearest of a wall that the core reaches, and the core in its frame; or nothing.
struct Beside {
  bool reached = false;
  body::WallPoint wall{};
  Covariance core{};

  Beside(Vec2 at, const Core& own, const body::Shape* shape) {
    if (!shape || shape->beyond(at, folded::support * widest(own))) return;
    wall = shape->nearest(at);
    core = own.covariance(wall.normal);
    core.nn = std::max(core.nn, 1e-12 * core.tt);  // what is squeezed to nothing, but for round-off
    reached = folded::applies(wall.distance, sigma());
  }
  double sigma() const { return std::sqrt(2 * core.nn); }

  /// How it acts.
  Placed folded(Vec2 at) const {
    const double y = height(wall, core);
    const folded::MeanAndVariance acts = folded::moments(y, sigma(), wall.curvature);
    return {at + (acts.mean - y) * wall.normal,
            core_of(upright({acts.across, core.nt, core.tt}), wall.normal)};
  }

  /// The mean by which a core is placed that acts so far from the wall, and what it follows of it.
  double mean() const {
    const double least = folded::thinnest * folded::inverse_sqrt_pi * sigma();
    return std::max(wall.distance, least) + followed() * core.tt / 2;
  }
  double followed() const { return folded::followed(core.tt, wall.curvature); }

  /// The blob of the distance and of the width across the wall that `own` has; `at` is where this
  /// one is.
  Placed put(Vec2 at, const folded::Gaussian& own) const {
    const Covariance v = upright({own.s * own.s / 2, core.nt, core.tt});
    return {at + (own.y - height(wall, v)) * wall.normal, core_of(v, wall.normal)};
  }
};

}  // namespace

Placed fold(Vec2 centre, const Core& core, const body::Shape* shape) {
  const Beside blob(centre, core, shape);
  return blob.reached ? blob.folded(centre) : Placed{centre, core};
}

FoldedBlobs fold(const Blobs& blobs, const body::Shape* wall) {
  FoldedBlobs result{blobs.x, blobs.y, blobs.sigma};
  if (!wall) return result;
  result.xx.resize(blobs.size());
  result.xy.resize(blobs.size());
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Beside beside(blobs.centre(i), blobs.core(i), wall);
    if (!beside.reached) continue;
    const Placed blob = beside.folded(blobs.centre(i));
    result.x[i] = blob.centre.x;
    result.y[i] = blob.centre.y;
    result.sigma[i] = std::sqrt(blob.core.square);
    result.xx[i] = blob.core.deviator.xx;
    result.xy[i] = blob.core.deviator.xy;
  }
  return result;
}

Placed place(Vec2 mean, const Core& core, const body::Shape* shape) {
  const Beside blob(mean, core, shape);
  if (!blob.reached) return {mean, core};
  return blob.put(mean,
                  folded::place(blob.mean(), blob.sigma(), blob.wall.curvature, blob.followed()));
}

Placed unfold(const Placed& folded, const body::Shape* shape) {
  const Beside blob(folded.centre, folded.core, shape);
  if (!blob.reached) return folded;
  return blob.put(folded.centre, folded::place_with_variance(blob.mean(), blob.core.nn,
                                                             blob.wall.curvature, blob.followed()));
}

Placed strained(const Placed& blob, Vec2 way, const Gradient& gradient, double dt,
                const body::Shape* shape) {
  const Placed before = fold(blob.centre, blob.core, shape);
  Placed after{before.centre + way, carried(before.core, gradient, dt)};
  if (const Beside beside(blob.centre, blob.core, shape); beside.reached) {
    const Vec2 n = beside.wall.normal;
    Covariance v = after.core.covariance(n);
    v.tt = before.core.covariance(n).tt;
    after.core = core_of(upright(v), n);
  }
  return unfold(after, shape);
}

}  // namespace vortree::vortex

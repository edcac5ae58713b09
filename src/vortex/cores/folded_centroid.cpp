#include "vortex/cores/folded_centroid.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/cores/folded_core.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {

double height(const body::WallPoint& nearest, const Covariance& core) {
  return nearest.distance + folded::sag(core.nn, core.tt, nearest.curvature);
}

namespace {

body::WallPoint nearest(Vec2 at, const Core& core, const body::Shape* wall) {
  return wall_point_within(at, reach_of(core), wall);
}

/// What is nearest of a wall that the core reaches, and the core in its frame; or nothing.
struct Beside {
  bool reached = false;
  body::WallPoint wall{};
  Covariance core{};

  Beside(const Core& own, const body::WallPoint& nearest) : wall(nearest) {
    if (wall.distance == INFINITY) return;
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

double reach_of(const Core& core) {
  return folded::support * widest(core);
}

Placed fold(Vec2 centre, const Core& core, const body::Shape* shape) {
  const Beside blob(core, nearest(centre, core, shape));
  return blob.reached ? blob.folded(centre) : Placed{centre, core};
}

FoldedBlobs fold(const Blobs& blobs, const body::Shape* wall, const WallPoints& found) {
  FoldedBlobs result{blobs.x, blobs.y, blobs.sigma};
  if (!wall) return result;
  result.xx.resize(blobs.size());
  result.xy.resize(blobs.size());
  result.wall = WallPoints(blobs.size());
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 centre = blobs.centre(i);
    const Core core = blobs.core(i);
    const Beside beside(core, found.nearest(i, centre, reach_of(core), wall));
    if (!beside.reached) continue;
    const Placed blob = beside.folded(centre);
    result.x[i] = blob.centre.x;
    result.y[i] = blob.centre.y;
    result.sigma[i] = std::sqrt(blob.core.square);
    result.xx[i] = blob.core.deviator.xx;
    result.xy[i] = blob.core.deviator.xy;
    result.wall.keep(i, along_normal(beside.wall, centre, blob.centre));
  }
  return result;
}

Placed place(Vec2 mean, const Core& core, const body::Shape* shape) {
  const Beside blob(core, nearest(mean, core, shape));
  if (!blob.reached) return {mean, core};
  return blob.put(mean,
                  folded::place(blob.mean(), blob.sigma(), blob.wall.curvature, blob.followed()));
}

Placed unfold(const Placed& folded, const body::WallPoint& nearest) {
  const Beside blob(folded.core, nearest);
  if (!blob.reached) return folded;
  return blob.put(folded.centre, folded::place_with_variance(blob.mean(), blob.core.nn,
                                                             blob.wall.curvature, blob.followed()));
}

Placed unfold(const Placed& folded, const body::Shape* shape) {
  return unfold(folded, nearest(folded.centre, folded.core, shape));
}

Placed strained(const Placed& folded, const body::WallPoint& nearest, Vec2 way,
                const Gradient& gradient, double dt, double turned) {
  Placed after{folded.centre + way, carried(folded.core, gradient, dt)};
  if (nearest.distance < INFINITY) {
    const Vec2 normal = Turn(turned)(nearest.normal);
    Covariance v = after.core.covariance(normal);
    v.tt = folded.core.covariance(nearest.normal).tt;
    after.core = core_of(upright(v), normal);
  }
  return after;
}

}  // namespace vortree::vortex

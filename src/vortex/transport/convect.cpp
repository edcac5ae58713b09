#include "vortex/transport/convect.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {
namespace {

/// Of a core that has gone into the wall, or nearly: how far from it it stays, of its sigma.
constexpr double least_mean = folded::thinnest * folded::inverse_sqrt_pi;

/// How blobs act that have gone on by dt u: with the cores that they had.
FoldedBlobs gone(const FoldedBlobs& from, const Velocities& u, const body::Shape* wall, double dt) {
  FoldedBlobs at = from;
  at.wall = WallPoints(wall ? from.x.size() : 0);
  const std::ptrdiff_t n = std::ssize(from.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    Vec2 to = from.at(i) + dt * Vec2{u.u[i], u.v[i]};
    const double s = from.sigma[i];
    if (const auto w = wall_point_within(to, folded::support * s, wall); w.distance < INFINITY) {
      const Vec2 out = to + std::max(least_mean * s - w.distance, 0.0) * w.normal;
      at.wall.keep(i, along_normal(w, to, out));
      to = out;
    }
    at.x[i] = to.x;
    at.y[i] = to.y;
  }
  return at;
}

/// Blobs, each put where move(i) says.
void move_each(Blobs& blobs, auto move) {
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Placed blob = move(i);
    blobs.put(i, blob.centre, blobs.gamma[i], blob.core);
  }
}

/// Carried from their folded centroids by dt u; their cores as they are.
WallPoints carry(Blobs& blobs, const FoldedBlobs& from, const Velocities& u,
                 const body::Shape* wall, double dt) {
  move_each(blobs, [&](std::ptrdiff_t i) {
    return place(from.at(i) + dt * Vec2{u.u[i], u.v[i]}, blobs.core(i), wall);
  });
  return WallPoints();
}

/// The same, with cores that are strained on the way.
WallPoints strain(Blobs& blobs, const FoldedBlobs& from, const Velocities& u, const Gradients& g,
                  const body::Shape* wall, double dt) {
  WallPoints found(blobs.size());
  move_each(blobs, [&](std::ptrdiff_t i) {
    const body::WallPoint before = from.wall.known(i);
    const Placed acts =
        before.distance < INFINITY ? from.folded(i) : Placed{blobs.centre(i), blobs.core(i)};
    const Placed to =
        strained(acts, before, dt * Vec2{u.u[i], u.v[i]}, {g.ux[i], g.uy[i], g.vx[i]}, dt);
    const body::WallPoint nearest = wall_point_within(to.centre, reach_of(to.core), wall);
    const Placed blob = unfold(to, nearest);
    found.keep(i, along_normal(nearest, to.centre, blob.centre));
    return blob;
  });
  return found;
}

void add(Velocities& sum, double weight, const Velocities& u) {
  for (std::size_t i = 0; i < sum.u.size(); ++i) {
    sum.u[i] += weight * u.u[i];
    sum.v[i] += weight * u.v[i];
  }
}

}  // namespace

WallPoints convect(Blobs& blobs, const AdvectingVelocity& velocity, const body::Shape* wall,
                   flow::Scheme scheme, double dt, bool strains, const WallPoints& found) {
  const FoldedBlobs from = fold(blobs, wall, found);
  Gradients gradients;
  const auto at = [&](const Velocities& u, double h, Gradients* g = nullptr) {
    return velocity(blobs, gone(from, u, wall, h), h, g);
  };
  const auto finish = [&](const Velocities& u) {
    return strains ? strain(blobs, from, u, gradients, wall, dt) : carry(blobs, from, u, wall, dt);
  };
  Gradients* const wanted = strains ? &gradients : nullptr;

  const Velocities k1 = velocity(blobs, from, 0, nullptr);
  if (scheme == flow::Scheme::rk2) return finish(at(k1, dt / 2, wanted));
  const Velocities k2 = at(k1, dt / 2);
  const Velocities k3 = at(k2, dt / 2, wanted);
  const Velocities k4 = at(k3, dt);
  Velocities mean(blobs.size());
  add(mean, 1.0 / 6, k1);
  add(mean, 1.0 / 3, k2);
  add(mean, 1.0 / 3, k3);
  add(mean, 1.0 / 6, k4);
  return finish(mean);
}

}  // namespace vortree::vortex

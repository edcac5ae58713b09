#include "vortex/transport/convect.hpp"

#include <algorithm>
#include <cmath>

#include "vortex/cores/folded_core.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {
namespace {

/// Of a core that has gone into the wall, or nearly: how far from it it stays, of its sigma.
constexpr double least_mean = folded::thinnest * folded::inverse_sqrt_pi;

/// How blobs act that have gone on by dt u: with the cores that they had.
FoldedBlobs gone(const FoldedBlobs& from, const Velocities& u, const body::Shape* wall, double dt) {
  FoldedBlobs at = from;
  at.wall = WallPoints(wall ? from.x.size() : 0);
  const std::ptrdiff_t n = std::ssize(from.x);
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
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
#pragma omp parallel for schedule(dynamic, blobs_a_turn)
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
                  const WallOnItsWay& on_its_way, double dt) {
  const body::Shape* wall = on_its_way.at(dt);
  WallPoints found(blobs.size());
  move_each(blobs, [&](std::ptrdiff_t i) {
    const body::WallPoint before = from.wall.known(i);
    const Placed acts =
        before.distance < INFINITY ? from.folded(i) : Placed{blobs.centre(i), blobs.core(i)};
    const double turned = before.distance < INFINITY ? on_its_way.turned(before.arc, dt) : 0;
    const Placed to =
        strained(acts, before, dt * Vec2{u.u[i], u.v[i]}, {g.ux[i], g.uy[i], g.vx[i]}, dt, turned);
    const body::WallPoint nearest = wall_point_within(to.centre, reach_of(to.core), wall);
    const Placed blob = unfold(to, nearest);
    found.keep(i, along_normal(nearest, to.centre, blob.centre));
    return blob;
  });
  return found;
}

/// Velocities as they were told at `stage` become those that lead straight, in axes that turn, to
/// where blobs are at the time `to`.
Velocities relative(Velocities u, const FoldedBlobs& from, const TurningAxes& axes, double stage,
                    double to) {
  if (!axes) return u;
  const Turn back(-axes(to)), of_velocity(axes(stage) - axes(to));
  const std::ptrdiff_t n = std::ssize(u.u);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 w = of_velocity({u.u[i], u.v[i]}) + (1 / to) * (back(from.at(i)) - from.at(i));
    u.u[i] = w.x;
    u.v[i] = w.y;
  }
  return u;
}

/// Gradients of the same, as seen from axes that turn by so much a unit of time.
void see_turning(Gradients& g, double rate) {
  for (double& uy : g.uy) uy += rate;
  for (double& vx : g.vx) vx -= rate;
}

void add(Velocities& sum, double weight, const Velocities& u) {
  for (std::size_t i = 0; i < sum.u.size(); ++i) {
    sum.u[i] += weight * u.u[i];
    sum.v[i] += weight * u.v[i];
  }
}

}  // namespace

WallPoints convect(Blobs& blobs, const AdvectingVelocity& velocity, const WallOnItsWay& wall,
                   flow::Scheme scheme, double dt, bool strains, const WallPoints& found,
                   const TurningAxes& axes) {
  const FoldedBlobs from = fold(blobs, wall.at(0), found);
  Gradients gradients;
  const auto at = [&](const Velocities& u, double before, double h, Gradients* g = nullptr) {
    return velocity(blobs, gone(from, relative(u, from, axes, before, h), wall.at(h), h), h, g);
  };
  const auto finish = [&](const Velocities& u) {
    if (strains && axes) see_turning(gradients, axes(dt) / dt);
    return strains ? strain(blobs, from, u, gradients, wall, dt)
                   : carry(blobs, from, u, wall.at(dt), dt);
  };
  Gradients* const wanted = strains ? &gradients : nullptr;

  const Velocities k1 = velocity(blobs, from, 0, nullptr);
  const auto whole = [&](const Velocities& u, double stage) {
    return relative(u, from, axes, stage, dt);
  };
  if (scheme == flow::Scheme::rk2) return finish(whole(at(k1, 0, dt / 2, wanted), dt / 2));
  const Velocities k2 = at(k1, 0, dt / 2);
  const Velocities k3 = at(k2, dt / 2, dt / 2, wanted);
  const Velocities k4 = at(k3, dt / 2, dt);
  Velocities mean(blobs.size());
  add(mean, 1.0 / 6, whole(k1, 0));
  add(mean, 1.0 / 3, whole(k2, dt / 2));
  add(mean, 1.0 / 3, whole(k3, dt / 2));
  add(mean, 1.0 / 6, whole(k4, dt));
  return finish(mean);
}

}  // namespace vortree::vortex

#include "vortex/transport/convect.hpp"

namespace vortree::vortex {
namespace {

/// Blobs of `start`, each put where move(i) says.
Blobs moved_each(const Blobs& start, auto move) {
  Blobs blobs = start;
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Placed blob = move(i);
    blobs.put(i, blob.centre, blobs.gamma[i], blob.core);
  }
  return blobs;
}

/// Carried from their folded centroids by dt u; their cores as they are.
Blobs carried(const Blobs& start, const FoldedBlobs& from, const Velocities& u,
              const body::Shape* wall, double dt) {
  return moved_each(start, [&](std::ptrdiff_t i) {
    return place({from.x[i] + dt * u.u[i], from.y[i] + dt * u.v[i]}, start.core(i), wall);
  });
}

/// The same, with cores that are strained on the way.
Blobs strained(const Blobs& start, const Velocities& u, const Gradients& g, const body::Shape* wall,
               double dt) {
  return moved_each(start, [&](std::ptrdiff_t i) {
    return vortex::strained({start.centre(i), start.core(i)}, dt * Vec2{u.u[i], u.v[i]},
                            {g.ux[i], g.uy[i], g.vx[i]}, dt, wall);
  });
}

void add(Velocities& sum, double weight, const Velocities& u) {
  for (std::size_t i = 0; i < sum.u.size(); ++i) {
    sum.u[i] += weight * u.u[i];
    sum.v[i] += weight * u.v[i];
  }
}

}  // namespace

void convect(Blobs& blobs, const AdvectingVelocity& velocity, const body::Shape* wall,
             flow::Scheme scheme, double dt, bool strains) {
  const FoldedBlobs from = fold(blobs, wall);
  Gradients gradients;
  const auto moved = [&](const Velocities& u, double h) {
    return carried(blobs, from, u, wall, h);
  };
  const auto at = [&](const Blobs& stage, double h, Gradients* g = nullptr) {
    return velocity(stage, fold(stage, wall), h, g);
  };
  const auto finish = [&](const Velocities& u) {
    blobs = strains ? strained(blobs, u, gradients, wall, dt) : moved(u, dt);
  };
  Gradients* const wanted = strains ? &gradients : nullptr;

  const Velocities k1 = velocity(blobs, from, 0, nullptr);
  if (scheme == flow::Scheme::rk2) return finish(at(moved(k1, dt / 2), dt / 2, wanted));
  const Velocities k2 = at(moved(k1, dt / 2), dt / 2);
  const Velocities k3 = at(moved(k2, dt / 2), dt / 2, wanted);
  const Velocities k4 = at(moved(k3, dt), dt);
  Velocities mean(blobs.size());
  add(mean, 1.0 / 6, k1);
  add(mean, 1.0 / 3, k2);
  add(mean, 1.0 / 3, k3);
  add(mean, 1.0 / 6, k4);
  finish(mean);
}

}  // namespace vortree::vortex

#include "vortex/convect.hpp"

namespace vortree::vortex {
namespace {

/// Blobs of `start`, carried from their acting positions by dt u.
Blobs carried(const Blobs& start, const Acting& from, const Velocities& u, const Shape* wall,
              double dt) {
  Blobs blobs = start;
  const std::ptrdiff_t n = std::ssize(blobs.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 to{from.x[i] + dt * u.u[i], from.y[i] + dt * u.v[i]};
    const Placed blob = place(to, start.sigma[i], wall);
    blobs.put(i, blob.centre, blobs.gamma[i], blob.sigma);
  }
  return blobs;
}

void add(Velocities& sum, double weight, const Velocities& u) {
  for (std::size_t i = 0; i < sum.u.size(); ++i) {
    sum.u[i] += weight * u.u[i];
    sum.v[i] += weight * u.v[i];
  }
}

}  // namespace

void convect(Blobs& blobs, const Carrying& velocity, const Shape* wall, Scheme scheme, double dt) {
  const Acting from = acting(blobs, wall);
  const auto moved = [&](const Velocities& u, double h) {
    return carried(blobs, from, u, wall, h);
  };
  const auto at = [&](const Blobs& stage, double h) {
    return velocity(stage, acting(stage, wall), h);
  };

  const Velocities k1 = velocity(blobs, from, 0);
  const Velocities k2 = at(moved(k1, dt / 2), dt / 2);
  if (scheme == Scheme::rk2) {
    blobs = moved(k2, dt);
    return;
  }
  const Velocities k3 = at(moved(k2, dt / 2), dt / 2);
  const Velocities k4 = at(moved(k3, dt), dt);
  Velocities mean(blobs.size());
  add(mean, 1.0 / 6, k1);
  add(mean, 1.0 / 3, k2);
  add(mean, 1.0 / 3, k3);
  add(mean, 1.0 / 6, k4);
  blobs = moved(mean, dt);
}

}  // namespace vortree::vortex

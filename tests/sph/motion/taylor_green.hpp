#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/motion/momentum.hpp"
#include "sph/motion/shift.hpp"
#include "sph/operators/derivatives.hpp"

namespace vortree::sph::test {

/// Vortices of Taylor and Green in the unit square, periodic:
///
///   u = -cos(kx) sin(ky) e,  v = sin(kx) cos(ky) e,  p = -(cos(2kx) + cos(2ky))/4 e^2,
///   k = 2 pi,  e = exp(-2 k^2 nu t)
struct TaylorGreen {
  double nu = 0.01;
  static constexpr double k = 2 * std::numbers::pi;

  double decay(double t) const { return std::exp(-2 * k * k * nu * t); }
  Vec2 velocity(Vec2 at, double t) const {
    return decay(t) *
           Vec2{-std::cos(k * at.x) * std::sin(k * at.y), std::sin(k * at.x) * std::cos(k * at.y)};
  }
  double pressure(Vec2 at, double t) const {
    return -0.25 * (std::cos(2 * k * at.x) + std::cos(2 * k * at.y)) * decay(t) * decay(t);
  }
};

/// n x n particles at random a little off a lattice, spread evenly; with `finer`, those within a
/// quarter of the middle are four.
inline Cloud periodic_cloud(int n, bool finer, const OperatorOptions& options, int seed = 1) {
  Cloud cloud;
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> off(-0.1, 0.1);
  const double s = 1.0 / n;
  const auto put = [&](Vec2 at, double spacing) {
    const Vec2 by{off(random), off(random)};
    cloud.add(at + spacing * by, spacing, ParticleKind::fluid);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 at{(i + 0.5) * s, (j + 0.5) * s};
      if (finer && std::hypot(at.x - 0.5, at.y - 0.5) < 0.25)
        for (const Vec2 c : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}})
          put(at + s / 4 * c, s / 2);
      else
        put(at, s);
    }
  Stencils stencils;
  for (int step = 0; step < 50; ++step) {
    stencils.renew(cloud, options);
    spread_evenly(cloud, stencils);
    for (double& x : cloud.x) x -= std::floor(x);
    for (double& y : cloud.y) y -= std::floor(y);
  }
  sort(cloud);
  return cloud;
}

/// Relative errors in the L2 norm, by volumes.
struct Errors {
  double velocity, pressure;
};

inline Errors errors(const Cloud& cloud, const TaylorGreen& exact, double t) {
  double e = 0, u2 = 0, p = 0, p2 = 0, mean = 0, exact_mean = 0, volume = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    volume += cloud.volume(i), mean += cloud.volume(i) * cloud.p[i];
    exact_mean += cloud.volume(i) * exact.pressure(cloud.at(i), t);
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double V = cloud.volume(i);
    const Vec2 u = exact.velocity(cloud.at(i), t), d = cloud.velocity(i) - u;
    const double pi = exact.pressure(cloud.at(i), t) - exact_mean / volume;
    e += V * dot(d, d), u2 += V * dot(u, u);
    p += V * std::pow(cloud.p[i] - mean / volume - pi, 2), p2 += V * pi * pi;
  }
  return {std::sqrt(e / u2), std::sqrt(p / p2)};
}

/// The flow from 0 to `end` in equal steps of at most courant spacings.
inline Errors taylor_green(int n, const OperatorOptions& options, bool finer = false,
                           double end = 0.5, double courant = 0.2, double strength = 6,
                           int seed = 1) {
  const TaylorGreen exact;
  Cloud cloud = periodic_cloud(n, finer, options, seed);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 u = exact.velocity(cloud.at(i), 0);
    cloud.u[i] = cloud.u_before[i] = u.x, cloud.v[i] = cloud.v_before[i] = u.y;
    cloud.p[i] = exact.pressure(cloud.at(i), 0);
  }
  const double finest = (finer ? 0.5 : 1.0) / n;
  const int steps = static_cast<int>(std::ceil(end / (courant * finest)));
  Stencils stencils;
  std::vector<Slopes> slopes;
  Momentum momentum;
  const Ambient ambient{.nu = exact.nu};
  const std::vector<double> no_wall;
  stencils.renew(cloud, options);
  find_slopes(cloud, stencils, slopes);
  for (int step = 0; step < steps; ++step) {
    const TimeStep now{end / steps, step > 0 ? 1.0 : 0.0};
    shift_and_move(cloud, stencils, slopes, now, strength);
    for (double& x : cloud.x) x -= std::floor(x);
    for (double& y : cloud.y) y -= std::floor(y);
    stencils.renew(cloud, options);
    momentum.solve(cloud, stencils, options,
                   {.step = now,
                    .later = (step + 1) * now.dt,
                    .ambient = ambient,
                    .wall_vorticity = no_wall,
                    .tolerance = 1e-6},
                   [](auto) {});
    find_slopes(cloud, stencils, slopes);
  }
  return errors(cloud, exact, end);
}

}  // namespace vortree::sph::test

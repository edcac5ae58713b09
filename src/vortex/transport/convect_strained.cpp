#include "vortex/transport/convect_strained.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::vortex {
namespace {

/// Rates of centres, of sigma squared and of the deviators.
struct Rates {
  Velocities u;
  std::vector<double> square, xx, xy;

  explicit Rates(std::size_t n) : u(n), square(n), xx(n), xy(n) {}
};

/// How much of the strain across a short d is that of the mean gradient: a difference of two
/// velocities over next to nothing has few digits. As much of energy is not kept: 3e-7 of that of
/// 40 long blobs in a radian, 3e-6 with ten times as much of it.
constexpr double short_way = 1e-3;

/// The traceless part of d u^T + u d^T.
Deviator drawn(Vec2 d, Vec2 u) {
  return {d.x * u.x - d.y * u.y, d.x * u.y + d.y * u.x};
}

/// Strain of the gradient G with G d = u and this vorticity, times |d|^2.
Deviator strain_along(Vec2 d, Vec2 u, double vorticity) {
  const double d2 = dot(d, d);
  const Vec2 e = (1 / std::sqrt(d2)) * d, n{-e.y, e.x};
  const double along = dot(u, d), aside = dot(u, n) * std::sqrt(d2) - vorticity / 2 * d2;
  const double c = e.x * e.x - e.y * e.y, s = 2 * e.x * e.y;
  return {along * c - aside * s, along * s + aside * c};
}

Deviator strain(const Gradients& g, std::size_t k) {
  return {g.ux[k], (g.uy[k] + g.vx[k]) / 2};
}

class MovingMoments {
 public:
  MovingMoments(const PartsVelocity& velocity, std::size_t n) : velocity_(velocity), n_(n) {}

  Rates at(const Blobs& blobs, double after) const {
    const Halves halves(blobs);
    Gradients g;
    const Velocities u = velocity_(halves.parts, after, g);
    Rates rates(n_);
    const auto n = static_cast<std::ptrdiff_t>(n_);
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t i = 0; i < n; ++i)
      halves.halved(i) ? of_halves(rates, i, blobs, u, g, halves.first[i])
                       : of_round(rates, i, blobs, u, g, halves.first[i]);
    return rates;
  }

 private:
  static void of_round(Rates& rates, std::size_t i, const Blobs& b, const Velocities& u,
                       const Gradients& g, std::size_t k) {
    const Deviator e = strain(g, k);
    const double square = b.sigma[i] * b.sigma[i], omega = g.vx[k] - g.uy[k];
    rates.u.u[i] = u.u[k];
    rates.u.v[i] = u.v[k];
    rates.xx[i] = square * e.xx - omega * b.xy[i];
    rates.xy[i] = square * e.xy + omega * b.xx[i];
  }
  static void of_halves(Rates& rates, std::size_t i, const Blobs& b, const Velocities& u,
                        const Gradients& g, std::size_t k) {
    const Core core = b.core(i);
    const Vec2 d = to_half(core.deviator);
    const Vec2 plus{u.u[k], u.v[k]}, minus{u.u[k + 1], u.v[k + 1]};
    const Vec2 mean_u = 0.5 * (plus + minus), apart = 0.5 * (plus - minus);
    const double omega = (g.vx[k] - g.uy[k] + g.vx[k + 1] - g.uy[k + 1]) / 2;
    const Deviator mean = 0.5 * (strain(g, k) + strain(g, k + 1));
    const double d2 = dot(d, d), square = core.square - d2, few = short_way * square;
    const Deviator e = (1 / (d2 + few)) * (strain_along(d, apart, omega) + few * mean);
    const Deviator of_way = drawn(d, apart);
    rates.u.u[i] = mean_u.x;
    rates.u.v[i] = mean_u.y;
    rates.square[i] = 2 * dot(d, apart);
    rates.xx[i] = of_way.xx + square * e.xx;
    rates.xy[i] = of_way.xy + square * e.xy;
  }

  const PartsVelocity& velocity_;
  std::size_t n_;
};

/// Blobs a time h later at these rates.
Blobs moved(const Blobs& from, const Rates& rates, double h) {
  Blobs blobs = from;
  const std::ptrdiff_t n = std::ssize(from.x);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    Core core = from.core(i);
    core.square += h * rates.square[i];
    core.deviator = core.deviator + h * Deviator{rates.xx[i], rates.xy[i]};
    const double most = 0.499 * core.square, size = core.deviator.size();
    if (size > most) core.deviator = (most / size) * core.deviator;
    blobs.put(i, from.centre(i) + h * Vec2{rates.u.u[i], rates.u.v[i]}, from.gamma[i], core);
  }
  return blobs;
}

void add(Rates& sum, double weight, const Rates& k) {
  const auto plus = [weight](std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += weight * b[i];
  };
  plus(sum.u.u, k.u.u);
  plus(sum.u.v, k.u.v);
  plus(sum.square, k.square);
  plus(sum.xx, k.xx);
  plus(sum.xy, k.xy);
}

}  // namespace

void convect_strained(Blobs& blobs, const PartsVelocity& velocity, flow::Scheme scheme, double dt) {
  const MovingMoments motion(velocity, blobs.size());
  const Rates k1 = motion.at(blobs, 0), k2 = motion.at(moved(blobs, k1, dt / 2), dt / 2);
  if (scheme == flow::Scheme::rk2) {
    blobs = moved(blobs, k2, dt);
    return;
  }
  const Rates k3 = motion.at(moved(blobs, k2, dt / 2), dt / 2),
              k4 = motion.at(moved(blobs, k3, dt), dt);
  Rates mean(blobs.size());
  add(mean, 1.0 / 6, k1);
  add(mean, 1.0 / 3, k2);
  add(mean, 1.0 / 3, k3);
  add(mean, 1.0 / 6, k4);
  blobs = moved(blobs, mean, dt);
}

}  // namespace vortree::vortex

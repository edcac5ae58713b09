#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec2.hpp"

namespace vortree::vortex {

/// A symmetric 2 x 2 matrix by its entries in the frame of a unit vector n and t = (-n.y, n.x).
struct Covariance {
  double nn, nt, tt;
};

/// Velocity gradient of a flow free of divergence [1/s]: ux = du/dx = -dv/dy, uy = du/dy,
/// vx = dv/dx.
struct Gradient {
  double ux, uy, vx;
};

/// The traceless part of a blob's covariance [m^2]:
///
///   int (x - X)(x - X)^T omega dA / gamma = (sigma^2/2) I + D,   D = [[xx, xy], [xy, -xx]].
struct Deviator {
  double xx = 0, xy = 0;

  double size() const { return std::sqrt(xx * xx + xy * xy); }
  double across(Vec2 n) const { return xx * (n.x * n.x - n.y * n.y) + 2 * xy * n.x * n.y; }
  double tilt(Vec2 n) const { return xy * (n.x * n.x - n.y * n.y) - 2 * xx * n.x * n.y; }

  friend bool operator==(const Deviator&, const Deviator&) = default;
  friend Deviator operator+(Deviator a, Deviator b) { return {a.xx + b.xx, a.xy + b.xy}; }
  friend Deviator operator-(Deviator a, Deviator b) { return {a.xx - b.xx, a.xy - b.xy}; }
  friend Deviator operator*(double f, Deviator a) { return {f * a.xx, f * a.xy}; }
};

/// A core: sigma squared, twice the mean of the covariance's diagonal, and the covariance's
/// traceless part.
struct Core {
  double square;
  Deviator deviator{};

  /// In the frame of n.
  Covariance covariance(Vec2 n) const {
    const double across = deviator.across(n);
    return {square / 2 + across, deviator.tilt(n), square / 2 - across};
  }
};

/// Sigma of its marginal in the direction where it is widest.
inline double widest(const Core& core) {
  return std::sqrt(core.square + 2 * core.deviator.size());
}

/// The core of a covariance given in the frame of n.
inline Core core_of(const Covariance& v, Vec2 n) {
  const double half = (v.nn - v.tt) / 2, c = n.x * n.x - n.y * n.y, s = 2 * n.x * n.y;
  return {v.nn + v.tt, {half * c - v.nt * s, half * s + v.nt * c}};
}

/// These variances with as much of the tilt as leaves the core some width in every direction.
inline Covariance upright(const Covariance& v) {
  const double most = 0.95 * std::sqrt(v.nn * v.tt);
  return {v.nn, std::clamp(v.nt, -most, most), v.tt};
}

/// Core of points carried for a time dt >= 0 by a flow of constant gradient: V becomes F V F^T,
/// F = exp(G dt). det V stays.
inline Core carried(const Core& core, const Gradient& g, double dt) {
  const double q = g.ux * g.ux + g.uy * g.vx, r = std::sqrt(std::abs(q)) * dt;
  const double c = q > 0 ? std::cosh(r) : std::cos(r);
  const double k = r < 1e-8 ? dt : (q > 0 ? std::sinh(r) : std::sin(r)) / r * dt;
  const double f11 = c + k * g.ux, f12 = k * g.uy, f21 = k * g.vx, f22 = c - k * g.ux;
  const auto [xx, xy, yy] = core.covariance({1, 0});
  return core_of({f11 * f11 * xx + 2 * f11 * f12 * xy + f12 * f12 * yy,
                  f11 * f21 * xx + (f11 * f22 + f12 * f21) * xy + f12 * f22 * yy,
                  f21 * f21 * xx + 2 * f21 * f22 * xy + f22 * f22 * yy},
                 {1, 0});
}

}  // namespace vortree::vortex

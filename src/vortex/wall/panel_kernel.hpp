#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "base/angle_kernel.hpp"
#include "base/vec2.hpp"
#include "fmm/cores/log_kernel.hpp"
#include "vortex/wall/three_points.hpp"

namespace vortree::vortex::panel {

inline constexpr double inverse_two_pi = 0.5 * std::numbers::inv_pi;

/// Angle under which `at` sees the way from a to b.
inline double angle(Vec2 at, Vec2 a, Vec2 b) {
  const Vec2 p = a - at, q = b - at;
  return std::atan2(p.x * q.y - p.y * q.x, dot(p, q));
}

/// What three points about `at` see of a panel beyond the angle seen from there is the difference
/// of this at its two ends z: outer/2 arg(1 - arm^2/(z - at)^2).
inline double angle_aside(Vec2 at, const ThreePoints& points, Vec2 end) {
  const Vec2 d = end - at;
  const std::complex<double> z(d.x, d.y), arm2(points.arm_squared.re, points.arm_squared.im);
  return points.outer / 2 * std::arg(1.0 - arm2 / (z * z));
}

/// Velocity of a bare vortex of circulation 1 at `source`; none at its own place.
inline Vec2 point_velocity(Vec2 at, Vec2 source) {
  const Vec2 d = at - source;
  const double r2 = dot(d, d), w = r2 > 0 ? inverse_two_pi / r2 : 0;
  return {-w * d.y, w * d.x};
}

/// Velocity of a straight sheet of strength 1 from a to b: in the panel's frame (seen, along)/(2
/// pi) with a sign from u - i v = log((z - a)/(z - b))/(2 pi i).
inline Vec2 velocity(Vec2 at, Vec2 a, Vec2 b) {
  const Vec2 p = at - a, q = at - b, d = b - a;
  const double along = 0.5 * std::log(dot(p, p) / dot(q, q));
  const Vec2 t = (1 / std::sqrt(dot(d, d))) * d;
  const double parallel = -inverse_two_pi * angle(at, a, b), across = inverse_two_pi * along;
  return {parallel * t.x - across * t.y, parallel * t.y + across * t.x};
}

/// Stream function of a straight sheet of circulation 1 in all from a to b, -1/(2 pi) times the
/// mean of ln r along it.
inline double stream_function(Vec2 at, Vec2 a, Vec2 b) {
  const Vec2 p = at - a, q = at - b, d = b - a;
  const double length = std::sqrt(dot(d, d)), p2 = dot(p, p), q2 = dot(q, q);
  const auto end = [&](Vec2 r, double r2) { return r2 > 0 ? 0.5 * dot(r, d) * std::log(r2) : 0; };
  const double beside = (d.x * p.y - d.y * p.x) * angle(at, a, b);
  return -inverse_two_pi * ((end(p, p2) - end(q, q2) + std::abs(beside)) / (length * length) - 1);
}

/// The same in vectors, a panel a lane.

struct Vectors {
  Lanes x, y;
  friend Vectors operator-(Vec2 a, Vectors b) { return {a.x - b.x, a.y - b.y}; }
};
inline Lanes dot(Vectors a, Vectors b) {
  return a.x * b.x + a.y * b.y;
}

/// twin  angle
inline Lanes angles(Vec2 at, Vectors a, Vectors b) {
  const Vectors p = at - a, q = at - b;
  return angle_of(p.x * q.y - p.y * q.x, dot(p, q));
}

/// twin  angle_aside
inline Lanes angles_aside(Vec2 at, const ThreePoints& points, Vectors end) {
  const Vectors d = at - end;
  const Lanes re = d.x * d.x - d.y * d.y, im = 2.0 * d.x * d.y, size = dot(d, d);
  const auto [a, b] = points.arm_squared;
  return 0.5 * points.outer * angle_of(a * im - b * re, size * size - (a * re + b * im));
}

/// twin  point_velocity
inline Vectors point_velocities(Vec2 at, Vectors source, Lanes circulation = fill(1.0)) {
  const Vectors d = at - source;
  const Lanes r2 = dot(d, d), w = circulation * (r2 > 0.0 ? inverse_two_pi / r2 : Lanes{});
  return {-w * d.y, w * d.x};
}

/// chord  unit vectors from a to b
/// twin   velocity
inline Vectors velocities(Vec2 at, Vectors a, Vectors b, Vectors chord) {
  const Vectors p = at - a, q = at - b;
  const Lanes across = (0.5 * inverse_two_pi) * fmm::logarithm(dot(p, p) / dot(q, q));
  const Lanes parallel = -inverse_two_pi * angles(at, a, b);
  return {parallel * chord.x - across * chord.y, parallel * chord.y + across * chord.x};
}

/// ln r^2, 0 at r = 0.
inline Lanes finite_logarithm(Lanes r2) {
  return fmm::logarithm(r2 > 0.0 ? r2 : fill(1.0));
}

/// twin  stream_function
inline Lanes stream_functions(Vec2 at, Vectors a, Vectors b) {
  const Vectors p = at - a, q = at - b, d{b.x - a.x, b.y - a.y};
  const Lanes ends =
      0.5 * (dot(p, d) * finite_logarithm(dot(p, p)) - dot(q, d) * finite_logarithm(dot(q, q)));
  const Lanes beside = (p.x * d.y - p.y * d.x) * angle_of(p.x * q.y - p.y * q.x, dot(p, q));
  return -inverse_two_pi * ((ends + (beside < 0.0 ? -beside : beside)) / dot(d, d) - 1.0);
}

/// Of a bare vortex of circulation 1; none at its own place, as sums have it.
inline Lanes point_stream_functions(Vec2 at, Vectors source) {
  const Vectors d = at - source;
  return (-0.5 * inverse_two_pi) * finite_logarithm(dot(d, d));
}

}  // namespace vortree::vortex::panel

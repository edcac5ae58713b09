#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "base/vec2.hpp"
#include "fmm/direct.hpp"
#include "vortex/wall/wall.hpp"

/// Potential flow around a circle at the origin in closed form: the twin of every sheet.
namespace vortree::test {

using Complex = std::complex<double>;
inline constexpr Complex i_unit{0, 1};

inline Complex complex(Vec2 a) {
  return {a.x, a.y};
}
inline Vec2 vec2(Complex z) {
  return {z.real(), z.imag()};
}

/// u - i v of the stream 1 along x.
inline Complex stream_past(double radius, Complex z) {
  return 1.0 - radius * radius / (z * z);
}

/// u - i v of a vortex of circulation 1 at z0, by its image (-1) and what makes the body's
/// circulation `bound` at the centre.
inline Complex vortex_beside(double radius, Complex z0, double bound, Complex z) {
  const Complex image = radius * radius / std::conj(z0);
  return (1.0 / (z - z0) - 1.0 / (z - image) + (1 + bound) / z) / (2 * std::numbers::pi * i_unit);
}

/// Anticlockwise component of u - i v = w at the polar angle of z.
inline double swirl(Complex w, Complex z) {
  return -(w * z / std::abs(z)).imag();
}

/// Bare velocity of vortices where the wall samples it.
inline vortex::Velocities sampled(const vortex::Wall& wall, const vortex::FoldedBlobs& at,
                                  const std::vector<double>& gamma) {
  vortex::Velocities u(2 * wall.panels());
  const tree::Points samples = wall.samples();
  fmm::velocity_direct({at.x, at.y, gamma, {}}, {samples.x, samples.y, {}}, fmm::Cores::source, u.u,
                       u.v);
  return u;
}

/// The sheet that a stream along x calls for.
inline std::vector<double> sheet_of_stream(const vortex::Wall& wall) {
  const auto slip = wall.slip({1, 0}, vortex::Velocities(2 * wall.panels()), {}, {});
  return wall.sheet(slip, 0);
}

inline double polar_angle(Vec2 a) {
  return std::atan2(a.y, a.x);
}

}  // namespace vortree::test

#pragma once

#include <array>
#include <span>
#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// First and second derivatives of a field at a particle.
struct FieldSlopes {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  /// f(X) - f, X away from the particle, to second order.
  [[nodiscard]] double change(Vec2 by) const {
    return x * by.x + y * by.y + 0.5 * xx * by.x * by.x + xy * by.x * by.y + 0.5 * yy * by.y * by.y;
  }
};

/// Of all that a particle carries, in the order of `carried`.
using Slopes = std::array<FieldSlopes, carried_count>;

/// error   O(s^m) of first, O(s^(m - 1)) of second derivatives, m the stencils' degree
/// cost    25 fused operations a neighbor
void find_slopes(const Cloud& cloud, const Stencils& stencils, std::vector<Slopes>& slopes);

/// dv/dx - du/dy [1/T].
[[nodiscard]] inline double vorticity(const Slopes& of) {
  return of[1].x - of[0].y;
}

/// du/dx + dv/dy [1/T] of a velocity, at each particle.
void find_divergence(std::span<const double> u, std::span<const double> v, const Stencils& stencils,
                     std::span<double> divergence);

/// The gradient of a field.
void find_gradient(std::span<const double> f, const Stencils& stencils, std::span<double> fx,
                   std::span<double> fy);

/// What the particle carries, at a place `by` away.
[[nodiscard]] std::array<double, carried_count> carried_at(const Cloud& cloud, std::size_t i,
                                                           const Slopes& slopes, Vec2 by);

}  // namespace vortree::sph

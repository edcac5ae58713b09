#pragma once

#include <memory>
#include <span>
#include <vector>

#include "body/shape.hpp"
#include "fmm/plan.hpp"
#include "tree/order/points.hpp"

namespace vortree::sph {

/// The potentials of fluid at rest in which a body moves at speed one along e, either axis,
///
///   lap phi = 0,   wall   dphi/dn = n.e,   phi -> 0 far away,
///
/// made by sources q_j/(2 pi) ln|x - x_j| on the wall, q = strength times step of the arc:
///
///   strength_i/2 + sum_{j != i} q_j n_i.(x_i - x_j)/(2 pi r^2) + q_i curvature_i/(4 pi) = n_i.e
///
/// What a body that speeds up feels follows from them (its added mass and the fluid it displaces):
///
///   dipole = sum_j q_j x_j = area e - oint phi n ds
///
/// error   that of the trapezoidal rule, which falls faster than any power of the number of sources
///         n where the wall is smooth: exp(-2 pi d/step) at a distance d from it
/// cost    O(n^3) once; fmm/plan.hpp
/// source  Kress, Linear Integral Equations (1989), section 12.2, for the rule
class UnitPotentials {
 public:
  enum Axis { along_x, along_y };

  /// sources   at equal steps of the arc, the first at its beginning
  UnitPotentials(const body::Shape& shape, int sources);

  /// dphi/dx, dphi/dy. On the wall: in the middle between two sources only.
  void gradient(Axis axis, tree::Points at, std::span<double> x, std::span<double> y) const;

  [[nodiscard]] Vec2 dipole(Axis axis) const { return dipole_[axis]; }

 private:
  // As vortices, whose velocity is turned by 90 degrees.
  std::unique_ptr<const fmm::Plan> sources_[2];
  Vec2 dipole_[2];
};

}  // namespace vortree::sph

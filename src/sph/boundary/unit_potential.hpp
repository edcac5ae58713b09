#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "body/shape.hpp"
#include "fmm/plan.hpp"
#include "tree/order/points.hpp"

namespace vortree::sph {

/// The potentials of fluid at rest in which one of several bodies moves at speed one along e,
/// either axis,
///
///   lap phi = 0,   wall   dphi/dn = n.e, 0 on all others,   phi -> 0 far away,
///
/// made by sources q_j/(2 pi) ln|x - x_j| on all walls, q = strength times step of the arc:
///
///   strength_i/2 + sum_{j != i} q_j n_i.(x_i - x_j)/(2 pi r^2) + q_i curvature_i/(4 pi) = dphi/dn
///
/// The sum of the potentials of all bodies is that of all that move together. What they feel that
/// speed up follows from them (added mass and the fluid that one displaces):
///
///   dipole = sum_j q_j x_j = area e - oint phi n ds,   over all walls,
///
/// which along f is what the body feels along e where all speed up along f.
///
/// error   that of the trapezoidal rule, which falls faster than any power of the number of sources
///         n where the wall is smooth: exp(-2 pi d/step) at a distance d from it, as between walls
/// cost    O(n^3) once, n all sources; fmm/plan.hpp
/// source  Kress, Linear Integral Equations (1989), section 12.2, for the rule
class UnitPotentials {
 public:
  enum Axis { along_x, along_y };

  /// sources   of each curve of the shape (body/shape.hpp), at equal steps of the arc, the first at
  ///           its beginning
  UnitPotentials(const body::Shape& shape, const std::vector<int>& sources);
  UnitPotentials(const body::Shape& shape, int sources)
      : UnitPotentials(shape, std::vector{sources}) {}

  /// dphi/dx, dphi/dy of a body that moves. On the walls: in the middle between two sources only.
  void gradient(Axis axis, tree::Points at, std::span<double> x, std::span<double> y,
                std::size_t body = 0) const;

  [[nodiscard]] Vec2 dipole(Axis axis, std::size_t body = 0) const {
    return of_[body][axis].dipole;
  }

 private:
  /// Sources as vortices, whose velocity is turned by 90 degrees.
  struct Potential {
    std::unique_ptr<const fmm::Plan> sources{};
    Vec2 dipole{};
  };
  std::vector<std::array<Potential, 2>> of_;
};

}  // namespace vortree::sph

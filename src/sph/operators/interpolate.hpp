#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/derivatives.hpp"
#include "tree/order/points.hpp"

namespace vortree::sph {

/// A flow between its particles, a value a point.
///
/// covered   whether there are particles nearby; else all is 0
struct Interpolated {
  std::vector<double> u, v, omega, p;
  std::vector<char> covered;
};

/// (1 - q^2)^3, q = r/(1.5 s), of a particle whose volume is s^2, for a point `by` away from it: by
/// how much its series counts there; 0 from q = 1 on.
[[nodiscard]] double share_of_series(Vec2 by, double volume);

/// Taylor's series of the chosen particles nearer than 1.5 s to a point, weighted by
/// share_of_series:
///
///   u(x) = sum_j w_j (u_j + change_j(x - x_j)) / sum_j w_j
///
/// period  of a periodic square from the origin on, in which the points are; 0: none
/// error   O(s^3) of velocities and pressure, O(s^2) of the vorticity, with slopes of degree 2
/// cost    a neighbor search of particles and points
[[nodiscard]] Interpolated interpolate(const Cloud& cloud, const std::vector<Slopes>& slopes,
                                       std::span<const std::uint32_t> chosen, tree::Points at,
                                       double period = 0);

}  // namespace vortree::sph

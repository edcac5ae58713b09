#pragma once

#include <vector>

#include "flow/initial/initial_flow.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/operators/derivatives.hpp"

namespace vortree::sph {

/// Gives particles the velocity and the pressure of a flow at t = 0.
///
/// exact   as seen from where particles are seen from
void begin(Cloud& cloud, const flow::PeriodicFlow& exact);

/// What a flow in a periodic square has, and how far it is off the one known by heart; sums over
/// particles by their volumes.
///
/// volume            sum V [L^2]
/// momentum          sum V u [L^3/T]
/// energy            sum V |u|^2/2 [L^4/T^2]
/// enstrophy         sum V omega^2 [L^2/T^2]
/// velocity_error    sqrt(sum V |u - u_exact|^2 / sum V |u_exact|^2); of a flow that has decayed to
///                   less than a millionth of its velocity, in those of a millionth
/// pressure_error    the same of p, its mean taken off both, which decays with the square
struct PeriodicBudget {
  double volume = 0;
  Vec2 momentum{};
  double energy = 0, enstrophy = 0;
  double velocity_error = 0, pressure_error = 0;
};

[[nodiscard]] PeriodicBudget budget(const Cloud& cloud, const std::vector<Slopes>& slopes,
                                    const flow::PeriodicFlow& exact, double t);

}  // namespace vortree::sph

#pragma once

#include <span>
#include <vector>

#include "flow/paths/velocity_anywhere.hpp"

namespace vortree::flow {

/// The times at which the steps from one time to another begin and end, in order.
///
/// No step leads past a picture, where the cubics in time meet, and none takes the fastest fluid of
/// all pictures farther than the spacing of their grid.
[[nodiscard]] std::vector<double> steps_between(std::span<const VelocityPicture> pictures,
                                                double spacing, double from, double to);

/// Where the fluid at some places gets to in a time, forward or, if `to` is earlier, backward:
///
///   dX/dt = u(X, t),   X(from) = place
///
/// by the classical Runge-Kutta method in the steps of steps_between. What leaves the window or
/// comes to be within a body is lost: both its numbers are nan from then on.
///
/// pictures  as between() takes them, on the grid of `velocity`
/// error     O(D^4) in the time between pictures, O(spacing^4) in space, O(spacing^3) beside walls
/// cost      four velocities a place and step, two pictures a step; the same bits by any number of
///           threads
/// throws    std::invalid_argument as between()
[[nodiscard]] std::vector<Vec2> flow_map(std::vector<Vec2> places,
                                         std::span<const VelocityPicture> pictures,
                                         const VelocityAnywhere& velocity, double from, double to);

}  // namespace vortree::flow

#pragma once

#include <functional>

#include "vortex/acting.hpp"
#include "vortex/velocity.hpp"

namespace vortree::vortex {

/// Order of the time integration: midpoint rule, or the classical Runge-Kutta method.
enum class Scheme { rk2, rk4 };

/// The velocity with which blobs are carried, at their acting positions, so long after the
/// beginning of the step.
using Carrying = std::function<Velocities(const Blobs& blobs, const Acting& acting, double after)>;

/// Moves blobs for a time dt.
///
///   d X_i/dt = u(X_i),   X_i the acting position of blob i
///
/// Next to a wall the mean of the folded core is moved, and the core put back around it.
/// error   O(dt^2) for rk2, O(dt^4) for rk4, per unit of time
/// cost    two, or four, evaluations of the velocity
void convect(Blobs& blobs, const Carrying& velocity, const Shape* wall, Scheme scheme, double dt);

}  // namespace vortree::vortex

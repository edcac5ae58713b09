#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "vortex/setup.hpp"

namespace vortree::test {

/// The flow past a body of length 1 at the origin, coarse enough for a test.
inline vortex::Setup coarse_flow(std::unique_ptr<body::Shape> shape, const body::Motion& motion,
                                 Vec2 stream, double nu, double dt, int panels = 160) {
  vortex::Setup made{.problem = {.flow = {stream, nu, motion},
                                 .dt = dt,
                                 .advecting_cores = std::numbers::sqrt2,
                                 .sigma_0 = std::sqrt(2 * nu * dt),
                                 .splitting = {.sigma_max = std::sqrt(8 * nu * dt)},
                                 .merging = {.tolerance = 0.02,
                                             .reach = 3,
                                             .sigma_max = 1.1 * std::sqrt(8 * nu * dt)},
                                 .faintest = 1e-12,
                                 .sums = {.tolerance = 1e-5, .cores = fmm::Cores::mean}},
                     .scales = {.body = true, .impulsive = true}};
  made.wall = std::make_unique<vortex::Wall>(std::move(shape), panels);
  if (motion.turns()) made.turning = {vortex::Turning(*made.wall)};
  return made;
}

}  // namespace vortree::test

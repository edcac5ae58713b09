#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "vortex/setup.hpp"

namespace vortree::test {

/// The flow past bodies of length 1 or so, the first at the origin, coarse enough for a test.
///
/// motion  of all, in whose frame all is computed
/// own     of each in it
inline vortex::Setup coarse_flow(std::vector<vortex::WallBody> bodies,
                                 std::vector<body::Motion> own, const body::Motion& motion,
                                 Vec2 stream, double nu, double dt) {
  vortex::Setup made{.problem = {.flow = {stream, nu, motion, own},
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
  made.wall =
      std::make_shared<vortex::MovingWall>(std::move(bodies), std::move(own), motion.turns());
  return made;
}

/// The same past a single one.
inline vortex::Setup coarse_flow(std::unique_ptr<body::Shape> shape, const body::Motion& motion,
                                 Vec2 stream, double nu, double dt, int panels = 160) {
  vortex::Setup made = coarse_flow({{std::move(shape), panels}}, {{}}, motion, stream, nu, dt);
  made.problem.flow.own.clear();
  return made;
}

}  // namespace vortree::test

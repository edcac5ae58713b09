#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "body/group.hpp"
#include "vortex/setup.hpp"

namespace vortree::test {

/// A flow without a wall yet, coarse enough for a test beside bodies of length 1.
inline vortex::Setup coarse_flow(const vortex::Flow& flow, double dt) {
  const double nu = flow.nu;
  vortex::Setup made{.problem = {.flow = flow,
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
  return made;
}

/// The flow past a body of length 1 at the origin.
inline vortex::Setup coarse_flow(std::unique_ptr<body::Shape> shape, const body::Motion& motion,
                                 Vec2 stream, double nu, double dt, int panels = 160) {
  vortex::Setup made = coarse_flow({stream, nu, motion}, dt);
  made.wall = std::make_unique<vortex::Wall>(std::move(shape), panels);
  if (motion.turns()) made.turning = {vortex::Turning(*made.wall)};
  return made;
}

/// One of several bodies, that stands at `centre`.
inline vortex::WallBody standing(std::shared_ptr<const body::Shape> shape, Vec2 centre,
                                 int panels = 160) {
  return {std::make_shared<body::Placed>(std::move(shape), centre), panels, centre};
}

/// The flow past several bodies, which turn as flow.own says.
inline vortex::Setup coarse_flow(const std::vector<vortex::WallBody>& bodies,
                                 const vortex::Flow& flow, double dt) {
  vortex::Setup made = coarse_flow(flow, dt);
  made.wall = std::make_unique<vortex::Wall>(bodies);
  if (!flow.own.empty()) made.turning = vortex::turnings(*made.wall, bodies);
  return made;
}

}  // namespace vortree::test

#pragma once

#include <memory>

#include "io/scene.hpp"
#include "vortex/step.hpp"

namespace vortree::app {

/// A scene made into what the solver works on; owns what the Problem points at.
struct FlowCase {
  std::unique_ptr<vortex::Wall> wall;  // none in free space
  std::unique_ptr<vortex::Velocity> velocity;
  vortex::Problem problem;

  /// Lengths and speeds that make coefficients: D and U (of the stream or, without one, the
  /// greatest of the plunge). Without a body, or without both, they are 1.
  double diameter = 1, speed = 1;

  /// Where drag points to: down the stream; without one, the way of the plunge, or x.
  vortex::Vec2 along{1, 0};
};

FlowCase flow_case(const io::Scene& scene);

/// The vorticity at t = 0, before any wall has released its sheet.
vortex::Blobs initial_blobs(const io::Scene& scene);

}  // namespace vortree::app

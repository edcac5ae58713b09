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

  /// Lengths and speeds that make coefficients: D and U. Without a body or a stream they are 1.
  double diameter = 1, speed = 1;
};

FlowCase flow_case(const io::Scene& scene);

/// The vorticity at t = 0, before any wall has released its sheet.
vortex::Blobs initial_blobs(const io::Scene& scene);

}  // namespace vortree::app

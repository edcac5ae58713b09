#pragma once

#include "base/vec2.hpp"
#include "body/motion.hpp"

namespace vortree::sph {

/// What surrounds the particles, in the frame of the bodies, which does not turn.
///
/// nu       kinematic viscosity [L^2/T]
/// steady   the stream in the frame at rest [L/T]
/// motion   of all bodies; the stream that they meet is steady - dX/dt
struct Ambient {
  double nu = 0;
  Vec2 steady{};
  body::Motion motion{};

  [[nodiscard]] Vec2 stream(double t) const {
    return motion.travels() ? steady - motion.at(t).velocity : steady;
  }
};

}  // namespace vortree::sph

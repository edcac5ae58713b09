#pragma once

#include "base/vec2.hpp"
#include "body/motion.hpp"

namespace vortree::sph {

/// What surrounds the particles, in the frame of the body, which does not turn.
///
/// nu       kinematic viscosity [L^2/T]
/// steady   the stream in the frame at rest [L/T]
/// motion   of the body; the stream that it meets is steady - dX/dt. Its wall turns about the
///          origin at a steady rate
struct Ambient {
  double nu = 0;
  Vec2 steady{};
  body::Motion motion{};

  [[nodiscard]] Vec2 stream(double t) const {
    return motion.travels() ? steady - motion.at(t).velocity : steady;
  }
  [[nodiscard]] Vec2 wall_velocity(Vec2 at) const { return motion.spin.rate * left_of(at); }
  [[nodiscard]] Vec2 wall_acceleration(Vec2 at) const {
    return -motion.spin.rate * motion.spin.rate * at;
  }
};

}  // namespace vortree::sph

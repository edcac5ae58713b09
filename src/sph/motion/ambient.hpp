#pragma once

#include "base/vec2.hpp"
#include "body/motion.hpp"

namespace vortree::sph {

/// What surrounds the particles, in the frame of the body, which does not turn.
///
/// nu       kinematic viscosity [L^2/T]
/// steady   the stream in the frame at rest [L/T]
/// plunge   of the body; the stream that it meets is steady - dX/dt
/// spin     of the wall about the origin
struct Ambient {
  double nu = 0;
  Vec2 steady{};
  body::Plunge plunge{};
  body::Spin spin{};

  [[nodiscard]] Vec2 stream(double t) const {
    return plunge.frequency > 0 ? steady - plunge.velocity(t) : steady;
  }
  [[nodiscard]] Vec2 wall_velocity(Vec2 at) const { return spin.rate * Vec2{-at.y, at.x}; }
  [[nodiscard]] Vec2 wall_acceleration(Vec2 at) const { return -spin.rate * spin.rate * at; }
};

}  // namespace vortree::sph

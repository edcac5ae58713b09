#pragma once

#include "base/vec2.hpp"
#include "flow/case.hpp"

namespace vortree::flow {

/// What makes numbers without units of a flow: the length D of a body and the speed U of the stream
/// or, without one, the greatest of the body's motion; those of an initial flow that fills the
/// plane. Without a body, or without both, they are 1.
///
/// body       there is one
/// along      where drag points to: down the stream; without one, the way of a plunge, or against
///            the fastest motion; else x
/// impulsive  the body starts in a fluid that does not yet know of it
struct Scales {
  bool body = false;
  double length = 1, speed = 1;
  Vec2 along{1, 0};
  bool impulsive = false;

  Vec2 across() const { return {-along.y, along.x}; }

  /// U t/R, R half the length; t itself where there is no body.
  double T(double t) const { return body ? 2 * speed * t / length : t; }

  /// A force per unit density [L^3/T^2] times this is its coefficient.
  double of_force() const { return 2 / (speed * speed * length); }
};

/// By the body, stream and motion of a scene.
[[nodiscard]] Scales scales_of(const Case& of);

}  // namespace vortree::flow

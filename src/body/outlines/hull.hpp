#pragma once

#include <array>
#include <functional>

#include "base/vec2.hpp"

namespace vortree::body {

/// A polygon of sixteen sides around a curve, two of them along it where it is thinnest: who is
/// farther than d from one of its sides is farther than that from the curve.
class Hull {
 public:
  /// centre   within the curve
  /// support  how far the curve reaches in a direction (a unit vector) from the centre, or more
  Hull(Vec2 centre, const std::function<double(Vec2 direction)>& support);

  /// Never true within d of the curve.
  /// cost  6 ns
  [[nodiscard]] bool beyond(Vec2 at, double d) const;

 private:
  static constexpr int sides = 16;

  Vec2 centre_;
  std::array<double, sides> x_{}, y_{}, reach_{};
};

}  // namespace vortree::body

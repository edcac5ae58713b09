#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "body/motion.hpp"
#include "body/settings.hpp"
#include "body/shape.hpp"

namespace vortree::body {

/// What a scene says of how its body moves.
[[nodiscard]] Motion motion_of(const std::optional<PlungeSettings>&,
                               const std::optional<MotionSettings>&);

/// A body of a flow, whatever computes it.
///
/// shape   as seen from its centre
/// centre  at t = 0, in the scene
/// motion  of all bodies together
/// own     beside that
/// panels  so many pieces of its wall are told apart, shorter where it bends (grading.hpp)
struct Body {
  std::shared_ptr<const Shape> shape;
  Vec2 centre{};
  Motion motion{}, own{};
  int panels = 0;
};
using Bodies = std::vector<Body>;

}  // namespace vortree::body

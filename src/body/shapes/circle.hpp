#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// A circle, whose first point is that in x from its centre.
/// throws  std::invalid_argument unless radius > 0
std::unique_ptr<Shape> circle(Vec2 centre, double radius);

}  // namespace vortree::body

#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

struct ShapeKind;

/// A circle, whose first point is that in x from its centre.
/// throws  std::invalid_argument unless radius > 0
std::unique_ptr<Shape> circle(Vec2 centre, double radius);

extern const ShapeKind circle_kind;

}  // namespace vortree::body

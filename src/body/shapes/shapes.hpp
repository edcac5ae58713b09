#pragma once

#include <memory>
#include <span>

#include "base/kinds.hpp"
#include "body/settings.hpp"
#include "body/shape.hpp"

// The shapes of bodies that a scene can name. Each is a file of this room, which has its numbers,
// its length and its curve, and a word in the list of shapes.cpp. What else is asked of a shape
// follows from its outline (body/extent.hpp).

namespace vortree::body {

/// length  the size D that coefficients and the Reynolds number go by [L]
/// draw    the outline about the origin, turned clockwise by the body's incidence
///
/// Both take numbers that `refuse` lets pass.
struct ShapeKind : Kind {
  double (*length)(const BodySettings&);
  std::unique_ptr<Shape> (*draw)(const BodySettings&);
};

/// All of them; the first is that of a body whose scene names none.
[[nodiscard]] std::span<const ShapeKind* const> shape_kinds();

/// The outline of a body about the origin.
/// cost    0.15 ms
/// throws  std::invalid_argument if a number is lacking or out of its limits
[[nodiscard]] std::unique_ptr<Shape> outline_of(const BodySettings& body);

}  // namespace vortree::body

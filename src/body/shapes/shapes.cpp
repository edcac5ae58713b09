#include "body/shapes/shapes.hpp"

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"

namespace vortree::body {

std::span<const ShapeKind* const> shape_kinds() {
  static constexpr const ShapeKind* all[] = {&circle_kind, &ellipse_kind, &naca0012_kind};
  return all;
}

std::unique_ptr<Shape> outline_of(const BodySettings& body) {
  return body.shape->draw(body);
}

}  // namespace vortree::body

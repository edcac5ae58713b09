#include "body/shapes/shapes.hpp"

// Each is `const ShapeKind& NAME_kind()` in a file of this folder.
// clang-format off
#define VORTREE_SHAPES(kind) \
  kind(circle) \
  kind(ellipse) \
  kind(naca0012) \
  kind(naca4) \
  kind(joukowski) \
  kind(plate) \
  kind(polygon) \
  kind(points)
// clang-format on

namespace vortree::body {

#define DECLARED(name) const ShapeKind& name##_kind();
VORTREE_SHAPES(DECLARED)
#undef DECLARED

std::span<const ShapeKind* const> shape_kinds() {
#define LISTED(name) &name##_kind(),
  static const ShapeKind* const all[] = {VORTREE_SHAPES(LISTED)};
#undef LISTED
  return all;
}

std::unique_ptr<Shape> outline_of(const BodySettings& body) {
  return body.shape->draw(body);
}

}  // namespace vortree::body

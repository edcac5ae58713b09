#include "body/shapes/ellipse.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "body/outlines/outline.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

void require_half_axis(double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw std::invalid_argument("half axis of the ellipse is " + tree::told(value) +
                                "; must be > 0");
}

double length(const BodySettings& body) {
  return 2 * body.number("radius");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return ellipse({}, body.number("radius"), body.number("across"), body.turn());
}

}  // namespace

const ShapeKind& ellipse_kind() {
  static const ShapeKind kind{{"ellipse",
                               {{"radius", positive, "L", "half the long axis"},
                                {"across", positive, "L", "half the other axis"}}},
                              length,
                              draw};
  return kind;
}

std::unique_ptr<Shape> ellipse(Vec2 centre, double a, double b, double incidence) {
  require_half_axis(a);
  require_half_axis(b);
  return outline([=, place = Placement(centre, incidence)](double t) {
    const double c = std::cos(t), s = std::sin(t);
    return place({{a * c, b * s}, {-a * s, b * c}, {-a * c, -b * s}});
  });
}

}  // namespace vortree::body

#include "body/shapes/naca0012.hpp"

#include "body/shapes/naca4.hpp"
#include "body/shapes/shapes.hpp"

namespace vortree::body {
namespace {

double length(const BodySettings& body) {
  return body.number("chord");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return naca0012({}, body.number("chord"), body.number("edge"), body.turn());
}

constexpr Rule edges{.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"};

}  // namespace

const ShapeKind& naca0012_kind() {
  static const ShapeKind kind{{"naca0012",
                               {{"chord", positive, "L", "its length"},
                                {"edge", edges, "chord", "radius of the trailing edge", 0.005}}},
                              length,
                              draw};
  return kind;
}

std::unique_ptr<Shape> naca0012(Vec2 centre, double chord, double edge, double incidence) {
  return naca4(centre, "0012", chord, edge, incidence);
}

}  // namespace vortree::body

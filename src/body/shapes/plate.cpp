#include "body/shapes/plate.hpp"

#include <numbers>
#include <stdexcept>
#include <string>

#include "base/rounded.hpp"
#include "body/outlines/bend.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

double length(const BodySettings& body) {
  return body.number("length");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return plate({}, body.number("length"), body.number("thickness"), body.turn());
}

void hold(const BodySettings& body) {
  const double length = body.number("length"), thickness = body.number("thickness");
  if (2 * thickness < length) return;
  throw Refused("body.thickness", "body.thickness is " + rounded(thickness, 6) +
                                      "; less than half of body.length = " + rounded(length, 6) +
                                      " was expected");
}

}  // namespace

const ShapeKind& plate_kind() {
  static const ShapeKind kind{
      {"plate",
       {{"length", positive, "L", "from end to end"},
        {"thickness", positive, "L", "between its flat sides; its ends are round"}}},
      length,
      draw,
      "",
      hold};
  return kind;
}

std::unique_ptr<Shape> plate(Vec2 centre, double length, double thickness, double incidence) {
  if (!(thickness > 0 && length > 2 * thickness))
    throw std::invalid_argument("plate of length " + tree::told(length) + " and thickness " +
                                tree::told(thickness) + "; must be length > 2 thickness > 0");
  using std::numbers::pi;
  const Bend end{thickness / (2 * Bend{1, pi}.end().y), pi};
  const double x = length / 2, flat = x - end.end().x, y = thickness / 2;
  // From the tip in x on, which is so one of the places of the trace.
  return chained(
      {end.stretch({x, 0}, 0, 0, 1), line({flat, y}, {-flat, y}), end.stretch({-x, 0}, pi, -1, 1),
       line({-flat, -y}, {flat, -y}), end.stretch({x, 0}, 0, -1, 0)},
      Placement(centre, incidence));
}

}  // namespace vortree::body

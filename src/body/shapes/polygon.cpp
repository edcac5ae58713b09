#include "body/shapes/polygon.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/rounded.hpp"
#include "body/outlines/bend.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

using std::numbers::pi;

double length(const BodySettings& body) {
  return 2 * body.number("radius");
}

int sides_of(const BodySettings& body) {
  return static_cast<int>(body.number("sides"));
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return polygon({}, sides_of(body), body.number("radius"), body.number("corner"), body.turn());
}

void hold(const BodySettings& body) {
  const double sides = body.number("sides"), corner = body.number("corner");
  if (sides != std::floor(sides))
    throw Refused("body.sides",
                  "body.sides is " + rounded(sides, 6) + "; a whole number was expected");
  if (const double most = roundest_corner(sides_of(body), body.number("radius")); !(corner < most))
    throw Refused("body.corner", "body.corner is " + rounded(corner, 6) + "; less than " +
                                     rounded_down(most, 4) +
                                     " was expected, with which nothing is left of the sides");
}

constexpr Rule three_to_64{.low = 3, .high = 64, .words = "it must lie in 3 .. 64"};

}  // namespace

const ShapeKind& polygon_kind() {
  static const ShapeKind kind{
      {"polygon",
       {{"sides", three_to_64, "", "how many it has, all alike; one of them faces -x"},
        {"radius", positive, "L", "half its length: to the corners, before they are rounded"},
        {"corner", positive, "L", "least radius of its corners, which are round"}}},
      length,
      draw,
      "",
      hold};
  return kind;
}

double roundest_corner(int sides, double radius) {
  // From where lines would meet to an end of the bend, of radius 1; a side has two of these.
  const Bend bend{1, 2 * pi / sides};
  const double cut = bend.end().y / std::cos(pi / sides);
  return radius * std::sin(pi / sides) / cut;
}

std::unique_ptr<Shape> polygon(Vec2 centre, int sides, double radius, double corner,
                               double incidence) {
  if (!(sides >= 3 && corner > 0 && corner < roundest_corner(sides, radius)))
    throw std::invalid_argument("polygon of " + std::to_string(sides) + " sides, radius " +
                                tree::told(radius) + ", corners of " + tree::told(corner) +
                                "; must be sides >= 3 and corners that leave some of the sides");
  const Bend bend{corner, 2 * pi / sides};
  const double tip = radius - bend.cut();
  const auto [inward, along] = bend.end();
  std::vector<Stretch> all;
  for (int k = 0; k < sides; ++k) {
    const double here = pi + (k + 0.5) * bend.turns, next = here + bend.turns;
    const Vec2 out{std::cos(here), std::sin(here)}, then{std::cos(next), std::sin(next)};
    const Vec2 ahead{-out.y, out.x}, back{then.y, -then.x};
    // The first is cut in two, so that its tip is the first place.
    all.push_back(bend.stretch(tip * out, here, k == 0 ? 0 : -1, 1));
    all.push_back(line((tip - inward) * out + along * ahead, (tip - inward) * then + along * back));
    if (k + 1 == sides) all.push_back(bend.stretch(tip * then, next, -1, 0));
  }
  return chained(all, Placement(centre, incidence));
}

}  // namespace vortree::body

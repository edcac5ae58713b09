#include "body/settings.hpp"

#include <numbers>

#include "body/shapes/shapes.hpp"

namespace vortree::body {

const ShapeKind* first_shape() {
  return shape_kinds().front();
}

Dimensions numbers_of_shapes() {
  return dimensions_of(as_kinds(shape_kinds()));
}

double BodySettings::number(std::string_view name) const {
  return number_of(*shape, numbers, name);
}

double BodySettings::turn() const {
  return incidence * std::numbers::pi / 180;
}

namespace {

/// What is no number: digits, and points, which may come from a file.
struct OtherKey {
  std::string_view name, word;
  bool written;
};

void hold_others(const BodySettings& body) {
  const auto words = [&](const char* that, std::string_view word) {
    return "body.shape is \"" + std::string(body.shape->name) + "\"; that " + that +
           " the key body." + std::string(word);
  };
  for (const auto& [name, word, written] : {OtherKey{"digits", "digits", body.digits.has_value()},
                                            OtherKey{"points", "file", body.file.has_value()},
                                            OtherKey{"points", "points", body.points.has_value()}})
    if (written && body.shape->also != name)
      throw Refused("body." + std::string(word), words("does not have", word));
  if (body.shape->also == "digits" && !body.digits) throw Refused("body", words("needs", "digits"));
  if (body.shape->also == "points" && !body.points)
    throw Refused("body", words("needs", "file, or points"));
}

}  // namespace

void refuse(const BodySettings& body) {
  hold_dimensions(*body.shape, "body", "shape", body.numbers);
  hold_others(body);
  body.shape->hold(body);
}

std::vector<std::string> told_of(const BodySettings& body) {
  return body.shape->told(body);
}

std::vector<Key> keys(BodySettings& body) {
  std::vector<Key> all = keys_of(as_kinds(shape_kinds()), "shape", "outline of the body",
                                 one_of(shape_kinds(), body.shape), body.numbers);
  for (Key one :
       {key("digits", body.digits, anything, "",
            "naca4, which needs it: its four digits, as \"2412\""),
        key("file", body.file, anything, "",
            "points, which needs it or `body.points`: places along the outline, in the layout of "
            "Selig or Lednicer or two columns; relative to the folder of the scene"),
        key("points", body.points, anything, "",
            "the same as [x, y, x, y, ...]; read from `body.file` where they are not written"),
        key("incidence", body.incidence,
            {.low = -180, .high = 180, .words = "it must lie in -180 .. 180 degrees"}, "degrees",
            "by how much the long axis or the chord is turned clockwise from x"),
        key("centre", body.centre, anything, "L",
            "place [x, y] of the centre; of a foil, of the middle of its chord"),
        key("panels", body.panels, {.low = 8, .words = "a body needs at least 8 panels"}, "",
            "wall elements around the body, shorter where it bends or is thin"),
        inner("motion", body.motion,
              "how one of several bodies moves beside what [motion] has all do")})
    all.push_back(std::move(one));
  return all;
}

std::vector<Key> keys(PlungeSettings& plunge) {
  return {
      key("amplitude", plunge.amplitude, required(positive), "L",
          "the body moves by amplitude cos(2 pi frequency t), without turning"),
      key("frequency", plunge.frequency, required(positive), "1/T", "periods in a unit of time"),
      key("direction", plunge.direction, anything, "",
          "along which it moves, [x, y] of any length but 0")};
}

void refuse(const MotionSettings& motion) {
  if (!motion.given_by_time() && motion.spin == 0)
    throw Refused("motion", "[motion] needs one of the keys x, y, angle, file, spin");
  if (motion.file && (motion.x || motion.y || motion.angle))
    throw Refused("motion.file",
                  "motion.file has columns x, y, angle; write it or motion.x, y, angle, not both");
  if (motion.angle && motion.spin != 0)
    throw Refused("motion.spin", "motion.spin and motion.angle both turn the body; write one");
}

std::vector<Key> keys(MotionSettings& motion) {
  return {
      key("x", motion.x, anything, "L",
          "by how much the body moves along x, an expression of t, as \"0.1*cos(2*pi*t)\""),
      key("y", motion.y, anything, "L", "likewise along y"),
      key("angle", motion.angle, anything, "degrees",
          "by how much it is turned anticlockwise, likewise"),
      key("about", motion.about, anything, "L",
          "place [x, y] about which it turns, as seen from its centre at angle 0"),
      key("file", motion.file, anything, "",
          "CSV file of t and x, y, angle or some of them, instead of expressions; between its rows "
          "a cubic spline; its place is as seen from the scene's"),
      key("spin", motion.spin, anything, "1/T",
          "angle a unit of time by which a circle turns about its centre, anticlockwise, in "
          "radians")};
}

}  // namespace vortree::body

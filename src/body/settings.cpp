#include "body/settings.hpp"

namespace vortree::body {

std::vector<Key> keys(BodySettings& body) {
  return {
      key("shape", body.shape, "outline of the body"),
      key("radius", body.radius, positive, "L",
          "radius of a circle, half the long axis of an ellipse: both need it"),
      key("across", body.across, positive, "L",
          "half the other axis of an ellipse, which needs it"),
      key("chord", body.chord, positive, "L", "length of the section naca0012, which needs it"),
      key("edge", body.edge, {.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"},
          "chord", "radius of the trailing edge of naca0012, 0.005 if not written"),
      key("incidence", body.incidence,
          {.low = -180, .high = 180, .words = "it must lie in -180 .. 180 degrees"}, "degrees",
          "by how much the long axis or the chord is turned clockwise from x"),
      key("centre", body.centre, anything, "L",
          "place [x, y] of the centre; of naca0012, of the middle of its chord"),
      key("panels", body.panels, {.low = 8, .words = "a body needs at least 8 panels"}, "",
          "wall elements around the body")};
}

std::vector<Key> keys(PlungeSettings& plunge) {
  return {
      key("amplitude", plunge.amplitude, required(positive), "L",
          "the body moves by amplitude cos(2 pi frequency t), without turning"),
      key("frequency", plunge.frequency, required(positive), "1/T", "periods in a unit of time"),
      key("direction", plunge.direction, anything, "",
          "along which it moves, [x, y] of any length but 0")};
}

std::vector<Key> keys(MotionSettings& motion) {
  return {key("spin", motion.spin, required(anything), "1/T",
              "angle a unit of time by which a circle turns about its centre, anticlockwise, in "
              "radians")};
}

}  // namespace vortree::body

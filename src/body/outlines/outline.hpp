#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "body/outlines/piece.hpp"
#include "body/shape.hpp"

namespace vortree::body {

/// Turns a curve clockwise about the origin by incidence (radians), then moves the origin to the
/// centre.
class Placement {
 public:
  Placement(Vec2 centre, double incidence)
      : centre_(centre), c_(std::cos(incidence)), s_(std::sin(incidence)) {}

  CurvePoint operator()(const CurvePoint& p) const {
    return {centre_ + turned(p.at), turned(p.first), turned(p.second)};
  }

 private:
  Vec2 turned(Vec2 a) const { return {c_ * a.x + s_ * a.y, -s_ * a.x + c_ * a.y}; }

  Vec2 centre_;
  double c_, s_;
};

/// The shape with that outline. The curve is asked only while it is drawn: 128 stretches of its
/// parameter, and more where it bends or changes fast, become polynomials (body/outlines/piece.hpp)
/// without more error than the round-off of the formula. The nearest place is sought by Newton's
/// method from the nearest of their chords.
///
/// breaks  parameters where the second derivative jumps, or the speed; the direction does not
/// error   round-off of place, distance, normal, arc length and curvature: 1e-13 of the largest
///         second derivative nearby (tests/body/outline.cpp)
/// cost    0.2 us for a nearest point; 0.4 ms and 0.1 MB for drawing a foil
std::unique_ptr<Shape> outline(const Curve& curve, const std::vector<double>& breaks = {});

}  // namespace vortree::body

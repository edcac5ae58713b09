#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// A place on a curve and its first two derivatives with respect to the parameter.
struct CurvePoint {
  Vec2 at, first, second;
};

/// A closed curve given by a parameter from 0 to 2 pi, anticlockwise, twice differentiable and
/// never standing still.
using Curve = std::function<CurvePoint(double parameter)>;

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

/// The shape with that outline. The nearest place is sought by Newton's method from the best of 512
/// places along the curve; arc length by Gauss's rule in as many pieces, inverted by Newton's
/// method. Places stand at even steps of the parameter, which should be slow where the curve bends.
/// error   round-off, as far as the curve is smooth
/// cost    0.3 us for a nearest point
std::unique_ptr<Shape> outline(Curve curve);

}  // namespace vortree::body

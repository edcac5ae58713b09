#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "vortex/shape.hpp"

namespace vortree::vortex {

/// A place on a curve and its first two derivatives with respect to the parameter.
struct CurvePoint {
  Vec2 at, first, second;
};

/// A closed curve given by a parameter from 0 to 2 pi, anticlockwise, twice differentiable and
/// never standing still.
using Curve = std::function<CurvePoint(double parameter)>;

/// The shape with that outline. The nearest place is sought by Newton's method from the best of
/// some hundred places along the curve; arc length by Gauss's rule in as many pieces, inverted by
/// Newton's method.
/// error   round-off, as far as the curve is smooth
/// cost    0.3 us for a nearest point
std::unique_ptr<Shape> outline(Curve curve);

/// An ellipse of half axes a, along a direction turned by -incidence from x (nose up for a stream
/// along x), and b. incidence in radians.
std::unique_ptr<Shape> ellipse(Vec2 centre, double a, double b, double incidence);

}  // namespace vortree::vortex

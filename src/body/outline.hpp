#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "body/shape.hpp"

namespace vortree::body {

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

/// The section NACA 0012 about the middle of its chord, the nose towards -x, turned nose up by
/// incidence (radians), with a rounded trailing edge. In shares of the chord, for 0 <= x <= 1,
///
///   y = +- (0.6 (0.2969 sqrt x - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - 0.1036 x^4) + edge x^4)
///          * sqrt((1 - x)/(1 - x + edge/2))
///
/// The polynomial is that of the section with a closed, sharp edge of 17 degrees; the term in x^4
/// leaves it 2 edge thick at x = 1 (as much as in the section as published, whose last coefficient
/// is 0.1015, for edge = 0.00126), and the root rounds that off with the radius edge. The chord is
/// not shortened. The parameter is that of x = cos^2(t/2): its places stand closer towards both
/// ends, at the trailing edge sqrt(edge/2) chords a radian.
/// What the rounding does: the edge has no fixed line of separation any more, so that a stream
/// without viscosity turns around it (the faster, the sharper it is) until vorticity is shed.
/// Panels of 0.7 edge keep the sheet of such a stream to 5e-4, panels twice as long to 2 % only.
/// throws  std::invalid_argument unless 1e-4 <= edge <= 0.02
/// source  Jacobs, Ward & Pinkerton, NACA Report 460 (1933)
std::unique_ptr<Shape> naca0012(Vec2 centre, double chord, double edge, double incidence);

}  // namespace vortree::body

#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

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
/// throws  std::invalid_argument unless chord > 0 and 1e-4 <= edge <= 0.02
/// source  Jacobs, Ward & Pinkerton, NACA Report 460 (1933)
std::unique_ptr<Shape> naca0012(Vec2 centre, double chord, double edge, double incidence);

}  // namespace vortree::body

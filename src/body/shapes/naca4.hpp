#pragma once

#include <memory>
#include <string_view>

#include "body/shape.hpp"

namespace vortree::body {

/// The section NACA `digits`: camber in hundredths of the chord, its place in tenths, thickness in
/// hundredths. It stands about the middle of its chord, the nose towards -x, turned nose up by
/// incidence (radians), with a rounded trailing edge. In shares of the chord, for 0 <= x <= 1, half
/// the thickness t is
///
///   y = (5 t (0.2969 sqrt x - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - 0.1036 x^4) + edge x^4)
///          * sqrt((1 - x)/(1 - x + edge/2))
///
/// and stands square upon the mean line, of camber m at x = p, slope tan theta,
///
///   y_c = m/p^2 (2 p x - x^2), x < p;   m/(1 - p)^2 (1 - 2 p + 2 p x - x^2) behind it:
///   (x -+ y sin theta, y_c +- y cos theta).
///
/// The polynomial is that of the section with a closed, sharp edge (of 17 degrees for t = 0.12);
/// the term in x^4 leaves it 2 edge thick at x = 1 (as much as in the section as published, whose
/// last coefficient is 0.1015, for edge = 0.0105 t), and the root rounds that off with the radius
/// edge, or edge cos theta at the end of a mean line. The chord is not shortened. The parameter is
/// that of x = cos^2(t/2): its places stand closer towards both ends, at the trailing edge
/// sqrt(edge/2) chords a radian. Where the two parabolas of the mean line meet its curvature jumps,
/// and the outline has corners, of 3e-4 rad for "2412".
/// What the rounding does: the edge has no fixed line of separation any more, so that a stream
/// without viscosity turns around it (the faster, the sharper it is) until vorticity is shed.
/// Panels of 0.7 edge keep the sheet of such a stream to 5e-4, panels twice as long to 2 % only.
/// throws  std::invalid_argument unless chord > 0, 1e-4 <= edge <= 0.02 and the digits are such
/// source  Jacobs, Ward & Pinkerton, NACA Report 460 (1933)
std::unique_ptr<Shape> naca4(Vec2 centre, std::string_view digits, double chord, double edge,
                             double incidence);

}  // namespace vortree::body

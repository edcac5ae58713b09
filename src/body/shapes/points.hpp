#pragma once

#include <memory>
#include <span>

#include "body/shape.hpp"

namespace vortree::body {

/// The closed curve through points: a periodic cubic spline by the sum of the chords, so that its
/// curvature is continuous (body/shapes/from_points/spline.hpp). Clockwise ones are turned round. A
/// trailing edge, sharp or blunt, at the first point is rounded
/// (body/shapes/from_points/trailing_edge.hpp). Seen from the middle of the chord, if there is an
/// edge, or else of the rectangle that the points fill, and then turned clockwise by incidence
/// (radians).
///
/// coordinates  x, y, x, y, ... [L]
/// edge         least radius of a trailing edge, as a share of the chord
/// error        without an edge of fourth order in the spacing of the points
/// throws       BadPoint (body/shapes/from_points/contour.hpp) for points that make no outline
std::unique_ptr<Shape> through_points(std::span<const double> coordinates, double edge,
                                      double incidence);

}  // namespace vortree::body

#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// A regular polygon about its centre, one side of which faces -x before it is turned clockwise by
/// incidence (radians), with round corners, along which the curvature rises and falls smoothly
/// (body/outlines/bend.hpp).
///
/// radius  of the circle through its corners before they are rounded
/// corner  the least radius of curvature, at the tips; a corner is twice as long as an arc would be
/// throws  std::invalid_argument unless sides >= 3 and 0 < corner < roundest_corner
std::unique_ptr<Shape> polygon(Vec2 centre, int sides, double radius, double corner,
                               double incidence);

/// With so large a corner nothing is left of the sides.
double roundest_corner(int sides, double radius);

}  // namespace vortree::body

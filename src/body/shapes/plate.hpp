#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// A flat plate about its middle, along a direction turned by -incidence (radians) from x: two
/// lines, and round ends whose curvature rises smoothly from the lines to the tips, where the
/// radius is 0.410 of the thickness (body/outlines/bend.hpp).
///
/// length  from tip to tip
/// throws  std::invalid_argument unless length > 2 thickness > 0
std::unique_ptr<Shape> plate(Vec2 centre, double length, double thickness, double incidence);

}  // namespace vortree::body

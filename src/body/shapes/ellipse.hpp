#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// An ellipse of half axes a, along a direction turned by -incidence from x (nose up for a stream
/// along x), and b. incidence in radians.
/// throws  std::invalid_argument unless a > 0 and b > 0
std::unique_ptr<Shape> ellipse(Vec2 centre, double a, double b, double incidence);

}  // namespace vortree::body

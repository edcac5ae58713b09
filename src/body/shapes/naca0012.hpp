#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// The section NACA 0012 about the middle of its chord, the nose towards -x, turned nose up by
/// incidence (radians), with a rounded trailing edge: naca4 of "0012" (body/shapes/naca4.hpp).
/// throws  std::invalid_argument unless chord > 0 and 1e-4 <= edge <= 0.02
std::unique_ptr<Shape> naca0012(Vec2 centre, double chord, double edge, double incidence);

}  // namespace vortree::body

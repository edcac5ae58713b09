#pragma once

#include <vector>

#include "body/shape.hpp"
#include "sph/cloud/cloud.hpp"

namespace vortree::sph {

/// Area within an outline [L^2], of the polygon through 4096 places at equal steps of the arc.
[[nodiscard]] double area_of(const body::Shape& shape);

/// n nodes at equal steps of the arc of an outline, the first half a step from its first point.
[[nodiscard]] std::vector<BoundaryNode> wall_nodes(const body::Shape& shape, int n);

/// Nodes at a distance d from an outline, at equal steps of about `spacing` of the arc of that
/// line,
///
///   arc(s) = s + d theta(s),
///
/// s the arc of the outline, theta the angle by which its normal has turned. Those nearer to the
/// outline than 0.95 d, in a hollow of it, are left out.
///
/// shifted  by half a step, so that rings stand in the gaps of their neighbors
[[nodiscard]] std::vector<BoundaryNode> ring_nodes(const body::Shape& shape, double d,
                                                   double spacing, bool shifted);

}  // namespace vortree::sph

#include "body/outlines/touching_discs.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::body {

std::vector<double> touching_discs(const Shape& shape, const std::vector<OutlinePoint>& trace) {
  std::vector<double> radii;
  for (const OutlinePoint& one : trace) {
    const Vec2 normal = shape.nearest(one.at).normal;
    double most = std::abs(one.curvature);
    for (const OutlinePoint& other : trace) {
      const Vec2 d = one.at - other.at;
      const double square = dot(d, d);
      if (square > 0) most = std::max(most, 2 * std::abs(dot(normal, d)) / square);
    }
    radii.push_back(1 / most);
  }
  return radii;
}

}  // namespace vortree::body

#include "body/shape.hpp"

namespace vortree::body {

std::vector<OutlinePoint> Shape::trace() const {
  constexpr int places = 512;
  std::vector<OutlinePoint> all;
  for (int i = 0; i < places; ++i) {
    const double arc = perimeter() * i / places;
    const Vec2 at = point(arc);
    all.push_back({at, nearest(at).curvature, arc});
  }
  return all;
}

}  // namespace vortree::body

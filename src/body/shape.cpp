#include "body/shape.hpp"

namespace vortree::body {

std::vector<OutlinePoint> Shape::trace() const {
  constexpr int places = 512;
  std::vector<OutlinePoint> all;
  for (int i = 0; i < places; ++i) {
    const Vec2 at = point(perimeter() * i / places);
    all.push_back({at, nearest(at).curvature});
  }
  return all;
}

}  // namespace vortree::body

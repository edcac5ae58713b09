#include "sph/boundary/outer_box.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::sph {

double OuterBox::depth(Vec2 at) const {
  return std::min({at.x - low.x, high.x - at.x, at.y - low.y, high.y - at.y});
}

std::vector<BoundaryNode> box_nodes(const OuterBox& box, double spacing) {
  const auto steps = [&](double side) {
    return std::max(2, static_cast<int>(std::lround(side / spacing)));
  };
  const auto [width, height] = box.size();
  const int across = steps(width), up = steps(height);
  const double dx = width / across, dy = height / up;
  std::vector<BoundaryNode> nodes;
  for (int i = 1; i < across; ++i) nodes.push_back({{box.low.x + i * dx, box.low.y}, {0, 1}, dx});
  for (int j = 0; j <= up; ++j) nodes.push_back({{box.high.x, box.low.y + j * dy}, {-1, 0}, dy});
  for (int i = across - 1; i > 0; --i)
    nodes.push_back({{box.low.x + i * dx, box.high.y}, {0, -1}, dx});
  for (int j = up; j >= 0; --j) nodes.push_back({{box.low.x, box.low.y + j * dy}, {1, 0}, dy});
  return nodes;
}

bool corner(const OuterBox& box, Vec2 at) {
  const double near = 1e-9 * (box.size().x + box.size().y);
  const auto close = [&](double a, double b) { return std::abs(a - b) < near; };
  return (close(at.x, box.low.x) || close(at.x, box.high.x)) &&
         (close(at.y, box.low.y) || close(at.y, box.high.y));
}

}  // namespace vortree::sph

#include "fmm/cells.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::fmm {
namespace {

struct Box {
  double left, right, bottom, top;

  void include(const Box& other) {
    left = std::min(left, other.left), right = std::max(right, other.right);
    bottom = std::min(bottom, other.bottom), top = std::max(top, other.top);
  }
};

struct Shape {
  Box box;
  double core;
};

Shape around(const SortedPoints& points, tree::Range range) {
  Shape shape{
      {points.x[range.first], points.x[range.first], points.y[range.first], points.y[range.first]},
      0.0};
  for (std::uint32_t j = range.first; j < range.last; ++j) {
    shape.box.include({points.x[j], points.x[j], points.y[j], points.y[j]});
    shape.core = std::max(shape.core, points.core[j]);
  }
  return shape;
}

}  // namespace

CellShapes::CellShapes(const tree::Quadtree& tree, const SortedPoints& points) {
  const auto cells = tree.cells();
  for (auto* values : {&x, &y, &half_x, &half_y, &radius, &core}) values->resize(cells.size());
  std::vector<Box> boxes(cells.size());
  for (std::size_t c = cells.size(); c-- > 0;) {
    const tree::Cell& cell = cells[c];
    if (cell.childless()) {
      const Shape shape = around(points, cell.points);
      boxes[c] = shape.box, core[c] = shape.core;
    } else {
      boxes[c] = boxes[cell.children.first], core[c] = core[cell.children.first];
      for (std::uint32_t child = cell.children.first; child < cell.children.last; ++child) {
        boxes[c].include(boxes[child]);
        core[c] = std::max(core[c], core[child]);
      }
    }
    const Box& box = boxes[c];
    x[c] = 0.5 * (box.left + box.right), y[c] = 0.5 * (box.bottom + box.top);
    half_x[c] = std::max(box.right - x[c], x[c] - box.left);
    half_y[c] = std::max(box.top - y[c], y[c] - box.bottom);
    radius[c] = std::hypot(half_x[c], half_y[c]);
  }
}

}  // namespace vortree::fmm

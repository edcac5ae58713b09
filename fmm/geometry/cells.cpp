#include "fmm/geometry/cells.hpp"

#include <algorithm>
#include <cmath>

#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

struct CellShape {
  BoundingBox box;
  double core;
};

CellShape around(const SortedPoints& points, tree::Range range) {
  CellShape shape{
      {points.x[range.first], points.x[range.first], points.y[range.first], points.y[range.first]},
      0.0};
  for (std::uint32_t j = range.first; j < range.last; ++j) {
    shape.box.include({points.x[j], points.x[j], points.y[j], points.y[j]});
    shape.core = std::max(shape.core, points.core[j]);
  }
  return shape;
}

CellShape around_children(const std::vector<BoundingBox>& boxes, const Reals& core,
                          tree::Range children) {
  CellShape shape{boxes[children.first], core[children.first]};
  for (std::uint32_t child = children.first; child < children.last; ++child) {
    shape.box.include(boxes[child]);
    shape.core = std::max(shape.core, core[child]);
  }
  return shape;
}

}  // namespace

CellShapes::CellShapes(const tree::Quadtree& tree, const SortedPoints& points) {
  for (auto* values : {&x, &y, &half_x, &half_y, &radius, &core}) {
    values->resize(tree.cells().size());
  }
  std::vector<BoundingBox> boxes(tree.cells().size());
  for (int level = tree.depth(); level >= 0; --level) {
    const tree::Range cells = tree.level(level);
    tree::share_evenly(cells, cells.size() > tree::cells_worth_sharing, [&](std::uint32_t c) {
      const tree::Cell& cell = tree.cells()[c];
      const CellShape shape = cell.childless() ? around(points, cell.points)
                                               : around_children(boxes, core, cell.children);
      boxes[c] = shape.box;
      set(c, shape.box, shape.core);
    });
  }
}

void CellShapes::set(std::size_t c, const BoundingBox& box, double largest_core) {
  x[c] = 0.5 * (box.left + box.right), y[c] = 0.5 * (box.bottom + box.top);
  half_x[c] = std::max(box.right - x[c], x[c] - box.left);
  half_y[c] = std::max(box.top - y[c], y[c] - box.bottom);
  radius[c] = std::sqrt(half_x[c] * half_x[c] + half_y[c] * half_y[c]);
  core[c] = largest_core;
}

}  // namespace vortree::fmm

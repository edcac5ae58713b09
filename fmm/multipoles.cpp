#include "fmm/multipoles.hpp"

#include <algorithm>
#include <cstdint>

#include "fmm/multipole_kernel.hpp"

namespace vortree::fmm {

double scale(const CellShapes& shapes, std::size_t cell) {
  return std::max(shapes.radius[cell], 1e-75);
}

Multipoles::Multipoles(const tree::Quadtree& tree, const CellShapes& shapes,
                       const SortedPoints& points, std::span<const double> gamma, int order)
    : order_(order), terms_(2 * tree.cells().size() * static_cast<std::size_t>(order)) {
  const auto cells = tree.cells();
  for (int level = tree.depth(); level >= 0; --level) {
    const tree::Range range = tree.level(level);
#pragma omp parallel for schedule(dynamic, 64)
    for (std::uint32_t c = range.first; c < range.last; ++c) {
      if (cells[c].childless()) add_points(shapes, points, gamma, cells[c].points, c);
      for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
        add_child(shapes, k, c);
      }
    }
  }
}

void Multipoles::add_points(const CellShapes& shapes, const SortedPoints& points,
                            std::span<const double> gamma, tree::Range range, std::size_t cell) {
  double* to = terms_.data() + 2 * cell * static_cast<std::size_t>(order_);
  p2m({&points.x[range.first], &points.y[range.first], &gamma[range.first], range.size()},
      {shapes.x[cell], shapes.y[cell], 1.0 / scale(shapes, cell)}, order_, to);
}

void Multipoles::add_child(const CellShapes& shapes, std::size_t child, std::size_t cell) {
  const double h = scale(shapes, cell);
  double* to = terms_.data() + 2 * cell * static_cast<std::size_t>(order_);
  m2m(real(child),
      {(shapes.x[child] - shapes.x[cell]) / h, (shapes.y[child] - shapes.y[cell]) / h,
       scale(shapes, child) / h},
      order_, to);
}

}  // namespace vortree::fmm

#include "fmm/multipoles.hpp"

#include <algorithm>
#include <cstdint>

#include "fmm/multipole_kernel.hpp"

namespace vortree::fmm {
namespace {

constexpr std::uint32_t alone = 512;  // cells of a level that one thread had better do alone

}  // namespace

double scale(const CellShapes& shapes, std::size_t cell) {
  return std::max(shapes.radius[cell], 1e-75);
}

Multipoles::Multipoles(const tree::Quadtree& tree, const CellShapes& shapes,
                       const SortedPoints& points, std::span<const double> gamma, int order,
                       bool single)
    : order_(order),
      terms_(2 * tree.cells().size() * static_cast<std::size_t>(order)),
      singles_(single ? terms_.size() : 0) {
  const auto cells = tree.cells();
  for (int level = tree.depth(); level >= 0; --level) {
    const tree::Range range = tree.level(level);
#pragma omp parallel for schedule(dynamic, 64) if (range.size() > alone)
    for (std::uint32_t c = range.first; c < range.last; ++c) {
      double* terms = terms_.data() + 2 * std::size_t{c} * static_cast<std::size_t>(order);
      std::fill_n(terms, 2 * order, 0.0);
      if (cells[c].childless()) add_points(shapes, points, gamma, cells[c].points, c);
      if (!cells[c].childless()) add_children(shapes, cells[c].children, c);
      if (single) std::copy_n(terms, 2 * order, singles_.data() + (terms - terms_.data()));
    }
  }
}

void Multipoles::add_points(const CellShapes& shapes, const SortedPoints& points,
                            std::span<const double> gamma, tree::Range range, std::size_t cell) {
  double* to = terms_.data() + 2 * cell * static_cast<std::size_t>(order_);
  p2m({&points.x[range.first], &points.y[range.first], &gamma[range.first], range.size()},
      {shapes.x[cell], shapes.y[cell], 1.0 / scale(shapes, cell)}, order_, to);
}

void Multipoles::add_children(const CellShapes& shapes, tree::Range children, std::size_t cell) {
  const double h = scale(shapes, cell);
  M2mChild some[family];
  for (std::uint32_t k = children.first; k < children.last; ++k) {
    some[k - children.first] = {real(k), (shapes.x[k] - shapes.x[cell]) / h,
                                (shapes.y[k] - shapes.y[cell]) / h, scale(shapes, k) / h};
  }
  m2m(some, static_cast<int>(children.size()), order_,
      terms_.data() + 2 * cell * static_cast<std::size_t>(order_));
}

}  // namespace vortree::fmm

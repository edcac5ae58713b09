#include "fmm/series/multipoles.hpp"

#include <algorithm>
#include <cstdint>

#include "fmm/losses/expected.hpp"
#include "fmm/series/multipole_kernel.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

/// 1/<|t|^(2k)> of points that fill their disk, of the terms that series may leave out.
std::vector<double> charge_weights(int order) {
  constexpr int never_left_out = 3;
  std::vector<double> weights(static_cast<std::size_t>(order));
  for (int k = 0; k < order; ++k)
    weights[k] = k < std::min(never_left_out, order - 1) ? 0.0 : k + 1;
  return weights;
}

}  // namespace

double scale(const CellShapes& shapes, std::size_t cell) {
  return std::max(shapes.radius[cell], 1e-75);
}

Multipoles::Multipoles(const tree::Quadtree& tree, const CellShapes& shapes,
                       const SortedPoints& points, std::span<const double> gamma, int order,
                       bool single)
    : order_(order),
      terms_(2 * tree.cells().size() * static_cast<std::size_t>(order)),
      singles_(single ? terms_.size() : 0),
      charges_(tree.cells().size()) {
  const std::vector<double> weights = charge_weights(order);
  const auto cells = tree.cells();
  for (int level = tree.depth(); level >= 0; --level) {
    const tree::Range range = tree.level(level);
    tree::share_in_turn(range, 64, range.size() > tree::series_worth_sharing, [&](std::uint32_t c) {
      double* terms = terms_.data() + 2 * std::size_t{c} * static_cast<std::size_t>(order);
      std::fill_n(terms, 2 * order, 0.0);
      if (cells[c].childless()) add_points(shapes, points, gamma, cells[c].points, c);
      if (!cells[c].childless()) add_children(shapes, cells[c].children, c);
      set_charge(cells, gamma, c, weights);
      if (single) std::copy_n(terms, 2 * order, singles_.data() + (terms - terms_.data()));
    });
  }
}

void Multipoles::add_points(const CellShapes& shapes, const SortedPoints& points,
                            std::span<const double> gamma, tree::Range range, std::size_t cell) {
  double* to = terms_.data() + 2 * cell * static_cast<std::size_t>(order_);
  p2m({&points.x[range.first], &points.y[range.first], &gamma[range.first], range.size()},
      {shapes.x[cell], shapes.y[cell], 1.0 / scale(shapes, cell)}, order_, to);
}

void Multipoles::set_charge(std::span<const tree::Cell> cells, std::span<const double> gamma,
                            std::size_t cell, std::span<const double> weights) {
  Charge& charge = charges_[cell];
  charge.effective = effective_charge(real(cell), imaginary(cell), weights.data(), weights.size());
  const tree::Range points = cells[cell].points, children = cells[cell].children;
  if (children.empty()) {
    charge.squares = sum_of_squares(gamma.subspan(points.first, points.size()));
  }
  for (std::uint32_t k = children.first; k < children.last; ++k) {
    charge.squares += charges_[k].squares;
  }
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

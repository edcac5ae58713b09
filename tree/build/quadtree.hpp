#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/order/morton.hpp"
#include "tree/order/points.hpp"
#include "tree/order/sort.hpp"

namespace vortree::tree {

/// A square that holds at least one point.
///
/// key       Morton code of the cell within its level, 2 level bits
/// parent    number of the parent cell; -1 at the root
/// children  the occupied children, one run of cells; empty if childless
/// points    the points inside, one run in Morton order; never empty
struct Cell {
  MortonKey key = 0;
  int level = 0;
  std::int32_t parent = -1;
  Range children, points;
  [[nodiscard]] bool childless() const { return children.empty(); }
  bool operator==(const Cell&) const = default;
};

/// The middle of a cell [m].
struct Centre {
  double x = 0, y = 0;
  bool operator==(const Centre&) const = default;
};

/// A tree of square cells over points in Morton order. Built once (build_forward, build_reverse),
/// then never changed; two trees are equal if every cell, key and index is.
///
/// - Only occupied cells are stored, in level order, by Morton code within a level; cell 0 is the
///   root. No points, no cells.
/// - The points of a cell are those of its children, one after the other; the childless cells
///   partition the points.
/// - A cell of level l has side domain().side / 2^l.
class Quadtree {
 public:
  Quadtree() = default;

  /// The tree over `order` with the given cells in level order. The promises above are checked.
  ///
  /// cost    O(cells)
  /// throws  std::invalid_argument if keys and index of the order differ in size, or naming the
  ///         first cell that breaks the tree
  Quadtree(MortonOrder order, std::vector<Cell> cells);

  [[nodiscard]] const Domain& domain() const { return order_.domain; }
  /// The level below which no cell was allowed.
  [[nodiscard]] int finest() const { return order_.finest; }
  /// The deepest level that has a cell; -1 without points.
  [[nodiscard]] int depth() const { return static_cast<int>(level_first_.size()) - 2; }

  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
  /// The cells of level l; empty beyond depth().
  [[nodiscard]] Range level(int l) const;
  /// Numbers of the childless cells in Morton order, hence in the order of their points.
  [[nodiscard]] std::span<const std::uint32_t> childless() const { return childless_; }

  /// order()[j] is the input position of the j-th point in Morton order, keys()[j] its code.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_.index; }
  [[nodiscard]] std::span<const MortonKey> keys() const { return order_.keys; }

  /// domain().side / 2^level: exact.
  [[nodiscard]] double side(int level) const { return domain().cell_side(level); }
  /// (x0 + (2 ix + 1) side / 2, y0 + (2 iy + 1) side / 2). With a domain from enclose() this is the
  /// exact centre rounded once: centres of parent and child differ by side(parent)/4 but for that.
  [[nodiscard]] Centre centre(const Cell& cell) const;

  bool operator==(const Quadtree&) const = default;

 private:
  friend struct Assembly;

  MortonOrder order_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> level_first_{0};
  std::vector<std::uint32_t> childless_;
};

}  // namespace vortree::tree

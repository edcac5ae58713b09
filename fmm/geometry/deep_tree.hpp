#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fmm/geometry/units.hpp"
#include "fmm/geometry/vortices.hpp"
#include "tree/base/memory.hpp"
#include "tree/build/assembly.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// A cell as the sums see it: a tree::Cell without its place, which CellFrame tells.
struct DeepCell {
  int level = 0, quadrant = 0;
  std::int32_t parent = -1;
  tree::Range children, points;
  [[nodiscard]] bool childless() const { return children.empty(); }
};

/// A cell in Units. The centre is x + x_rest, y + y_rest to twice the digits of a double: in a deep
/// cell far from the origin its rounding would show.
struct CellFrame {
  double x, y, x_rest, y_rest, side;
};

/// A quadtree that goes on below its finest level: childless cells that are too full there are
/// split on by trees of their own, so that clusters as narrow as the digits of a double have cells.
/// Those are grown as one forest, from leaf to root.
/// Cells are in level order, as in tree::Quadtree.
class DeepTree {
 public:
  DeepTree() = default;

  /// vortices   those the base was built from, in input order
  /// capacity   of a childless cell; cells of the base's finest level that hold more are split on
  /// deepen     false: the base as it is
  DeepTree(const tree::Quadtree& base, std::span<const Vortex> vortices, const Units& units,
           std::uint32_t capacity, bool deepen);

  [[nodiscard]] std::span<const DeepCell> cells() const { return cells_; }
  [[nodiscard]] const CellFrame& frame(std::size_t cell) const { return frames_[cell]; }
  [[nodiscard]] tree::Range level(int l) const { return {level_first_[l], level_first_[l + 1]}; }
  [[nodiscard]] int depth() const { return static_cast<int>(level_first_.size()) - 2; }
  /// Side of the cells of a level, in Units.
  [[nodiscard]] double side(int level) const;
  /// Numbers of the childless cells, in the order of their points.
  [[nodiscard]] std::span<const std::uint32_t> childless() const { return childless_; }
  /// order()[j] is the input position of the j-th point.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Grafts;

  void take(const tree::Quadtree& base);
  void set_frames(int from, const tree::Domain& domain, const Units& units);
  [[nodiscard]] Grafts find_full(const tree::Quadtree& base, std::uint32_t capacity) const;
  [[nodiscard]] Unwritten<tree::MortonKey> sort(const Grafts& grafts,
                                                std::span<const Vortex> vortices);
  [[nodiscard]] Unwritten<tree::MortonKey> encode(const Grafts& grafts,
                                                  std::span<const Vortex> vortices) const;
  void append(const Grafts& grafts, const tree::Assembly& forest);

  Unwritten<DeepCell> cells_;
  Unwritten<CellFrame> frames_;
  Unwritten<std::uint32_t> childless_, order_;
  std::vector<std::uint32_t> level_first_{0};
};

}  // namespace vortree::fmm

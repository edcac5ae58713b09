#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fmm/geometry/cells.hpp"
#include "fmm/losses/charge.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// The multipoles of all cells: of each `order` real parts, then as many imaginary parts, about the
/// middle of the cell's box, in lengths of scale(cell) (specification.hpp).
class Multipoles {
 public:
  Multipoles() = default;

  /// The upward pass: P2M in childless cells, M2M from level to level. Threads share the cells of a
  /// level; every cell is summed by one thread in a fixed order.
  ///
  /// gamma    circulations in the order of points
  /// single   hold the result in single precision, too
  Multipoles(const tree::Quadtree& tree, const CellShapes& shapes, const SortedPoints& points,
             std::span<const double> gamma, int order, bool single);

  [[nodiscard]] int order() const { return order_; }
  [[nodiscard]] const double* real(std::size_t cell) const {
    return terms_.data() + 2 * cell * static_cast<std::size_t>(order_);
  }
  [[nodiscard]] const double* imaginary(std::size_t cell) const { return real(cell) + order_; }
  [[nodiscard]] bool in_single() const { return !singles_.empty(); }
  [[nodiscard]] const float* single(std::size_t cell) const {
    return singles_.data() + 2 * cell * static_cast<std::size_t>(order_);
  }
  [[nodiscard]] const Charge& charge(std::size_t cell) const { return charges_[cell]; }
  [[nodiscard]] std::size_t bytes() const {
    return terms_.capacity() * sizeof(double) + singles_.capacity() * sizeof(float) +
           charges_.capacity() * sizeof(Charge);
  }

 private:
  void add_points(const CellShapes& shapes, const SortedPoints& points,
                  std::span<const double> gamma, tree::Range range, std::size_t cell);
  void set_charge(std::span<const tree::Cell> cells, std::span<const double> gamma,
                  std::size_t cell, std::span<const double> weights);
  void add_children(const CellShapes& shapes, tree::Range children, std::size_t cell);

  int order_ = 0;
  Reals terms_;
  Unwritten<float> singles_;
  std::vector<Charge> charges_;
};

/// The length a cell's series is scaled by: its radius, or where that is nothing, next to nothing.
[[nodiscard]] double scale(const CellShapes& shapes, std::size_t cell);

}  // namespace vortree::fmm

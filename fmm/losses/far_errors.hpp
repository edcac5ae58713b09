#pragma once

#include <cstdint>

#include "fmm/adaptive/far_field.hpp"
#include "fmm/losses/expected.hpp"
#include "fmm/series/lattice_order.hpp"
#include "tree/base/memory.hpp"

namespace vortree::fmm {

/// The squared error to expect at a target of each cell by all that its local expansion stands for,
/// in f (translation_kernel.hpp) or a derivative of it, and by one multipole.
///
/// A level whose cells hold m points of gamma^2 = 1 and random sign loses m sum_D n(D) E^2(D) in f
/// (lattice_order.hpp), in lengths of its cells; Charge::effective takes the place of m. A term k
/// of a derivative is some k/side as large, of an integral side/k.
///
/// cost    O(cells): a thousandth of the sum
class FarErrors {
 public:
  /// The squared distance, in sides, of the nearest target of a cell that is a side away.
  static constexpr double side_away2 = 2.25;

  FarErrors() = default;
  /// derivative   of f: 0, 1, or -1 for its integral
  template <class Number>
  FarErrors(const Stage& stage, const FarField<Number>& far, const LatticeOrder& order,
            int derivative);

  /// At a target in the cell.
  [[nodiscard]] const Lost& at(std::uint32_t cell) const { return errors_[cell]; }
  /// By the multipole of a cell, at a distance of its centre.
  [[nodiscard]] Lost of_multipole(const Charge& charge, double side, double distance2) const;

 private:
  /// Of a neighbor in V, per cell.
  [[nodiscard]] Lost of_one(const Charge& charge, double side) const;

  double series_ = 0.0, rounding_ = 0.0;  // of a charge of 1 in a cell of side 1
  int derivative_ = 0, terms_ = 0;
  Unwritten<Lost> errors_;
};

}  // namespace vortree::fmm

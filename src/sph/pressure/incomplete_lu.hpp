#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// L U, of A on the places where A has something: ILU(0). A pivot that is small beside its row, or
/// of the other sign than the diagonal, gives way to a third of the row's sum of magnitudes.
///
/// cost    a row of m values: m m / 4 products; twice the matrix in memory
/// source  Saad, Iterative Methods for Sparse Linear Systems (2003), algorithm 10.4
class IncompleteLu {
 public:
  void factor(const SparseRows& a);

  /// L U x = b.
  void solve(std::span<const double> b, std::span<double> x) const;

 private:
  void sort(const SparseRows& a);
  void eliminate(std::int32_t i);
  [[nodiscard]] double pivot(std::int32_t i, double magnitude) const;

  std::vector<std::int32_t> start_, middle_, index_;  // middle: the first beyond the diagonal
  std::vector<double> value_, diagonal_, reciprocal_;
  std::vector<std::int32_t> place_;  // of column j in the row at hand, or -1
};

}  // namespace vortree::sph

#pragma once

#include <memory>
#include <vector>

#include "sph/pressure/aggregates.hpp"
#include "sph/pressure/sliced_kernel.hpp"
#include "sph/pressure/sliced_rows.hpp"

namespace vortree::sph {

/// A W-cycle of multigrid, in single precision, with what is near of A alone (near_rows.hpp): one
/// Jacobi step, the residual summed over aggregates (aggregates.hpp), a correction from two visits
/// there that is interpolated (coarse_rows.hpp), one Jacobi step more. The orders of interpolation,
/// two, and of summing, one, are together more than that of the equation, so that the rate of
/// convergence does not depend on n; it is 0.3 to 0.4 a cycle.
///
/// Jacobi steps divide by the diagonal (aggregates.hpp). The coarsest level, at most 120 rows, is
/// solved directly; if its rows sum to nothing, then but for a constant.
///
/// cost    a cycle: 2.3 products with what is near; memory of 1.8 A in floats
/// source  Trottenberg, Oosterlee & Schüller, Multigrid (2001), 2.4 and appendix A; orders:
///         Hemker, J. Comput. Appl. Math. 32 (1990)
class Multigrid {
 public:
  Multigrid();
  ~Multigrid();
  Multigrid(Multigrid&&) noexcept;
  Multigrid& operator=(Multigrid&&) noexcept;

  /// Takes a matrix over. Memory of the one before is used again.
  void prepare(const SlicedDoubles& rows);

  /// A itself, in floats, with its diagonal.
  [[nodiscard]] const SlicedRows& matrix() const { return matrix_; }

  /// x, which is about A^-1 b.
  void cycle(const kernel::SlicedColumn& b, kernel::SlicedColumn& x);

 private:
  using Column = kernel::SlicedColumn;
  struct Level {
    SlicedRows a, sums, interpolation;
    RowTies ties;
    Column smooth, residual, coarse_b, coarse_x;
  };
  class Coarsest;

  bool coarsen();
  void visit(std::size_t l, const Column& b, Column& x, bool is_zero);
  static void begin_jacobi(const Level& at, const Column& b, Column& to);
  static void jacobi(const Level& at, const Column& b, const Column& from, Column& to);
  void correct(std::size_t l);

  SlicedRows matrix_;
  std::vector<Level> levels_;  // the first: what is near of the matrix
  std::size_t depth_ = 0;      // levels in use
  RowsMaker maker_;
  std::unique_ptr<Coarsest> coarsest_;
};

}  // namespace vortree::sph

#pragma once

#include <span>
#include <vector>

#include "sph/pressure/multigrid.hpp"
#include "sph/pressure/sliced_kernel.hpp"

namespace vortree::sph {

/// Flexible GMRES in single precision for what is left of a system, with a cycle of multigrid
/// before it: ||r - A (d + c 1)|| becomes least over the space of cycles, and of the constants,
/// which stand apart: c is a double. So a weak pin, the only thing that keeps constants from having
/// no effect, may make c as large as it likes.
///
/// For A z rows take differences, sum_j a_ij (z_j - z_i) + (A 1)_i z_i: what floats round is then
/// small beside A z even where z is smooth and A z is some (spacing / wave length)^2 of it. The sum
/// of corrections is one of doubles for the same reason.
///
/// source  Saad, SIAM J. Sci. Comput. 14 (1993); Chapman & Saad, Numer. Linear Algebra Appl. 4
///         (1997), for the space that is added. Sums in doubles, in a fixed order
class Gmres {
 public:
  /// image   of the constant 1, A 1: n numbers
  void prepare(Multigrid& multigrid, std::span<const double> image);

  /// Adds d + c 1 to x, such that ||r - A (d + c 1)|| is at most `reduction` of ||r||, as far as
  /// floats know. Returns the iterations.
  int solve(std::span<const double> r, double reduction, int most, std::span<double> x);

 private:
  using Column = kernel::SlicedColumn;

  double start(std::span<const double> r);
  void iterate();
  void rotate(std::vector<double>& h);
  [[nodiscard]] std::vector<double> least_squares() const;
  void add_to(std::span<double> x) const;

  Multigrid* multigrid_ = nullptr;
  Column image_;  // A 1
  double image_norm_ = 0, from_image_ = 0, scale_ = 0;
  std::vector<Column> basis_, cycles_;         // basis: first A 1, then Krylov's; memory is kept
  std::vector<std::vector<double>> triangle_;  // columns of H, rotated
  std::vector<double> along_image_, cosine_, sine_, right_;
};

}  // namespace vortree::sph

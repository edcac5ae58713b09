#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sph/pressure/sliced_rows.hpp"
#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// Solves the pressure system of incompressible SPH, A x = b: rows of a Laplacian by moving least
/// squares, not symmetric, times the square of the spacing; nodes at walls that take a weighted
/// mean of particles beside them; nodes of given pressure. Where all boundaries are walls or
/// periodic, a small part taken from the diagonals, 1e-5 of the spacing's square, is enough.
///
/// Residuals in doubles, what is left by GMRES with multigrid in floats (gmres.hpp, multigrid.hpp):
/// 6 to 11 iterations to 1e-5 from the pressure of the step before, for 4 000 as for 260 000
/// particles; twice as many where walls are cruder (tests/sph/pressure/solver.cpp).
/// Where that gets stuck BiCGSTAB with ILU(0) goes on. Same bits for any number of threads.
///
/// cost    0.6 microseconds a particle for prepare and a solve to 1e-5, of 22 neighbors, on one
///         core; memory of A in doubles and twice in floats
class PressureSolver {
 public:
  PressureSolver();
  ~PressureSolver();
  PressureSolver(PressureSolver&&) noexcept;
  PressureSolver& operator=(PressureSolver&&) noexcept;

  /// rows    must stay as they are until the last solve: they are not copied
  /// throws  std::invalid_argument as check(SlicedDoubles) does
  void prepare(const SlicedDoubles& rows);
  void prepare(SlicedDoubles&&) = delete;

  /// The rows that were prepared, in floats.
  [[nodiscard]] const SlicedRows& matrix() const;

  /// x           n numbers: first guess in, answer out
  /// tolerance   of ||b - A x|| / ||b||
  /// most        iterations; whether x is good enough is for the caller to see
  /// throws      std::invalid_argument if sizes differ from that of the matrix, or if a number of b
  ///             or x is not finite; std::logic_error if nothing was prepared
  Solved solve(std::span<const double> b, std::span<double> x, double tolerance, int most);

 private:
  class Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace vortree::sph

#pragma once

#include <array>
#include <span>

#include "sph/pressure/sliced_rows.hpp"
#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// A system whose diagonals outweigh its rows, as those of implicit viscosity do,
///
///   (b0 - nu dt lap) u = h:   value_i x_i - factor_i sum_j a_ij (x_j - x_i) = b_i
///
/// by the rows of another: those of a pressure are those of a Laplacian times volumes. Where factor
/// is 0, x_i is b_i / value_i.
///
/// singles   the same matrix in floats
struct DiagonalDominant {
  const SlicedDoubles& a;
  const SlicedRows& singles;
  std::span<const double> value, factor;
};

/// Solves it for two right sides at once: residuals in doubles, what is left by BiCGSTAB with
/// 1 / diagonal in floats. Same bits for any number of threads.
///
/// x           n numbers: first guess in, answer out
/// tolerance   of ||b - A x|| / ||b||
/// most        iterations; whether x is good enough is for the caller to see
/// throws      std::invalid_argument if sizes differ from that of the matrix, or if a number of b
///             or x is not finite
std::array<Solved, 2> solve(const DiagonalDominant& system,
                            std::array<std::span<const double>, 2> b,
                            std::array<std::span<double>, 2> x, double tolerance, int most);

}  // namespace vortree::sph

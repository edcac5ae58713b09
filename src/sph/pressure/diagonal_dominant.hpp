#pragma once

#include <array>
#include <span>

#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// Solves A x = b whose diagonals outweigh their rows, as those of implicit viscosity do:
/// (b0 - nu dt lap) u = h. BiCGSTAB with 1 / diagonal. Same bits for any number of threads.
///
/// x           n numbers: first guess in, answer out
/// tolerance   of ||b - A x|| / ||b||
/// most        iterations; whether x is good enough is for the caller to see
/// throws      std::invalid_argument as check(SparseRows) does, or if sizes differ from that of the
///             matrix, or if a number of b or x is not finite
Solved solve_diagonal_dominant(const SparseRows& rows, std::span<const double> b,
                               std::span<double> x, double tolerance, int most);

/// The same for two right sides at once: the matrix is read once for both.
std::array<Solved, 2> solve_diagonal_dominant(const SparseRows& rows,
                                              std::array<std::span<const double>, 2> b,
                                              std::array<std::span<double>, 2> x, double tolerance,
                                              int most);

}  // namespace vortree::sph

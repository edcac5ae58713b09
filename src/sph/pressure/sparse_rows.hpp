#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vortree::sph {

/// A sparse square matrix A of n rows, its diagonal apart from the rest:
///
///   (A x)_i = diagonal_i x_i + sum_k value_k x_(index_k),   start_i <= k < start_(i+1)
///
/// Rows are those of particles in Morton order; nothing depends on it but speed. Within a row the
/// order is any, and the diagonal does not stand again.
///
/// start   n + 1 numbers, from 0 to the number of values
struct SparseRows {
  std::vector<double> diagonal;
  std::vector<std::int32_t> start, index;
  std::vector<double> value;

  [[nodiscard]] std::size_t size() const { return diagonal.size(); }
};

/// What became of a linear system: ||b - A x|| / ||b||, with the x that is handed back. Never NaN.
struct Solved {
  int iterations = 0;
  double residual = 0;
};

/// throws  std::invalid_argument with the numbers if sizes do not fit, an index is outside of
///         0 .. n - 1 or that of its own row, a diagonal is 0, or a value not finite
void check(const SparseRows& rows);

/// throws  std::invalid_argument with the numbers if b or x are not as many as rows, or naming the
///         first that is not finite
void check_vectors(const SparseRows& rows, std::span<const double> b, std::span<const double> x);

}  // namespace vortree::sph

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/pressure/sliced_rows.hpp"

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

/// The rows of a matrix in slices, one after the other.
[[nodiscard]] SparseRows unsliced(const SlicedDoubles& a);

/// y = A x.
void multiply(const SparseRows& a, std::span<const double> x, std::span<double> y);

/// The root of the sum of squares.
[[nodiscard]] double norm(std::span<const double> a);

/// throws  std::invalid_argument with the numbers if b or x are not n, or naming the first that is
///         not finite
void check_vectors(std::size_t n, std::span<const double> b, std::span<const double> x);

}  // namespace vortree::sph

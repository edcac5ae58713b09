#pragma once

#include <array>
#include <cstddef>

namespace vortree {

/// sum of part(first, last) over 16 parts of 0 .. n, done by all threads and added in order: the
/// same bits for any number of threads. The last parts are begun first: blobs that were laid along
/// a wall come last, and cost most. Values are added by +=, or element by element.
auto ordered_sum(std::size_t n, auto part) {
  constexpr std::ptrdiff_t count = 16;
  std::array<decltype(part(n, n)), count> sums;
#pragma omp parallel for schedule(dynamic, 1)
  for (std::ptrdiff_t k = count - 1; k >= 0; --k)
    sums[k] = part(n * k / count, n * (k + 1) / count);
  auto& sum = sums[0];
  for (std::ptrdiff_t k = 1; k < count; ++k) {
    if constexpr (requires { sum += sums[k]; })
      sum += sums[k];
    else
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += sums[k][i];
  }
  return sum;
}

}  // namespace vortree

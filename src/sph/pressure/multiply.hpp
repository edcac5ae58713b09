#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {

/// y = A x for several x at once, those of a row side by side.
template <std::size_t sides>
void multiply(const SparseRows& a, std::span<const double> x, std::span<double> y) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::array<double, sides> sum;
    for (std::size_t s = 0; s < sides; ++s) sum[s] = a.diagonal[i] * x[i * sides + s];
    for (std::int32_t k = a.start[i]; k < a.start[i + 1]; ++k)
      for (std::size_t s = 0; s < sides; ++s)
        sum[s] += a.value[k] * x[static_cast<std::size_t>(a.index[k]) * sides + s];
    for (std::size_t s = 0; s < sides; ++s) y[i * sides + s] = sum[s];
  }
}

}  // namespace vortree::sph

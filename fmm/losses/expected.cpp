#include "fmm/losses/expected.hpp"

namespace vortree::fmm {

double sum_of_squares(std::span<const double> values) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * values[i];
  return sum;
}

}  // namespace vortree::fmm

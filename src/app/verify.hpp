#pragma once

#include <cstddef>
#include <span>

#include "fmm/blobs.hpp"

namespace vortree::app {

/// How far velocities are from the truth.
struct VelocityError {
  double relative_l2 = 0.0;  // |velocity - exact|_2 / |exact|_2 over the sample
  double p99 = 0.0;  // 99th percentile of |velocity_i - exact_i| / sum_j |contribution of j to i|
  double max = 0.0;  // the largest of the same
  std::size_t targets = 0;  // size of the sample
};

/// Compares velocities with a direct sum in long double, at a random sample of targets that is the
/// same in every call.
///
/// sources  n blobs; the core of a pair is that of the source
/// targets  m points
/// u, v     m velocities
/// sample   so many targets, or all of them if there are fewer
/// cost     O(n sample), 10 to 100 ns a pair
VelocityError velocity_error(fmm::Blobs sources, fmm::Targets targets, std::span<const double> u,
                             std::span<const double> v, std::size_t sample = 1000);

}  // namespace vortree::app

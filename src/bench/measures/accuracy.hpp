#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fmm/sources.hpp"

namespace vortree::bench {

/// Velocities that others are measured against, at a random sample of targets that is the same in
/// every call: direct sums in numbers of twice the digits of a double, cores in long double; the
/// core of a pair is that of the source.
struct Exact {
  std::vector<std::size_t> targets;        // places in the list of all targets, ascending
  std::vector<long double> u, v;           // [m/s]
  std::vector<long double> contributions;  // sum_j |contribution of j|
};

/// sample   so many targets, or all of them if there are fewer
/// cost     O(n sample), 2 ns a pair, 100 ns where a core shows; threads share the targets
Exact exact_velocity(const fmm::Sources& sources, const fmm::Targets& targets,
                     std::size_t sample = 1000);

/// How far velocities are from the truth. What is not a number counts as infinitely wrong.
struct VelocityError {
  double relative_l2 = 0.0;  // |velocity - exact|_2 / |exact|_2 over the sample
  double p99 = 0.0;  // 99th percentile of |velocity_i - exact_i| / sum_j |contribution of j to i|
  double max = 0.0;  // the largest of the same
  std::size_t targets = 0;  // size of the sample
  double condition = 0.0;   // |sum_j |contribution of j||_2 / |exact|_2: how far the sums cancel
};

/// u, v   at all targets; read at those of the sample
VelocityError velocity_error(const Exact& exact, std::span<const double> u,
                             std::span<const double> v);

}  // namespace vortree::bench

#pragma once

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "point_sets.hpp"
#include "vortex/blobs/blobs.hpp"
#include "vortex/blobs/invariants.hpp"

/// Flows that claims about the vortex method are tried on, and how two of them are compared.
namespace vortree::test {

/// Blobs of both signs all over the unit square around the origin, cores from `thin` to `wide`.
inline vortex::Blobs cloud(std::size_t n, double thin, double wide, std::uint64_t seed = 7) {
  Uniform uniform(seed);
  vortex::Blobs blobs;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform() - 0.5, y = uniform() - 0.5, gamma = 2 * uniform() - 1;
    blobs.append({x, y}, gamma, thin + (wide - thin) * uniform());
  }
  return blobs;
}

/// Blobs of both signs around a circle at the origin, from the wall out to a distance of `deep`.
inline vortex::Blobs layer(std::size_t n, double radius, double deep, double thin, double wide) {
  Uniform uniform(11);
  vortex::Blobs blobs;
  for (std::size_t i = 0; i < n; ++i) {
    const double theta = 2 * std::numbers::pi * uniform(), r = radius + deep * uniform();
    const double gamma = 2 * uniform() - 1;
    blobs.append({r * std::cos(theta), r * std::sin(theta)}, gamma,
                 thin + (wide - thin) * uniform());
  }
  return blobs;
}

/// The flow seen in a mirror lying on the x axis.
inline vortex::Blobs mirrored(vortex::Blobs blobs) {
  for (double& y : blobs.y) y = -y;
  for (double& gamma : blobs.gamma) gamma = -gamma;
  for (double& xy : blobs.xy) xy = -xy;
  return blobs;
}

inline double strength(const vortex::Blobs& blobs) {
  double sum = 0;
  for (double gamma : blobs.gamma) sum += std::abs(gamma);
  return sum;
}

/// How far two flows are from holding the same blobs, in whatever order; infinite if counts differ.
inline double apart(const vortex::Blobs& a, const vortex::Blobs& b) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double least = INFINITY;
    for (std::size_t j = 0; j < b.size(); ++j) {
      least = std::min(
          least, std::max({std::abs(a.x[i] - b.x[j]), std::abs(a.y[i] - b.y[j]),
                           std::abs(a.gamma[i] - b.gamma[j]), std::abs(a.sigma[i] - b.sigma[j])}));
    }
    largest = std::max(largest, least);
  }
  return largest;
}

/// Blobs by where they act. On the wall that says less of the centre than of all else: the mean has
/// its least there, and round-off in it is as the square root in the centre.
inline vortex::Blobs folded_there(vortex::Blobs blobs, const body::Shape* wall) {
  vortex::FoldedBlobs at = fold(blobs, wall);
  blobs.x = std::move(at.x);
  blobs.y = std::move(at.y);
  return blobs;
}

/// The largest of what two sets of invariants differ in.
struct Drift {
  double circulation, moment, second;
};
inline Drift drift(const vortex::Invariants& a, const vortex::Invariants& b) {
  return {std::abs(a.circulation - b.circulation),
          std::hypot(a.moment.x - b.moment.x, a.moment.y - b.moment.y),
          std::abs(a.second - b.second)};
}

/// What `run` returns with 1 thread and with `threads`.
template <class Run>
auto with_threads(int threads, Run run) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  auto result = run();
  omp_set_num_threads(before);
  return result;
}

}  // namespace vortree::test

#include "vortex/transport/random_walk.hpp"

#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace vortree::vortex {
namespace {

/// In (0, 1].
double uniform(std::uint64_t hash) {
  return static_cast<double>((hash >> 11) + 1) * 0x1p-53;
}

}  // namespace

void random_walk(Blobs& blobs, double nu, double dt, std::uint64_t seed, std::uint64_t step) {
  const std::uint64_t now = splitmix64(seed ^ splitmix64(step));
  const auto n = static_cast<std::ptrdiff_t>(blobs.size());
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    // Box and Muller 1958: the length and the direction of a normal step in the plane.
    const std::uint64_t one = splitmix64(now ^ splitmix64(static_cast<std::uint64_t>(i))),
                        other = splitmix64(one);
    const double length = std::sqrt(-4 * nu * dt * std::log(uniform(one)));
    const double direction = 2 * std::numbers::pi * uniform(other);
    blobs.x[i] += length * std::cos(direction);
    blobs.y[i] += length * std::sin(direction);
  }
}

}  // namespace vortree::vortex

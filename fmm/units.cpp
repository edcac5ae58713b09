#include "fmm/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::fmm {
namespace {

constexpr std::size_t many = 50000;  // values that threads share

double largest(std::span<const double> values) {
  double most = 0.0;
#pragma omp parallel for simd reduction(max : most) if (values.size() > many)
  for (std::size_t i = 0; i < values.size(); ++i) most = std::max(most, std::abs(values[i]));
  return most;
}

double extent(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double low = values[0], high = values[0];
#pragma omp parallel for simd reduction(min : low) reduction(max : high) if (values.size() > many)
  for (std::size_t i = 0; i < values.size(); ++i) {
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
  }
  return high / 2 - low / 2;
}

/// A power of two near 1/size, kept where it and its reciprocal are normal numbers.
double reciprocal(double size) {
  return size > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size), -1020, 1020)) : 1.0;
}

}  // namespace

Units Units::of(const Blobs& blobs) {
  const double size = std::max(extent(blobs.x), extent(blobs.y));
  return {.per_length = reciprocal(size > 0.0 ? size : largest(blobs.sigma)),
          .per_gamma = reciprocal(largest(blobs.gamma))};
}

void Units::to_velocity(std::span<double> sums) const {
  const int power = std::ilogb(per_length) - std::ilogb(per_gamma);
  const double first = std::ldexp(1.0, power / 2) / (2.0 * std::numbers::pi);
  const double second = std::ldexp(1.0, power - power / 2);  // in two halves: each is normal
  for (double& value : sums) value = value * first * second;
}

}  // namespace vortree::fmm

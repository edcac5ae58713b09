#include "fmm/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::fmm {
namespace {

constexpr double far_away = 1e70;        // a target beyond this many units sees no difference
constexpr double largest_core2 = 1e120;  // a core that wide moves nothing that double can hold

double largest(std::span<const double> values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double extent(std::span<const double> values) {
  if (values.empty()) return 0.0;
  const auto [low, high] = std::ranges::minmax(values);
  return high / 2 - low / 2;
}

/// Exponent of a power of two near `size`, kept where its reciprocal is a normal number.
int exponent(double size) {
  return size > 0.0 ? std::clamp(std::ilogb(size), -1020, 1020) : 0;
}

}  // namespace

Units Units::of(const Blobs& blobs) {
  const double size = std::max(extent(blobs.x), extent(blobs.y));
  return {.length = exponent(size > 0.0 ? size : largest(blobs.sigma)),
          .gamma = exponent(largest(blobs.gamma))};
}

double Units::position(double x) const {
  return std::clamp(x * std::ldexp(1.0, -length), -far_away, far_away);
}

double Units::circulation(double value) const {
  return value * std::ldexp(1.0, -gamma);
}

double Units::squared_core(double sigma) const {
  const double scaled = std::min(sigma * std::ldexp(1.0, -length), 1e100);
  return std::min(scaled * scaled, largest_core2);
}

void Units::to_velocity(std::span<double> sums) const {
  const int power = gamma - length;  // in two halves: each is a normal number
  const double first = std::ldexp(1.0, power / 2) / (2.0 * std::numbers::pi);
  const double second = std::ldexp(1.0, power - power / 2);
  for (double& value : sums) value = value * first * second;
}

}  // namespace vortree::fmm

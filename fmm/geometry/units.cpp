#include "fmm/geometry/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "tree/base/tuning.hpp"

namespace vortree::fmm {
namespace {

double largest(std::span<const double> values) {
  double most = 0.0;
#pragma omp parallel for simd reduction(max : most) if (values.size() > tree::values_worth_sharing)
  for (std::size_t i = 0; i < values.size(); ++i) most = std::max(most, std::abs(values[i]));
  return most;
}

double extent(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double low = values[0], high = values[0];
#pragma omp parallel for simd reduction(min    \
                                        : low) \
    reduction(max                              \
              : high) if (values.size() > tree::values_worth_sharing)
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

Units Units::of(const Sources& sources) {
  const double size = std::max(extent(sources.x), extent(sources.y));
  return {.per_length = reciprocal(size > 0.0 ? size : largest(sources.sigma)),
          .per_gamma = reciprocal(largest(sources.gamma))};
}

void Units::finish_far(double all, std::span<const double> x, std::span<const double> y,
                       std::span<double> u, std::span<double> v) const {
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double most = std::max(std::abs(x[i]), std::abs(y[i]));
    if (most * per_length <= far_away) continue;
    const double along = x[i] / most, across = y[i] / most;
    const double speed =
        all / (2.0 * std::numbers::pi) / (along * along + across * across) / most / per_gamma;
    u[i] = -across * speed, v[i] = along * speed;
  }
}

void Units::check_range(double found, std::size_t n, int derivative) const {
  if (!(found > 0.0) || n == 0) return;
  constexpr double highest = 1020, lowest = -1000;
  const double unit = (derivative + 1.0) * std::ilogb(per_length) - std::ilogb(per_gamma);
  const double most = 0.5 * std::log2(found) + unit;
  const double mean = most - 0.5 * std::log2(static_cast<double>(n));
  if (most < highest && mean > lowest) return;
  const char* names[] = {"stream function is", "velocities are", "gradients are"};
  std::ostringstream text;
  text << "the " << names[derivative + 1] << " of the order of 1e"
       << std::lround(mean * std::numbers::log10e * std::numbers::ln2)
       << " in the units of the input, which a double cannot hold; choose other units";
  throw std::invalid_argument(text.str());
}

void Units::to_velocity(std::span<double> sums) const {
  const int power = std::ilogb(per_length) - std::ilogb(per_gamma);
  const double first = std::ldexp(1.0, power / 2) / (2.0 * std::numbers::pi);
  const double second = std::ldexp(1.0, power - power / 2);  // in two halves: each is normal
  for (double& value : sums) value = value * first * second;
}

}  // namespace vortree::fmm

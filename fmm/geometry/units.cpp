#include "fmm/geometry/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "fmm/geometry/bounds.hpp"

namespace vortree::fmm {
namespace {

/// A power of two near 1/size, kept where it and its reciprocal are normal numbers.
double reciprocal(double size) {
  return size > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size), -1020, 1020)) : 1.0;
}

}  // namespace

Units Units::of(const SourceBounds& bounds) {
  const double size = std::max(bounds.x.half_width(), bounds.y.half_width());
  return {.per_length = reciprocal(size > 0.0 ? size : bounds.sigma.largest_magnitude()),
          .per_gamma = reciprocal(bounds.gamma.largest_magnitude())};
}

Units Units::of(const Sources& sources) {
  return of(SourceBounds::of(sources));
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

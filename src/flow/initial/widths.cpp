#include "flow/initial/widths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::flow {

double across(const InitialSettings& initial) {
  return initial.core_across.value_or(initial.core);
}

double least_width(const InitialSettings& initial) {
  return std::min(initial.core, across(initial));
}

double mean_vorticity(const InitialSettings& initial) {
  return std::abs(initial.circulation) / (std::numbers::pi * initial.core * across(initial));
}

Pair half_extent(const InitialSettings& initial) {
  const double cores = initial.kind == InitialKind::kirchhoff_ellipse ? 1 : 3;
  return {cores * initial.core + 0.5 * initial.separation.value_or(0), cores * across(initial)};
}

}  // namespace vortree::flow

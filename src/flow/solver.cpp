#include "flow/solver.hpp"

#include <algorithm>
#include <cmath>

#include "tree/base/told.hpp"

namespace vortree::flow {

std::string not_finite(const Columns& columns, std::string_view particle) {
  for (const Column& one : columns) {
    const auto bad = std::ranges::find_if(one.values, [](double a) { return !std::isfinite(a); });
    if (bad == one.values.end()) continue;
    return one.name + " of " + std::string(particle) + " " +
           std::to_string(bad - one.values.begin()) + " of " + std::to_string(one.values.size()) +
           " is " + tree::told(*bad);
  }
  return "";
}

}  // namespace vortree::flow

#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vortree::flow {

/// One number that is measured of a flow after each step: its name, and its unit as powers of
/// length L and time T ("" for none, "deg" for degrees).
struct Measure {
  std::string name, unit;
  double value = 0;
  bool operator==(const Measure&) const = default;
};

using Measures = std::vector<Measure>;

/// throws  std::out_of_range with the name, if there is none
inline double measured(std::span<const Measure> measures, std::string_view name) {
  for (const Measure& one : measures)
    if (one.name == name) return one.value;
  throw std::out_of_range("no measure " + std::string(name));
}

}  // namespace vortree::flow

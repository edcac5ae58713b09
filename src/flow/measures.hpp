#pragma once

#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "body/motion.hpp"

namespace vortree::flow {

/// One number that is measured of a flow after each step: its name, and its unit as powers of
/// length L and time T ("" for none, "deg" for degrees).
struct Measure {
  std::string name, unit;
  double value = 0;
  bool operator==(const Measure&) const = default;
};

using Measures = std::vector<Measure>;

/// Where a body's centre is, that moves by a course, and by what angle it is turned; of one of
/// several, what it does beside the others, its number behind the names.
inline void add_place(Measures& measures, const body::Motion& motion, double t,
                      const std::string& number = "") {
  if (!motion.course.moves()) return;
  const body::Kinematics now = motion.at(t);
  measures.push_back({"body_x" + number, "L", now.place.x});
  measures.push_back({"body_y" + number, "L", now.place.y});
  measures.push_back({"body_angle" + number, "deg", now.angle * 180 / std::numbers::pi});
}

/// throws  std::out_of_range with the name, if there is none
inline double measured(std::span<const Measure> measures, std::string_view name) {
  for (const Measure& one : measures)
    if (one.name == name) return one.value;
  throw std::out_of_range("no measure " + std::string(name));
}

}  // namespace vortree::flow

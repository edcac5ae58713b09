#pragma once

#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace vortree {

/// Rate of change, at one of a few times, of what is known at each: the derivative of a parabola in
/// sqrt(t), for what an impulsive start sets off at t = 0 goes as powers of that (there differences
/// in t err by dt^2/(8 t^2)).
///
/// error  O(dt^2); noise e of the values makes 0.7 e/dt in the middle, 1.6 e/dt at the end
class RateOfChange {
 public:
  /// At the second of three times, by the parabola through them.
  static RateOfChange in_the_middle(double t0, double t1, double t2);

  /// At the last of three or more, by the parabola that fits best (through three it would pass on
  /// 2.5 e/dt). Of two, by the line in sqrt(t) after an impulsive start, else in t: O(dt).
  static RateOfChange at_the_end(std::span<const double> t, bool impulsive);

  Vec2 operator()(std::span<const Vec2> values) const;

 private:
  RateOfChange(std::vector<double> of, std::size_t at) : of_(std::move(of)), at_(at) {}

  std::vector<double> of_;  // of each value less that at the time itself
  std::size_t at_;
};

}  // namespace vortree

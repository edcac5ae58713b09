#pragma once

#include <cstddef>
#include <span>

namespace vortree::fmm {

/// The square of what a sum is expected to be wrong by.
///
/// series     what series and faded cores leave out, which shrinks as the tolerance does
/// rounding   what single precision rounds; what doubles round is not counted
struct Lost {
  double series = 0.0, rounding = 0.0;

  Lost& operator+=(const Lost& more) {
    series += more.series, rounding += more.rounding;
    return *this;
  }
  friend Lost operator*(double factor, Lost lost) {
    return {factor * lost.series, factor * lost.rounding};
  }
  [[nodiscard]] double all() const { return series + rounding; }
};

/// What was found at some targets, and lost: squares, added up, in the units of the sum.
///
/// Losses are foretold from what cells hold (Charge), as good as random among each other; the true
/// ones are seldom larger, and in clouds of random sign a half to a fifth
/// (tests/fmm/losses/cancelling.cpp).
struct Expected {
  double found = 0.0;
  Lost lost;

  Expected& operator+=(const Expected& more) {
    found += more.found, lost += more.lost;
    return *this;
  }
};

/// In the given order, so that the result does not depend on threads.
[[nodiscard]] inline Expected total(std::span<const Expected> parts) {
  Expected all;
  for (const Expected& part : parts) all += part;
  return all;
}

/// The one that is farther off.
[[nodiscard]] inline Expected worse(const Expected& a, const Expected& b) {
  return a.lost.all() * b.found >= b.lost.all() * a.found ? a : b;
}

[[nodiscard]] double sum_of_squares(std::span<const double> values);

}  // namespace vortree::fmm

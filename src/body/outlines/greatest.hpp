#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "body/shape.hpp"

namespace vortree::body {

/// The arc length between two others where a function of the place is greatest, by the golden
/// section: to 1e-8 of the stretch, and the function to the square of that.
template <class Function>
double arc_of_greatest(const Shape& shape, double low, double high, const Function& function) {
  constexpr double golden = 0.6180339887498949;
  const auto value = [&](double arc) { return function(shape.point(arc)); };
  double a = high - golden * (high - low), b = low + golden * (high - low);
  for (double at_a = value(a), at_b = value(b); high - low > 1e-9 * shape.perimeter();) {
    if (at_a > at_b) {
      high = std::exchange(b, std::exchange(a, b - golden * (b - low)));
      at_b = std::exchange(at_a, value(a));
    } else {
      low = std::exchange(a, std::exchange(b, a + golden * (high - a)));
      at_a = std::exchange(at_b, value(b));
    }
  }
  return (low + high) / 2;
}

/// A closed trace and the stretch between the places beside one of them.
inline std::array<double, 2> beside(const Shape& shape, const std::vector<OutlinePoint>& all,
                                    std::size_t i) {
  const std::size_t n = all.size();
  return {all[(i + n - 1) % n].arc - (i == 0 ? shape.perimeter() : 0),
          all[(i + 1) % n].arc + (i + 1 == n ? shape.perimeter() : 0)};
}

/// The greatest of a function along the outline: beside the place of the trace that has most of it.
template <class Function>
double greatest(const Shape& shape, const std::vector<OutlinePoint>& all,
                const Function& function) {
  const auto most =
      std::ranges::max_element(all, {}, [&](const OutlinePoint& one) { return function(one.at); });
  const auto [low, high] = beside(shape, all, most - all.begin());
  const double arc = arc_of_greatest(shape, low, high, function);
  return std::max(function(most->at), function(shape.point(arc)));
}

}  // namespace vortree::body

#include "body/extent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "body/shapes/shapes.hpp"

namespace vortree::body {
namespace {

/// Square of the distance from the centre.
double square(Vec2 at) {
  return dot(at, at);
}
double square_of(const OutlinePoint& one) {
  return square(one.at);
}

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
std::array<double, 2> beside(const Shape& shape, const std::vector<OutlinePoint>& all,
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

}  // namespace

double length_of(const BodySettings& body) {
  return body.shape->length(body);
}

double perimeter_of(const BodySettings& body) {
  return outline_of(body)->perimeter();
}

Tip tip_of(const BodySettings& body) {
  const auto shape = outline_of(body);
  const std::vector<OutlinePoint> all = shape->trace();
  std::size_t best = all.size();
  for (std::size_t i = 0, n = all.size(); i < n; ++i) {
    const double here = square_of(all[i]);
    const bool farther =
        here >= square_of(all[(i + n - 1) % n]) && here >= square_of(all[(i + 1) % n]);
    if (farther && (best == n || all[i].curvature > all[best].curvature)) best = i;
  }
  const auto [low, high] = beside(*shape, all, best);
  const Vec2 between = shape->point(arc_of_greatest(*shape, low, high, square));
  if (square(between) <= (1 + 1e-12) * square_of(all[best]))
    return {all[best].at, 1 / all[best].curvature};
  return {between, 1 / shape->nearest(between).curvature};
}

bool round(const BodySettings& body) {
  const std::vector<OutlinePoint> all = outline_of(body)->trace();
  const auto [nearest, farthest] = std::ranges::minmax_element(all, {}, square_of);
  return square_of(*farthest) - square_of(*nearest) < 1e-9 * square_of(*farthest);
}

std::array<double, 2> half_extent(const BodySettings& body) {
  const auto shape = outline_of(body);
  const std::vector<OutlinePoint> all = shape->trace();
  return {greatest(*shape, all, [](Vec2 at) { return std::abs(at.x); }),
          greatest(*shape, all, [](Vec2 at) { return std::abs(at.y); })};
}

bool covers(const BodySettings& body, const std::array<double, 2>& point) {
  return outline_of(body)->distance({point[0] - body.centre[0], point[1] - body.centre[1]}) <= 0;
}

}  // namespace vortree::body

#include "body/extent.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "body/shapes/shapes.hpp"

namespace vortree::body {
namespace {

/// Square of the distance from the centre.
double square(const OutlinePoint& one) {
  return dot(one.at, one.at);
}

/// The greatest of values at even steps of a parameter that goes round: the top of the parabola
/// through the largest one and its neighbors.
double greatest(const std::vector<double>& values) {
  const std::size_t n = values.size();
  const std::size_t k = std::ranges::max_element(values) - values.begin();
  const double top = values[k], before = values[(k + n - 1) % n], after = values[(k + 1) % n];
  const double bend = 2 * top - before - after, tilt = after - before;
  return bend > 0 ? top + tilt * tilt / (8 * bend) : top;
}

}  // namespace

double length_of(const BodySettings& body) {
  return body.shape->length(body);
}

double perimeter_of(const BodySettings& body) {
  return outline_of(body)->perimeter();
}

Tip tip_of(const BodySettings& body) {
  const std::vector<OutlinePoint> all = outline_of(body)->trace();
  OutlinePoint tip{};
  for (std::size_t i = 0, n = all.size(); i < n; ++i) {
    const double here = square(all[i]);
    const bool farther = here >= square(all[(i + n - 1) % n]) && here >= square(all[(i + 1) % n]);
    if (farther && all[i].curvature > tip.curvature) tip = all[i];
  }
  return {tip.at, 1 / tip.curvature};
}

bool round(const BodySettings& body) {
  const std::vector<OutlinePoint> all = outline_of(body)->trace();
  const auto [nearest, farthest] = std::ranges::minmax_element(all, {}, square);
  return square(*farthest) - square(*nearest) < 1e-9 * square(*farthest);
}

std::array<double, 2> half_extent(const BodySettings& body) {
  std::vector<double> x, y;
  for (const OutlinePoint& one : outline_of(body)->trace()) {
    x.push_back(std::abs(one.at.x));
    y.push_back(std::abs(one.at.y));
  }
  return {greatest(x), greatest(y)};
}

bool covers(const BodySettings& body, const std::array<double, 2>& point) {
  return outline_of(body)->distance({point[0] - body.centre[0], point[1] - body.centre[1]}) <= 0;
}

}  // namespace vortree::body

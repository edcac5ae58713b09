#include "body/extent.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "body/outlines/greatest.hpp"
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

PanelLimits panel_limits_of(const BodySettings& body) {
  return PanelLimits(*outline_of(body));
}

bool round(const BodySettings& body) {
  const std::vector<OutlinePoint> all = outline_of(body)->trace();
  const auto [nearest, farthest] = std::ranges::minmax_element(all, {}, square_of);
  return square_of(*farthest) - square_of(*nearest) < 1e-9 * square_of(*farthest);
}

std::array<double, 2> half_extent(const Shape& outline) {
  const std::vector<OutlinePoint> all = outline.trace();
  return {greatest(outline, all, [](Vec2 at) { return std::abs(at.x); }),
          greatest(outline, all, [](Vec2 at) { return std::abs(at.y); })};
}

std::array<double, 2> half_extent(const BodySettings& body) {
  return half_extent(*outline_of(body));
}

double farthest_of(const Shape& outline) {
  return std::sqrt(greatest(outline, outline.trace(), square));
}

bool covers(const BodySettings& body, const std::array<double, 2>& point) {
  return outline_of(body)->distance({point[0] - body.centre[0], point[1] - body.centre[1]}) <= 0;
}

}  // namespace vortree::body

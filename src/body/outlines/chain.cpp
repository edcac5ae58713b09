#include "body/outlines/chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::body {

Stretch line(Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  return {[=](double share) {
            return CurvePoint{from + share * way, way, {}};
          },
          std::sqrt(dot(way, way)), 0};
}

std::unique_ptr<Shape> chained(const std::vector<Stretch>& stretches, const Placement& place) {
  double length = 0, turns = 0;
  for (const Stretch& one : stretches) length += one.length, turns += one.turns;
  std::vector<double> ends{0};
  for (const Stretch& one : stretches)
    ends.push_back(ends.back() + std::numbers::pi * (one.length / length + one.turns / turns));
  const auto curve = [&](double t) {
    const auto above = std::ranges::upper_bound(ends, t) - ends.begin();
    const std::size_t i = std::clamp<std::size_t>(above, 1, stretches.size()) - 1;
    const double rate = 1 / (ends[i + 1] - ends[i]);
    const CurvePoint c = stretches[i].at(rate * (t - ends[i]));
    return place({c.at, rate * c.first, (rate * rate) * c.second});
  };
  return outline(curve, {ends.begin() + 1, ends.end() - 1});
}

}  // namespace vortree::body

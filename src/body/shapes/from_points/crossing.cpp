#include "body/shapes/from_points/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vortree::body {
namespace {

double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// A side and the rectangle that it just fills.
struct PolygonSide {
  Vec2 from, to;

  bool apart(const PolygonSide& other) const {
    return std::max(from.x, to.x) < std::min(other.from.x, other.to.x) ||
           std::min(from.x, to.x) > std::max(other.from.x, other.to.x) ||
           std::max(from.y, to.y) < std::min(other.from.y, other.to.y) ||
           std::min(from.y, to.y) > std::max(other.from.y, other.to.y);
  }
  /// The ends of the other lie on both hands of this one's line, or on it.
  bool parts(const PolygonSide& other) const {
    const Vec2 way = to - from;
    return cross(way, other.from - from) * cross(way, other.to - from) <= 0;
  }
  bool meets(const PolygonSide& other) const {
    return !apart(other) && parts(other) && other.parts(*this);
  }
};

}  // namespace

std::optional<std::array<std::size_t, 2>> crossing_of(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  const auto side = [&](std::size_t i) { return PolygonSide{polygon[i], polygon[(i + 1) % n]}; };
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k + 1 == n) continue;
      if (side(i).meets(side(k))) return std::array{i, k};
    }
  return std::nullopt;
}

bool folds(const Shape& shape) {
  std::vector<Vec2> places;
  for (const OutlinePoint& one : shape.trace()) places.push_back(one.at);
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = places[(i + 1) % n] - places[i], b = places[(i + 2) % n] - places[(i + 1) % n];
    if (std::abs(std::atan2(cross(a, b), dot(a, b))) > 1) return true;
  }
  return crossing_of(places).has_value();
}

}  // namespace vortree::body

#include "sph/boundary/wall_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::sph {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

Vec2 normal_at(const body::Shape& shape, double arc) {
  return shape.nearest(shape.point(arc)).normal;
}

double turn(Vec2 from, Vec2 to) {
  return std::atan2(from.x * to.y - from.y * to.x, dot(from, to));
}

/// How far the normal has turned since the first point, at n + 1 places of even steps of the arc.
std::vector<double> turning(const body::Shape& shape, int n) {
  std::vector<double> turned(static_cast<std::size_t>(n) + 1, 0);
  Vec2 before = normal_at(shape, 0);
  for (int k = 1; k <= n; ++k) {
    const Vec2 now = normal_at(shape, k * shape.perimeter() / n);
    turned[k] = turned[k - 1] + turn(before, now);
    before = now;
  }
  turned[n] = whole_turn;
  return turned;
}

/// The arc of the outline at which arc(s) is `wanted`: by halving, as a sharp edge may turn the
/// normal by half a circle between two places.
double outline_arc(const body::Shape& shape, const std::vector<double>& turned, double d,
                   double wanted) {
  constexpr int halvings = 30;
  const double step = shape.perimeter() / static_cast<double>(turned.size() - 1);
  const auto arc = [&](std::size_t k) { return static_cast<double>(k) * step + d * turned[k]; };
  std::size_t first = 0, last = turned.size() - 1;
  while (last - first > 1) {
    const std::size_t middle = (first + last) / 2;
    (arc(middle) <= wanted ? first : last) = middle;
  }
  double low = static_cast<double>(first) * step, high = low + step;
  const Vec2 normal = normal_at(shape, low);
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    const double theta = turned[first] + turn(normal, normal_at(shape, middle));
    (middle + d * theta <= wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

double area_of(const body::Shape& shape) {
  constexpr int n = 4096;
  double twice = 0;
  Vec2 before = shape.point(0);
  for (int k = 1; k <= n; ++k) {
    const Vec2 now = shape.point(k * shape.perimeter() / n);
    twice += before.x * now.y - before.y * now.x;
    before = now;
  }
  return twice / 2;
}

std::vector<BoundaryNode> wall_nodes(const body::Shape& shape, int n) {
  std::vector<BoundaryNode> nodes;
  const double spacing = shape.perimeter() / n;
  for (int i = 0; i < n; ++i) {
    const double arc = (i + 0.5) * spacing;
    nodes.push_back({shape.point(arc), normal_at(shape, arc), spacing});
  }
  return nodes;
}

std::vector<BoundaryNode> ring_nodes(const body::Shape& shape, double d, double spacing,
                                     bool shifted) {
  const double length = shape.perimeter() + whole_turn * d;
  const int n = std::max(3, static_cast<int>(std::lround(length / spacing)));
  const std::vector<double> turned = turning(shape, 16 * n);
  std::vector<BoundaryNode> nodes;
  for (int i = 0; i < n; ++i) {
    const double arc = outline_arc(shape, turned, d, (i + (shifted ? 0.5 : 0)) * length / n);
    const Vec2 normal = normal_at(shape, arc), at = shape.point(arc) + d * normal;
    if (shape.distance(at) > 0.95 * d) nodes.push_back({at, normal, length / n});
  }
  return nodes;
}

}  // namespace vortree::sph

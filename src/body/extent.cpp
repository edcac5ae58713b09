#include "body/extent.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vortree::body {

double length_of(const BodySettings& body) {
  return body.chord.value_or(2 * body.radius.value_or(0));
}

double perimeter_of(const BodySettings& body) {
  if (body.shape == ShapeKind::naca0012) return 2.05 * length_of(body);
  const double a = *body.radius, b = body.across.value_or(a);
  // Ramanujan's second formula: within 4e-4 of any ellipse's.
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  return std::numbers::pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
}

double edge_of(const BodySettings& body) {
  return body.edge.value_or(0.005);
}

double tip_radius(const BodySettings& body) {
  if (body.shape == ShapeKind::naca0012) return edge_of(body) * length_of(body);
  const double a = *body.radius, b = body.across.value_or(a);
  return std::min(a * a / b, b * b / a);
}

bool covers(const BodySettings& body, const Pair& point) {
  const double x = point[0] - body.centre[0], y = point[1] - body.centre[1];
  const double turned = body.incidence * std::numbers::pi / 180;
  const double along = std::cos(turned) * x - std::sin(turned) * y,
               across = std::sin(turned) * x + std::cos(turned) * y;
  const bool foil = body.shape == ShapeKind::naca0012;
  const double a = foil ? 0.45 * *body.chord : *body.radius,
               b = foil ? 0.04 * *body.chord : body.across.value_or(a);
  return std::hypot(along / a, across / b) < 1;
}

Pair half_extent(const BodySettings& body) {
  const double turned = body.incidence * std::numbers::pi / 180;
  const double c = std::abs(std::cos(turned)), s = std::abs(std::sin(turned));
  if (body.shape == ShapeKind::naca0012) {
    const double along = 0.5 * *body.chord, across = 0.065 * *body.chord;
    return {c * along + s * across, s * along + c * across};
  }
  const double along = *body.radius, across = body.across.value_or(along);
  return {std::hypot(c * along, s * across), std::hypot(s * along, c * across)};
}

}  // namespace vortree::body

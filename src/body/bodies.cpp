#include "body/bodies.hpp"

#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "body/outline.hpp"

namespace vortree::body {

Motion motion_of(const std::optional<PlungeSettings>& plunge,
                 const std::optional<MotionSettings>& motion) {
  Motion of;
  if (plunge) {
    const auto [x, y] = plunge->direction;
    of.plunge = {plunge->amplitude * ((1 / std::hypot(x, y)) * Vec2{x, y}), plunge->frequency};
  }
  if (motion) of.spin = {motion->spin};
  return of;
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  const double incidence = body.incidence * std::numbers::pi / 180;
  if (body.shape == ShapeKind::ellipse) return ellipse({}, *body.radius, *body.across, incidence);
  if (body.shape == ShapeKind::naca0012) return naca0012({}, *body.chord, edge_of(body), incidence);
  return circle({}, *body.radius);
}

}  // namespace vortree::body

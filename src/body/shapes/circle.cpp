#include "body/shapes/circle.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/angle_kernel.hpp"
#include "body/shapes/shapes.hpp"
#include "tree/base/told.hpp"

namespace vortree::body {
namespace {

class Circle final : public Shape {
 public:
  Circle(Vec2 centre, double radius) : centre_(centre), radius_(radius) {}

  double perimeter() const override { return 2 * std::numbers::pi * radius_; }

  Vec2 point(double arc) const override {
    const double theta = arc / radius_;
    return {centre_.x + radius_ * std::cos(theta), centre_.y + radius_ * std::sin(theta)};
  }

  WallPoint nearest(Vec2 at) const override {
    const Vec2 d = at - centre_;
    const double r = std::sqrt(dot(d, d));
    double theta = angle_of(fill(d.y), fill(d.x))[0];
    if (theta < 0) theta += 2 * std::numbers::pi;
    const Vec2 normal = r > 0 ? (1 / r) * d : Vec2{1, 0};
    return {theta * radius_, r - radius_, normal, 1 / radius_};
  }

  double distance(Vec2 at) const override {
    const Vec2 d = at - centre_;
    return std::sqrt(dot(d, d)) - radius_;
  }

  bool beyond(Vec2 at, double distance) const override {
    const Vec2 d = at - centre_;
    const double r = radius_ + distance;
    return dot(d, d) > r * r;
  }

 private:
  Vec2 centre_;
  double radius_;
};

double length(const BodySettings& body) {
  return 2 * body.number("radius");
}

std::unique_ptr<Shape> draw(const BodySettings& body) {
  return circle({}, body.number("radius"));
}

}  // namespace

const ShapeKind& circle_kind() {
  static const ShapeKind kind{{"circle", {{"radius", positive, "L", "its radius"}}}, length, draw};
  return kind;
}

std::unique_ptr<Shape> circle(Vec2 centre, double radius) {
  if (!(radius > 0 && std::isfinite(radius)))
    throw std::invalid_argument("radius of the circle is " + tree::told(radius) + "; must be > 0");
  return std::make_unique<Circle>(centre, radius);
}

}  // namespace vortree::body

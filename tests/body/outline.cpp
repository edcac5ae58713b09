#include "body/outline.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "vortex/flows.hpp"
#include "vortex/wall/wall.hpp"

using namespace vortree;

TEST_CASE("an ellipse of equal axes is a circle: arc, distance, normal, curvature") {
  const auto circle = body::circle({0.2, -0.1}, 0.5);
  const auto round = body::ellipse({0.2, -0.1}, 0.5, 0.5, 0);
  CHECK(round->perimeter() == Approx(circle->perimeter()).epsilon(1e-13));
  bench::Uniform uniform(5);
  for (int k = 0; k < 300; ++k) {
    const Vec2 at{0.2 + 2 * (uniform() - 0.5), -0.1 + 2 * (uniform() - 0.5)};
    const auto a = circle->nearest(at), b = round->nearest(at);
    CHECK(b.arc == Approx(a.arc).margin(1e-11));
    CHECK(b.distance == Approx(a.distance).margin(1e-13));
    CHECK(round->distance(at) == Approx(a.distance).margin(1e-13));
    CHECK(dot(a.normal, b.normal) == Approx(1).epsilon(1e-13));
    CHECK(b.curvature == Approx(2).epsilon(1e-11));
    const Vec2 p = circle->point(a.arc), q = round->point(a.arc);
    CHECK(std::hypot(p.x - q.x, p.y - q.y) < 1e-12);
  }
}

TEST_CASE("the nearest place of an ellipse is the foot of a normal, and no place is nearer") {
  const double a = 0.5, b = 0.1, turn = 0.3;
  const auto shape = body::ellipse({}, a, b, turn);
  bench::Uniform uniform(9);
  for (int k = 0; k < 300; ++k) {
    const Vec2 at{1.6 * (uniform() - 0.5), 1.2 * (uniform() - 0.5)};
    // In the ellipse's own axes.
    const double x = at.x * std::cos(turn) - at.y * std::sin(turn),
                 y = at.x * std::sin(turn) + at.y * std::cos(turn);
    const bool inside = x * x / (a * a) + y * y / (b * b) < 1;
    const auto w = shape->nearest(at);
    CHECK((w.distance < 0) == inside);
    const Vec2 foot = at - w.distance * w.normal, there = shape->point(w.arc);
    CHECK(std::hypot(foot.x - there.x, foot.y - there.y) < 1e-9);
    double least = INFINITY;
    for (int i = 0; i < 2000; ++i) {
      const Vec2 d = at - shape->point(shape->perimeter() * i / 2000);
      least = std::min(least, std::hypot(d.x, d.y));
    }
    CHECK(std::abs(w.distance) <= least + 1e-12);
  }
}

TEST_CASE("what is plainly beyond a distance from a wall is farther than that from it") {
  const auto circle = body::circle({0.1, 0.2}, 0.4);
  const auto ellipse = body::ellipse({0.1, 0.2}, 0.5, 0.1, 0.3);
  bench::Uniform uniform(13);
  int told = 0, beyond = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vec2 at{4 * (uniform() - 0.5), 4 * (uniform() - 0.5)};
    const double d = uniform();
    for (const auto& shape : {circle.get(), ellipse.get()}) {
      told += shape->beyond(at, d);
      beyond += shape->distance(at) > d;
      if (shape->beyond(at, d)) CHECK(shape->distance(at) > d - 1e-14);
    }
  }
  CHECK(told > 0.8 * beyond);
}

TEST_CASE("the sheet of a stream past an ellipse is that of potential flow") {
  // Slip along the wall of an ellipse in a stream along its long axis, at the parameter t:
  // (a + b) U sin t/sqrt(a^2 sin^2 t + b^2 cos^2 t), backwards on the upper side.
  const double a = 0.5, b = 0.25;
  const vortex::Wall wall(body::ellipse({}, a, b, 0), 200);
  const auto slip = wall.slip({1, 0}, vortex::Velocities(2 * wall.panels()), {}, {});
  const auto sheet = wall.sheet(slip, 0);
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const Vec2 at = wall.middle(i);
    const double t = std::atan2(at.y / b, at.x / a);
    const double exact = -(a + b) * std::sin(t) / std::hypot(a * std::sin(t), b * std::cos(t));
    CHECK(sheet[i] == Approx(exact).margin(2e-4));
  }
}

#include "body/outlines/outline.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"
#include "body/shapes/plate.hpp"
#include "body/shapes/polygon.hpp"
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

namespace {

/// Of a wall point that is asked for beside a place of a curve, the largest errors.
struct Errors {
  double distance = 0, normal = 0, curvature = 0;
};

/// Beside 2000 places of an ellipse, on either side as far as half the radius of curvature there.
Errors errors_of_ellipse(double a, double b) {
  const auto shape = body::ellipse({}, a, b, 0);
  bench::Uniform uniform(31);
  Errors worst;
  for (int k = 0; k < 2000; ++k) {
    const double t = 2 * std::numbers::pi * uniform(), c = std::cos(t), s = std::sin(t);
    const double root = std::hypot(a * s, b * c), bend = a * b / (root * root * root);
    const Vec2 normal{b * c / root, a * s / root};
    const double off = (uniform() - 0.5) * std::min(1 / bend, 0.5 * b * b / a);
    const auto found = shape->nearest(Vec2{a * c, b * s} + off * normal);
    worst.distance = std::max(worst.distance, std::abs(found.distance - off));
    worst.normal =
        std::max(worst.normal, std::hypot(found.normal.x - normal.x, found.normal.y - normal.y));
    worst.curvature = std::max(worst.curvature, std::abs(found.curvature / bend - 1));
  }
  return worst;
}

}  // namespace

TEST_CASE("distance, normal and curvature are the formula's but for round-off: of ellipses") {
  // A place on a curve is rounded to 1e-16 of the size of the body; its direction so by that times
  // the curvature there, 1/radius = a/b^2 at most, and curvature by a few times as much, as it
  // changes over such a length.
  const double a = 0.5;
  for (const double b : {0.5, 0.25, 0.1, 0.02}) {
    const Errors worst = errors_of_ellipse(a, b);
    const double place = 4e-16, direction = place * a / (b * b);
    CAPTURE(b, worst.distance, worst.normal, worst.curvature);
    CHECK(worst.distance < place);
    CHECK(worst.normal < 4 * direction + 1e-15);
    CHECK(worst.curvature < 1e-12 + 20 * direction);
  }
}

TEST_CASE("a body that is thinner than places along it are apart has two sides") {
  for (const double thickness : {1e-2, 1e-3, 1e-4}) {
    const auto plate = body::plate({}, 1, thickness, 0);
    bench::Uniform uniform(8);
    for (int k = 0; k < 2000; ++k) {
      const double x = 0.9 * (uniform() - 0.5), off = thickness * uniform(),
                   side = uniform() < 0.5 ? -1 : 1;
      const auto found = plate->nearest({x, side * (thickness / 2 + off)});
      CHECK(found.distance == Approx(off).margin(1e-15));
      CHECK(found.normal.y == Approx(side).epsilon(1e-14));
    }
  }
}

TEST_CASE("no place of a trace is nearer than the nearest, of any shape, from anywhere") {
  const auto foil = body::naca0012({}, 1, 1e-4, 0.2), ellipse = body::ellipse({}, 0.5, 0.005, 0.3),
             square = body::polygon({}, 4, 0.5, 0.02, 0.1), plate = body::plate({}, 1, 0.01, -0.2);
  bench::Uniform uniform(77);
  for (const auto* shape : {&foil, &ellipse, &square, &plate}) {
    const auto trace = (*shape)->trace();
    for (int k = 0; k < 3000; ++k) {
      const Vec2 at{1.4 * (uniform() - 0.5), 1.4 * (uniform() - 0.5)};
      const auto found = (*shape)->nearest(at);
      for (const auto& one : trace) {
        const Vec2 d = at - one.at;
        if (std::hypot(d.x, d.y) < std::abs(found.distance) - 1e-14)
          FAIL("(" << at.x << ", " << at.y << ") is nearer to (" << one.at.x << ", " << one.at.y
                   << ")");
      }
      CHECK((*shape)->distance(at) == Approx(found.distance).margin(1e-15));
      const Vec2 foot = at - found.distance * found.normal, there = (*shape)->point(found.arc);
      CHECK(std::hypot(foot.x - there.x, foot.y - there.y) < 1e-13);
    }
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
  const auto foil = body::naca0012({0.1, 0.2}, 1, 0.005, 0.2);
  bench::Uniform uniform(13);
  int told = 0, beyond = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec2 at{4 * (uniform() - 0.5), 4 * (uniform() - 0.5)};
    const double d = uniform();
    for (const auto& shape : {circle.get(), ellipse.get(), foil.get()}) {
      told += shape->beyond(at, d);
      beyond += shape->distance(at) > d;
      if (shape->beyond(at, d)) CHECK(shape->distance(at) > d - 1e-14);
    }
  }
  CHECK(told > 0.97 * beyond);
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

TEST_CASE("panels of 0.7 radii of its ends see how a stream turns around a plate") {
  // At an angle, so that the flow turns around both ends; between them against much finer panels.
  const double thickness = 0.02;
  const auto sheet_in_middle = [&](int panels) {
    const vortex::Wall wall(body::plate({}, 1, thickness, 0), panels);
    const auto sheet =
        wall.sheet(wall.slip({0.8, 0.6}, vortex::Velocities(2 * wall.panels()), {}, {}), 0);
    // The first panel begins at the tip in x: a quarter of the way round is the middle of a side.
    return (sheet[panels / 4] + sheet[panels / 4 - 1]) / 2;
  };
  const auto plate = body::plate({}, 1, thickness, 0);
  const double radius = 1 / plate->nearest({1, 0}).curvature;
  const int panels = 4 * static_cast<int>(std::ceil(plate->perimeter() / (0.7 * radius) / 4));
  CHECK(sheet_in_middle(panels) == Approx(sheet_in_middle(3 * panels)).margin(5e-4));
}

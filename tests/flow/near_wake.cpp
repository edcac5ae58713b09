#include "flow/near_wake.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"

using namespace vortree;

namespace {

/// Middles of n equal pieces of an outline.
std::vector<Vec2> around(const body::Shape& shape, int n) {
  std::vector<Vec2> places;
  for (int i = 0; i < n; ++i) places.push_back(shape.point((i + 0.5) * shape.perimeter() / n));
  return places;
}

/// The velocity a (s - length) along a line's direction, s the distance from the wall.
double bubble_of_straight_line(double a, double length) {
  const auto shape = body::circle({0.3, -0.2}, 0.5);
  const flow::WakeLine line = flow::wake_line(around(*shape, 200), *shape, {3, 4});
  std::vector<double> u(line.x.size()), v(line.x.size());
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const double s = std::hypot(line.x[k] - 0.3, line.y[k] + 0.2) - 0.5;
    u[k] = 0.6 * a * (s - length) - 0.8;  // and something across
    v[k] = 0.8 * a * (s - length) + 0.6;
  }
  return flow::bubble_length(line, u, v);
}

/// Separation of the wall vorticity given by the polar angle, in degrees from the rear.
double separation_of(int panels, auto vorticity) {
  const std::vector<Vec2> wall = around(*body::circle({0.3, -0.2}, 0.5), panels);
  std::vector<double> values;
  for (const Vec2 place : wall) {
    const Vec2 d = place - Vec2{0.3, -0.2};
    values.push_back(vorticity(std::atan2(d.y, d.x)));
  }
  return flow::separation_angle(values, wall, {2, 0});
}

constexpr double degree = std::numbers::pi / 180;

/// Attached flow from the front to the angle `from`, reversed behind.
double reversed_behind(double theta, double from) {
  return std::sin(theta) * (std::cos(theta) - std::cos(from));
}

}  // namespace

TEST_CASE("separation is where the wall vorticity changes its sign, to the square of a panel") {
  for (double from : {22.3, 45.0, 71.9, 88.8})
    CHECK(separation_of(500, [&](double theta) { return reversed_behind(theta, from * degree); }) ==
          Approx(from).margin(0.01));
  CHECK(separation_of(500, [](double theta) { return -std::sin(theta); }) == 0);
}

TEST_CASE("a speck of reversed flow, shorter than three panels, is no separation") {
  const auto with_speck = [](double theta) {
    const bool there = std::abs(std::abs(theta) - 100 * degree) < 0.7 * degree;
    return there ? std::copysign(0.1, theta) : reversed_behind(theta, 70 * degree);
  };
  CHECK(separation_of(500, with_speck) == Approx(70).margin(0.01));
  CHECK(separation_of(500, [](double theta) {
          return std::abs(theta) < 0.7 * degree ? std::copysign(0.1, theta) : -std::sin(theta);
        }) == 0);
}

TEST_CASE("of two places where the wall vorticity turns, separation is the one met first") {
  CHECK(separation_of(500, [](double theta) {
          const double c = std::cos(theta);
          return std::sin(theta) * (c - std::cos(75 * degree)) * (c - std::cos(45 * degree)) *
                 (c - std::cos(30 * degree));
        }) == Approx(75).margin(0.01));
}

TEST_CASE("the closed wake ends where the velocity along the stream turns forward") {
  for (double length : {0.01, 0.37, 5.0})
    CHECK(bubble_of_straight_line(2, length) == Approx(length).epsilon(1e-9));
}

TEST_CASE("without a turn from back to forward no wake is closed") {
  CHECK(bubble_of_straight_line(2, -0.1) == 0);
  CHECK(bubble_of_straight_line(-2, 0.5) == 0);
  CHECK(flow::bubble_length({}, {}, {}) == 0);
}

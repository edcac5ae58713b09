#include "flow/paths/lyapunov.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "flow/paths/pictures_of.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

constexpr double pi = std::numbers::pi;

/// The double gyre of Shadden, Lekien & Marsden (2005), and its velocity gradient.
struct DoubleGyre {
  static constexpr double strength = 0.1, swing = 0.25, period = 10;

  static std::array<double, 3> shape(double x, double t) {  // f and two derivatives
    const double a = swing * std::sin(2 * pi * t / period), b = 1 - 2 * a;
    return {a * x * x + b * x, 2 * a * x + b, 2 * a};
  }
  static Vec2 velocity(Vec2 at, double t) {
    const auto [f, f1, f2] = shape(at.x, t);
    return {-pi * strength * std::sin(pi * f) * std::cos(pi * at.y),
            pi * strength * std::cos(pi * f) * std::sin(pi * at.y) * f1};
  }
  static std::array<double, 4> gradient(Vec2 at, double t) {
    const auto [f, f1, f2] = shape(at.x, t);
    const double s = std::sin(pi * f), c = std::cos(pi * f), sy = std::sin(pi * at.y),
                 cy = std::cos(pi * at.y), a = pi * strength;
    return {-a * pi * c * f1 * cy, a * pi * s * sy, a * sy * (c * f2 - pi * s * f1 * f1),
            a * pi * c * f1 * cy};
  }
};

/// lambda by another path: place and gradient of the flow map, d F/dt = grad u F, by small midpoint
/// steps of the velocity itself.
double exponent_of_gyre(Vec2 at, double from, double to) {
  struct State {
    Vec2 x;
    std::array<double, 4> f;
  };
  const auto rate = [](const State& s, double t) {
    const auto g = DoubleGyre::gradient(s.x, t);
    const auto& f = s.f;
    return State{DoubleGyre::velocity(s.x, t),
                 {g[0] * f[0] + g[1] * f[2], g[0] * f[1] + g[1] * f[3], g[2] * f[0] + g[3] * f[2],
                  g[2] * f[1] + g[3] * f[3]}};
  };
  const auto moved = [](State s, const State& by, double dt) {
    s.x += dt * by.x;
    for (int i = 0; i < 4; ++i) s.f[i] += dt * by.f[i];
    return s;
  };
  const int steps = 20000;
  const double dt = (to - from) / steps;
  State s{at, {1, 0, 0, 1}};
  for (int k = 0; k < steps; ++k) {
    const double t = from + k * dt;
    s = moved(s, rate(moved(s, rate(s, t), dt / 2), t + dt / 2), dt);
  }
  // The larger singular value.
  const auto [a, b, c, d] = s.f;
  const double sum = std::hypot(a + d, b - c), difference = std::hypot(a - d, b + c);
  return std::log((sum + difference) / 2) / std::abs(to - from);
}

/// The largest error over some places, by pictures so coarse in space and time.
double error_of_gyre(int per_length, double interval, double from, double to) {
  const double h = 1.0 / per_length;
  const flow::PictureGrid grid{{-0.2, -0.2},
                               h,
                               static_cast<int>(std::lround(2.4 / h)) + 1,
                               static_cast<int>(std::lround(1.4 / h)) + 1};
  const int count = static_cast<int>(std::lround(10 / interval)) + 1;
  const auto pictures = pictures_of(grid, interval, count, DoubleGyre::velocity);
  const flow::PictureGrid tracers{{0.1, 0.13}, 0.3, 7, 3};
  const auto found = flow::lyapunov(pictures, {grid, {}}, tracers, 1e-5, from, to);
  double most = 0;
  for (int row = 0; row < tracers.rows; ++row)
    for (int column = 0; column < tracers.columns; ++column) {
      const double exact = exponent_of_gyre(tracers.point(row, column), from, to);
      most = std::max(most, std::abs(found.exponent[row * tracers.columns + column] - exact));
    }
  return most;
}

}  // namespace

TEST_CASE("in strained flow the exponent is the rate of strain, forward and backward") {
  const auto grid = square(21, 2, {-1, -1});
  const double rate = 0.7;
  const auto pictures = pictures_of(grid, 0.25, 9, [&](Vec2 at, double) {
    return rate * Vec2{at.x, -at.y};
  });
  const flow::PictureGrid middle{{-0.1, -0.1}, 0.05, 5, 5};
  for (const auto& [from, to] : {std::pair{0.1, 1.9}, std::pair{1.9, 0.1}}) {
    const auto found = flow::lyapunov(pictures, {grid, {}}, middle, 0.005, from, to);
    CHECK(found.from == from);
    CHECK(found.to == to);
    REQUIRE(found.exponent.size() == 25);
    // RK4: (rate dt)^5/120 a step, dt = 0.1.
    for (const double one : found.exponent) CHECK(one == Approx(rate).epsilon(1e-6));
  }
}

TEST_CASE("in solid rotation nothing is drawn apart") {
  const auto grid = square(21, 2, {-1, -1});
  const auto pictures = pictures_of(grid, 0.25, 17, [](Vec2 at, double) {
    return 3 * Vec2{-at.y, at.x};
  });
  const flow::PictureGrid middle{{-0.4, -0.4}, 0.2, 5, 5};
  const auto found = flow::lyapunov(pictures, {grid, {}}, middle, 0.02, 0, 4);
  // RK4 loses z^6/144 of the length in a step of z rad: 176 steps of 0.068, over 4.
  for (const double one : found.exponent) CHECK(std::abs(one) < 4e-8);
}

TEST_CASE("exponents of the double gyre are those of the equation for the gradient of the map") {
  const double forward = error_of_gyre(80, 0.125, 0, 9.3), back = error_of_gyre(80, 0.125, 9.3, 0);
  CAPTURE(forward, back);
  // Exponents are up to 0.3; a gradient stretched by e^3 carries the errors of pictures with it.
  CHECK(forward < 1e-4);
  CHECK(back < 1e-4);
}

TEST_CASE("exponents converge with pictures finer in space, and in time") {
  const double coarse = error_of_gyre(20, 0.125, 0, 8), fine = error_of_gyre(40, 0.125, 0, 8);
  CAPTURE(coarse, fine);
  CHECK(halved(coarse, fine) > 2.5);  // gradients are of an order less than velocities
  const double rare = error_of_gyre(80, 1.0, 0, 8), often = error_of_gyre(80, 0.5, 0, 8);
  CAPTURE(rare, often);
  CHECK(halved(rare, often) > 3.0);
}

TEST_CASE("where a tracer leaves the window the exponent is not known, and elsewhere it is") {
  const auto grid = square(41, 4, {-2, -2});
  const auto pictures = pictures_of(grid, 0.25, 9, [](Vec2, double) { return Vec2{1, 0}; });
  const auto found = flow::lyapunov(pictures, {grid, {}}, grid, 0.01, 2, 0.5);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2 at = grid.point(row, column);
      const bool known = at.x - 0.01 - 1.5 > -2 && at.x < 1.995 && std::abs(at.y) < 1.995;
      CAPTURE(at.x, at.y);
      CHECK(std::isnan(found.exponent[row * grid.columns + column]) == !known);
    }
  CHECK_THROWS_WITH(flow::lyapunov(pictures, {grid, {}}, grid, 0.01, 1, 1),
                    Catch::Contains("t = 1"));
}

TEST_CASE("tracers fill the window, whatever their spacing") {
  const flow::PictureGrid window{{-1, 0}, 0.1, 31, 11};
  const auto same = flow::tracers_within(window, 0.1), fine = flow::tracers_within(window, 0.05),
             odd = flow::tracers_within(window, 0.7);
  CHECK((same.columns == 31 && same.rows == 11));
  CHECK((fine.columns == 61 && fine.rows == 21));
  CHECK((odd.columns == 5 && odd.rows == 2));
}

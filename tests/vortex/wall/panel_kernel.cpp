#include "vortex/wall/panel_kernel.hpp"

#include <catch2/catch.hpp>

#include "vortex/flows.hpp"

using namespace vortree;
namespace panel = vortree::vortex::panel;

TEST_CASE("the angle of a vector is that of atan2, in every direction and of every size") {
  bench::Uniform uniform(17);
  for (int k = 0; k < 4000; ++k) {
    Lanes x, y;
    for (int lane = 0; lane < lane_count; ++lane) {
      const double phi = std::numbers::pi * (2 * uniform() - 1);
      const double size = std::pow(10, 20 * (uniform() - 0.5));
      x[lane] = size * std::cos(phi);
      y[lane] = size * std::sin(phi) * std::pow(10, k % 4 == 0 ? -12 * uniform() : 0);
    }
    const Lanes angle = angle_of(y, x);
    for (int lane = 0; lane < lane_count; ++lane)
      CHECK(std::abs(angle[lane] - std::atan2(y[lane], x[lane])) <= 5e-16);
  }
  const double along[][2] = {{0, 0}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}, {1, 1}, {-1, 1}, {-1, -1}};
  for (const auto& [y, x] : along)
    CHECK(angle_of(fill(y), fill(x))[0] == Approx(std::atan2(y, x)).epsilon(1e-15));
}

TEST_CASE("a vortex does not move its own place") {
  const Vec2 at{0.3, 0.4};
  CHECK((panel::point_velocity(at, at).x == 0 && panel::point_velocity(at, at).y == 0));
  const panel::Vectors u = panel::point_velocities(at, {fill(0.3), fill(0.4)});
  CHECK((u.x[0] == 0 && u.y[0] == 0));
}

TEST_CASE("a panel's angle and velocity are the same in vectors and alone") {
  bench::Uniform uniform(19);
  const auto place = [&] { return Vec2{uniform() - 0.5, uniform() - 0.5}; };
  const auto all = [](Vec2 a) { return panel::Vectors{fill(a.x), fill(a.y)}; };
  for (int k = 0; k < 1000; ++k) {
    const Vec2 at = place(), a = place(), b = place(), d = b - a;
    const Vec2 chord = (1 / std::sqrt(dot(d, d))) * d;
    CHECK(panel::angles(at, all(a), all(b))[0] == Approx(panel::angle(at, a, b)).epsilon(1e-14));
    const Vec2 u = panel::velocity(at, a, b), w = panel::point_velocity(at, a);
    const panel::Vectors many = panel::velocities(at, all(a), all(b), all(chord)),
                         points = panel::point_velocities(at, all(a));
    CHECK(many.x[0] == Approx(u.x).margin(1e-14));
    CHECK(many.y[0] == Approx(u.y).margin(1e-14));
    CHECK(points.x[0] == Approx(w.x).epsilon(1e-14));
    CHECK(points.y[0] == Approx(w.y).epsilon(1e-14));
  }
}

TEST_CASE("the stream function of a panel is the mean of that of vortices, alone and in vectors") {
  bench::Uniform uniform(29);
  const auto place = [&] { return Vec2{uniform() - 0.5, uniform() - 0.5}; };
  const auto all = [](Vec2 a) { return panel::Vectors{fill(a.x), fill(a.y)}; };
  for (int k = 0; k < 200; ++k) {
    const Vec2 a = place(), b = place(), at = k % 2 ? place() : place() + Vec2{2, 0};
    const double one = panel::stream_function(at, a, b);
    CHECK(panel::stream_functions(at, all(a), all(b))[0] == Approx(one).margin(1e-13));
    CHECK(panel::point_stream_functions(at, all(a))[0] ==
          Approx(-panel::inverse_two_pi * std::log(std::sqrt(dot(at - a, at - a)))).margin(1e-14));
    if (k % 2) continue;
    constexpr int n = 200;  // Simpson's rule, of a panel that is not near
    double mean = 0;
    for (int j = 0; j <= n; ++j) {
      const Vec2 d = at - a - (j / double{n}) * (b - a);
      mean += (j == 0 || j == n ? 1 : j % 2 ? 4 : 2) / (3.0 * n) * std::log(std::sqrt(dot(d, d)));
    }
    CHECK(one == Approx(-panel::inverse_two_pi * mean).margin(1e-11));
  }
}

TEST_CASE("the stream function of a panel is finite on it, also at its ends") {
  const auto all = [](Vec2 a) { return panel::Vectors{fill(a.x), fill(a.y)}; };
  const Vec2 a{1, 2},
      b{1.5, 2};  // the mean of ln s from an end is ln L - 1, in the middle ln L/2 - 1
  for (const Vec2 at : {a, b, Vec2{1.25, 2}}) {
    const double mean = std::log(at.x == 1.25 ? 0.25 : 0.5) - 1;
    CHECK(panel::stream_function(at, a, b) == Approx(-panel::inverse_two_pi * mean).epsilon(1e-14));
    CHECK(panel::stream_functions(at, all(a), all(b))[0] ==
          Approx(-panel::inverse_two_pi * mean).epsilon(1e-14));
  }
  CHECK(panel::point_stream_functions(a, all(a))[0] == 0);
}

TEST_CASE("what three points see of a panel is the same in vectors, alone, and by each point") {
  bench::Uniform uniform(23);
  const auto place = [&] { return Vec2{uniform() - 0.5, 0.3 * uniform()}; };
  for (int k = 0; k < 1000; ++k) {
    const Vec2 at = place() + Vec2{0, 0.4}, a{uniform() - 0.5, 0}, b{uniform() - 0.5, 0};
    const vortex::ThreePoints points({uniform() / 20, uniform() / 20 - 0.025},
                                     {0, at.y, {0, 1}, 0});
    const auto aside = [&](Vec2 end) { return panel::angle_aside(at, points, end); };
    const auto all = [](Vec2 z) { return panel::Vectors{fill(z.x), fill(z.y)}; };
    CHECK(panel::angles_aside(at, points, all(a))[0] == Approx(aside(a)).margin(1e-14));
    const auto arm = std::sqrt(std::complex(points.arm_squared.re, points.arm_squared.im));
    const Vec2 out{arm.real(), arm.imag()};
    const double seen =
        (1 - points.outer) * panel::angle(at, a, b) +
        points.outer / 2 * (panel::angle(at + out, a, b) + panel::angle(at - out, a, b));
    CHECK(panel::angle(at, a, b) + aside(b) - aside(a) == Approx(seen).margin(1e-13));
  }
}
